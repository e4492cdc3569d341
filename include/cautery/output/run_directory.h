// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/scene.h>

#include <deal.II/base/mpi.h>

#include <string>

namespace Cautery
{
  /**
   * Makes @p directory, removes an earlier run's results from it, and writes the complete scene.prm there.
   * Collective. Errors: ExcInput where it cannot be written.
   */
  void prepare_directory(const std::string &directory, const Scene &scene, const MPI_Comm communicator);

  /**
   * A directory of its own that is removed with all that is in it, whatever happens.
   */
  class TemporaryDirectory
  {
  public:
    /** Collective. Errors: ExcInput. */
    explicit TemporaryDirectory(const MPI_Comm communicator);
    ~TemporaryDirectory();
    TemporaryDirectory(const TemporaryDirectory &)            = delete;
    TemporaryDirectory &operator=(const TemporaryDirectory &) = delete;

    const std::string &path() const { return name; }

  private:
    const bool  owned; ///< by this process
    std::string name;
  };
} // namespace Cautery
