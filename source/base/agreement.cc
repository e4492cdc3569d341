// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/agreement.h>
#include <cautery/base/parameters.h>

#include <deal.II/base/timer.h>

#include <chrono>
#include <thread>

namespace Cautery
{
  bool all_processes_come(const MPI_Comm communicator, const double patience)
  {
    MPI_Request request;
    MPI_Ibarrier(communicator, &request);
    const Timer timer;
    int         all_here = 0;
    while (all_here == 0 && timer.wall_time() < patience)
      {
        MPI_Test(&request, &all_here, MPI_STATUS_IGNORE);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    return all_here != 0;
  }

  void fail_together(const MPI_Comm communicator, const std::function<void()> &work)
  {
    const unsigned int me     = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int nobody = Utilities::MPI::n_mpi_processes(communicator);
    unsigned int       failed = nobody;
    bool               input  = false;
    std::string        reason;
    try
      {
        work();
      }
    catch (const ExcInput &exception)
      {
        failed = me;
        input  = true;
        reason = message_of(exception);
      }
    catch (const ExcRun &exception)
      {
        failed = me;
        reason = message_of(exception);
      }
    const unsigned int first = Utilities::MPI::min(failed, communicator);
    if (first == nobody)
      return;
    input  = Utilities::MPI::broadcast(communicator, input, first);
    reason = Utilities::MPI::broadcast(communicator, reason, first);
    AssertThrow(!input, ExcInput(reason));
    AssertThrow(false, ExcRun(reason));
  }
} // namespace Cautery
