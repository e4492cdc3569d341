// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/dynamic_relaxation.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  namespace
  {
    constexpr unsigned int dim = 3;
    /// Steps in which the loads come; where a cell is inverted, slower and slower.
    constexpr unsigned int first_gradual = 200, slower = 8, slowest = 200 * 8 * 8;
    constexpr unsigned int steps_to_renewal = 200, steps_to_damping = 5, steps_to_look = 10;
    /// Share of the stable step that is taken.
    constexpr double safety = 0.9;
  } // namespace

  DynamicRelaxation::DynamicRelaxation(const Scene        &scene,
                                       TledBody<double>   &body,
                                       TledNodes<double>  &nodes,
                                       const Supports<3>  &supports,
                                       const OuterLoad<3> &load,
                                       Cost               &cost)
    : settings(scene.numerics.relaxation)
    , outer_load(load)
    , expands(scene.effects.coupling != Effects::Coupling::off)
    , body(body)
    , nodes(nodes)
    , cost(cost)
    , motion(body, nodes, supports, load)
    , masses(nodes.sum(body.stiffnesses()))
    , critical(body, nodes, TledBody<double>::Part::motion, masses)
  {
    for (Records *records : {&values, &rates, &forces, &last_forces, &loads, &target_loads, &keep, &gain})
      *records = nodes.zero();
    for (std::size_t i = dim; i < keep.size(); i += node_record)
      keep[i] = 1.; // heat comes at a rate that is given
  }

  void DynamicRelaxation::solve(State &state)
  {
    const auto    scope       = cost.measure("deformation: relaxation");
    const Records rest_values = values, rest_loads = loads;
    Vector        acting = state.displacement;
    outer_load.at(state.time, acting);
    for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        target_loads[node_record * node + c] = acting.begin()[dim * node + c];
    motion.release_rollers(target_loads);

    Failure failure = relax(state, first_gradual);
    for (unsigned int n = slower * first_gradual; !failure.empty() && n <= slowest; n *= slower)
      {
        values  = rest_values;
        loads   = rest_loads;
        failure = relax(state, n);
      }
    if (!failure.empty())
      {
        values = rest_values;
        loads  = rest_loads;
        AssertThrow(false,
                    ExcRun("no equilibrium found at t = " + to_short_text(state.time) + " s: " + failure +
                           "; load the body less or in more output times, refine the mesh there, or choose "
                           "Numerics/Large equilibrium = Newton"));
      }
    double *displacement = state.displacement.begin();
    for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        displacement[dim * node + c] = values[node_record * node + c];
  }

  DynamicRelaxation::Failure DynamicRelaxation::relax(const State &state, const unsigned int n_gradual)
  {
    for (Records *records : {&rates, &forces, &last_forces})
      records->fill(0.);
    damping = 0.;
    largest = 0.;
    for (unsigned int i = 0; i < settings.max_steps; ++i)
      {
        if (i % steps_to_renewal == 0)
          renew_step();
        find_forces();
        if (const auto inverted = healthy ? std::nullopt : body.inverted(values); !healthy)
          return inverted ? inverted->message() : "a cell's deformation is not a number";
        if (i % steps_to_look == 0)
          look();
        if (i > n_gradual && left <= settings.tolerance)
          return {};
        if (i % steps_to_damping == 0)
          damp();
        last_forces = forces;
        approach(state, i < n_gradual ? n_gradual - i : 1);
        take_step();
      }
    return "after " + std::to_string(settings.max_steps) + " steps forces of " + to_short_text(left) +
           " of those that act are still left over";
  }

  void DynamicRelaxation::renew_step()
  {
    duration =
      std::min(safety, critical.steady_share()) * 2. / std::sqrt(critical.largest_eigenvalue(values));
    motion.fill(duration, damping, masses, keep, gain);
  }

  void DynamicRelaxation::find_forces()
  {
    healthy = body.add_forces(TledBody<double>::Part::motion, values, forces);
    healthy = Utilities::MPI::min(healthy ? 1 : 0, nodes.communicator()) == 1;
    nodes.collect(forces);
    motion.release_rollers(forces);
  }

  /** Finds the norm of what is left over at free nodes, relative to the largest of all forces so far: where
   * heat is free to stretch the body, none are left in the end. */
  void DynamicRelaxation::look()
  {
    double over = 0., acting = 0.;
    for (std::size_t i = 0; i < node_record * nodes.n_own(); ++i)
      if (i % node_record < dim)
        {
          acting += forces[i] * forces[i] + loads[i] * loads[i];
          if (gain[i] != 0.)
            over += (loads[i] - forces[i]) * (loads[i] - forces[i]);
        }
    over    = Utilities::MPI::sum(over, nodes.communicator());
    largest = std::max(largest, Utilities::MPI::sum(acting, nodes.communicator()));
    left    = largest > 0. ? std::sqrt(over / largest) : 0.;
  }

  /** Critical damping for the Rayleigh quotient of the last step's motion, by differences of its forces. */
  void DynamicRelaxation::damp()
  {
    double work = 0., inertia = 0.;
    for (std::size_t i = 0; i < node_record * nodes.n_own(); ++i)
      if (i % node_record < dim && gain[i] != 0.)
        {
          work += rates[i] * (forces[i] - last_forces[i]);
          inertia += masses[i / node_record] * rates[i] * rates[i];
        }
    work    = Utilities::MPI::sum(work, nodes.communicator());
    inertia = Utilities::MPI::sum(inertia, nodes.communicator());
    if (!(work > 0.))
      return;
    damping = std::min(2. * std::sqrt(work / (duration * inertia)), 1.6 / duration);
    motion.fill(duration, damping, masses, keep, gain);
  }

  /** Brings loads, prescribed displacements and heat nearer, so that they are there after @p n_left steps. */
  void DynamicRelaxation::approach(const State &state, const unsigned int n_left)
  {
    for (std::size_t i = 0; i < node_record * nodes.n_own(); ++i)
      loads[i] += (target_loads[i] - loads[i]) / n_left;
    motion.prescribe(state.time, n_left * duration, values, rates);
    if (expands)
      for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
        {
          const std::size_t i = node_record * node + dim;
          rates[i]            = (state.temperature.begin()[node] - body.reference_temperature() - values[i]) /
                     (n_left * duration);
        }
  }

  void DynamicRelaxation::take_step()
  {
    body.kernel().step(node_step(nodes.n_own(), values, rates, forces, loads, keep, gain, duration));
    nodes.update(values);
    ++n_steps;
  }

  void DynamicRelaxation::archive(Archive &archive, const State &)
  {
    archive.shared("steps", n_steps);
    archive.nodal("values", values.data(), node_record * nodes.n_own());
    archive.nodal("loads", loads.data(), node_record * nodes.n_own());
    if (archive.restores())
      nodes.update(values);
  }

  std::map<std::string, double> DynamicRelaxation::statistics() const
  {
    if (n_steps == 0)
      return {};
    return {{"relaxation_steps", n_steps}};
  }
} // namespace Cautery
