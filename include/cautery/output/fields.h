// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/output/observer.h>

#include <string>
#include <utility>
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
    explicit Fields(const std::string &directory) : directory(directory) {}

    std::string name() const override { return "output: fields"; }
    void        observe(const Snapshot<dim> &snapshot) override;

  private:
    void write_index(const MPI_Comm communicator) const;

    const std::string                           directory;
    std::vector<std::pair<double, std::string>> written; ///< times (s) and files
  };
} // namespace Cautery
