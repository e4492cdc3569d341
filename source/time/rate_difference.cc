// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/rate_difference.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  void RateDifference::record(const Step &step, const Vector &rate, const Balance &balance)
  {
    ++waiting;
    if (last_rate.size() > 0 && !balance.jumps_within(last.from, step.to))
      {
        const double dt = step.length();
        balance.elimination().copy_constrained(rate, last_rate); // prescribed values do not err
        double              difference = 0.;
        const double *const now        = rate.begin();
        const double *const before     = last_rate.begin();
        for (unsigned int i = 0, n = rate.locally_owned_size(); i < n; ++i)
          difference = std::max(difference, std::abs(now[i] - before[i]));
        difference = Utilities::MPI::max(difference, rate.get_mpi_communicator());
        sums.add(dt * dt / (dt + last.length()) * difference, waiting);
        waiting = 0;
      }
    last_rate = rate;
    last      = step;
  }

  void RateDifference::archive(Archive &archive, const Vector &like)
  {
    bool started = last_rate.size() > 0;
    archive.shared("has a last rate", started);
    if (archive.restores() && started)
      last_rate.reinit(like);
    archive.nodal("last rate", last_rate);
    archive.shared("last step from", last.from);
    archive.shared("last step to", last.to);
    archive.shared("steps that wait for an estimate", waiting);
    sums.archive(archive);
  }
} // namespace Cautery
