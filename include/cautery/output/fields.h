// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/output/observer.h>

#include <deal.II/numerics/data_out.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * solution.pvd and a .vtu file for each output time: what is on, the regions, the errors of gradients in
   * each cell, and the displacement as a vector.
   */
  template <int dim>
  class Fields : public Observer<dim>
  {
  public:
    Fields(const std::string &directory, const bool indexes) : directory(directory), indexes(indexes) {}

    std::string name() const override { return "output: fields"; }
    void        observe(const Snapshot<dim> &snapshot) override;
    void        archive(Archive &archive) override;

  private:
    void        write(const DataOut<dim> &data, const std::string &file, const MPI_Comm communicator) const;
    void        write_index() const;
    std::string file_name(const unsigned int number) const;

    const std::string   directory;
    const bool          indexes; ///< process 0 does
    std::vector<double> times;   ///< of what is written, s
  };
} // namespace Cautery
