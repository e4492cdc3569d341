// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

namespace Cautery
{
  using namespace dealii;

  /**
   * Do all processes of @p communicator come here within @p patience (s)? To be asked where a failure has
   * been met: what comes next may need all of them, and a process that has failed alone would wait for ever,
   * as the others would for it. Where the answer is no, only MPI_Abort is left.
   */
  bool all_processes_come(const MPI_Comm communicator, const double patience = 3.);
} // namespace Cautery
