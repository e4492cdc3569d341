// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/safekeeper.h>

#include <deal.II/base/mpi.h>

namespace Cautery
{
  template <int dim>
  Safekeeper<dim>::Safekeeper(const std::string &directory,
                              const Scene       &scene,
                              const Body<dim>   &body,
                              Problem<dim>      &problem,
                              Cost              &cost)
    : settings(scene.output.checkpoints)
    , communicator(body.mesh.communicator())
    , seldom(scene.time.integrator == TimeSettings::Integrator::ida)
    , problem(&problem)
    , cost(cost)
    , file(directory, scene, body.nodes)
  {
  }

  template <int dim>
  void Safekeeper<dim>::use(const Body<dim> &body, Problem<dim> &next)
  {
    file.use(body.nodes);
    problem = &next;
  }

  /// Processes see signals and clocks differently: what one needs, all do.
  template <int dim>
  typename Safekeeper<dim>::Need Safekeeper<dim>::need(const State &state)
  {
    int result = nothing;
    if (settings.steps > 0 && state.step > 0 && state.step % settings.steps == 0)
      result = due;
    if (settings.minutes > 0. && clock.wall_time() > 60. * settings.minutes)
      result = due;
    const auto wish = interruption.wish();
    if (wish != Interruption::Wish::none)
      result = wish == Interruption::Wish::stop ? last : asked;
    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
      result = Utilities::MPI::max(result, communicator);
    return static_cast<Need>(result);
  }

  template <int dim>
  bool Safekeeper<dim>::look(const State &state, const Store &store)
  {
    const unsigned int steps = settings.steps_to_new_start();
    if (steps > 0 && state.step % steps == 0)
      problem->start_anew();
    const Need now = need(state);
    if (problem->can_be_archived() && (seldom || now != nothing))
      {
        latest = Archive();
        store(latest);
        latest_time = state.time;
        latest_step = state.step;
      }
    if (now != nothing)
      write(now);
    return now == last;
  }

  template <int dim>
  void Safekeeper<dim>::write(const Need reason)
  {
    if (reason == due && latest_step == written_step)
      return;
    const auto scope = cost.measure("output: checkpoint");
    file.write(latest);
    written_step = latest_step;
    clock.restart();
    if (!seldom)
      latest = Archive(); // it may be large
  }

  template class Safekeeper<2>;
  template class Safekeeper<3>;
} // namespace Cautery
