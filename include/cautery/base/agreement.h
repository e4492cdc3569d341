// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

#include <functional>

namespace Cautery
{
  using namespace dealii;

  /**
   * Do all processes of @p communicator come here within @p patience (s)? To be asked where a failure has
   * been met: what comes next may need all of them, and a process that has failed alone would wait for ever,
   * as the others would for it. Where the answer is no, only MPI_Abort is left.
   */
  bool all_processes_come(const MPI_Comm communicator, const double patience = 3.);

  /**
   * Calls @p work on every process, where it must not wait for others. If it throws ExcInput or ExcRun on one
   * of them, all throw that: so what process 0 alone writes or reads fails for all.
   */
  void fail_together(const MPI_Comm communicator, const std::function<void()> &work);
} // namespace Cautery
