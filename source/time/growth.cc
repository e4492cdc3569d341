// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/parameters.h>
#include <cautery/time/growth.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

namespace Cautery
{
  namespace
  {
    constexpr double hot = 1e5; ///< K

    /// How far a node is beyond what may be, and where it was in the undeformed body, m.
    struct Worst
    {
      double   excess = 0.;
      Point<3> place;
    };

    /// The worst of all processes.
    Worst of_all(const Worst &own, const MPI_Comm communicator)
    {
      const auto of = Utilities::MPI::min_max_avg(own.excess, communicator);
      return {of.max, Utilities::MPI::broadcast(communicator, own.place, of.max_index)};
    }

    std::string at(const Worst &worst, const double time)
    {
      return " at t = " + to_short_text(time) + " s at the node " + to_short_text(worst.place) + " m; ";
    }
  } // namespace

  template <typename Number>
  void check_growth(const TledNodes<Number>                   &nodes,
                    const typename TledNodes<Number>::Records &values,
                    const double                               far,
                    const double                               time)
  {
    Worst      moved, heated;
    const auto look = [](Worst &worst, const double number, const double limit, const Point<3> &place) {
      // what is not a number is as bad as can be
      const double excess =
        std::isfinite(number) ? std::abs(number) / limit : std::numeric_limits<double>::max();
      if (excess > worst.excess)
        worst = {excess, place};
    };
    for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
      {
        const auto *record = &values[node_record * node];
        for (unsigned int c = 0; c < 3; ++c)
          look(moved, record[c], far, nodes.places()[node]);
        look(heated, record[3], hot, nodes.places()[node]);
      }
    moved  = of_all(moved, nodes.communicator());
    heated = of_all(heated, nodes.communicator());
    AssertThrow(heated.excess < 1.,
                ExcRun("the temperature grows without bounds" + at(heated, time) +
                       "take Numerics/Explicit/Heat step = 0, or a lower Safety factor"));
    AssertThrow(moved.excess < 1.,
                ExcRun("the motion grows without bounds" + at(moved, time) +
                       "take Numerics/Explicit/Motion step = 0, a lower Safety factor, or damping"));
  }

  template void
  check_growth(const TledNodes<float> &, const TledNodes<float>::Records &, const double, const double);
  template void
  check_growth(const TledNodes<double> &, const TledNodes<double>::Records &, const double, const double);
} // namespace Cautery
