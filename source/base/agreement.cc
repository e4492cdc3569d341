// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/agreement.h>

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
} // namespace Cautery
