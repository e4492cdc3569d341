// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/output/fields.h>
#include <cautery/output/reactions.h>
#include <cautery/problems/audience.h>

#include <deal.II/base/mpi.h>

namespace Cautery
{
  template <int dim>
  Audience<dim>::Audience(const Scene &scene, const Body<dim> &body, Cost &cost)
    : scene(scene)
    , body(&body)
    , cost(cost)
    , probes(std::make_unique<Probes<dim>>(scene.output.probes(), body.locator, body.nodes))
  {
    if (scene.effects.has_damage())
      ablation = std::make_unique<AblationZone<dim>>(scene.output.ablation_centre, body.nodes);
  }

  template <int dim>
  void Audience<dim>::write_to(const std::string &directory)
  {
    const bool writes = Utilities::MPI::this_mpi_process(body->mesh.communicator()) == 0;
    if (writes)
      probes->write_to(directory + "/probes.csv");
    if (scene.output.reactions)
      {
        auto reactions = std::make_unique<Reactions<dim>>(scene, body->nodes, body->boundaries);
        if (writes)
          reactions->write_to(directory + "/reactions.csv");
        others.push_back(std::move(reactions));
      }
    if (scene.output.fields)
      others.push_back(std::make_unique<Fields<dim>>(directory, writes));
  }

  template <int dim>
  void Audience<dim>::look(const State &state, Problem<dim> &problem)
  {
    std::optional<Vector> unbalanced;
    if (scene.output.reactions)
      {
        const auto scope = cost.measure("deformation: reactions");
        unbalanced       = problem.unbalanced_forces(state);
      }
    look(state, problem, unbalanced);
  }

  template <int dim>
  void Audience<dim>::look(const BorneLoad &borne, Problem<dim> &problem)
  {
    look(borne.state, problem, borne.unbalanced_forces);
  }

  template <int dim>
  void Audience<dim>::look(const State &state, Problem<dim> &problem, const std::optional<Vector> &unbalanced)
  {
    follow(state);
    std::optional<MechanicalFields<dim>> mechanical;
    if (problem.displacement() != nullptr)
      {
        const auto scope = cost.measure("deformation: strain and stress");
        mechanical       = problem.mechanical_fields(state);
      }
    std::optional<GradientErrors> errors; // as dear as a step or two: where it is seen only
    if (scene.output.fields || state.time >= scene.time.end)
      {
        const auto scope = cost.measure("output: error indicator");
        errors           = gradient_errors(body->nodes, body->tissues, problem.displacement(), state);
        observe(*errors, space_errors);
      }
    const Snapshot<dim> snapshot{state,
                                 body->nodes,
                                 problem.displacement(),
                                 mechanical ? &*mechanical : nullptr,
                                 unbalanced ? &*unbalanced : nullptr,
                                 errors ? &*errors : nullptr};
    for (auto *observer : all())
      {
        const auto scope = cost.measure(observer->name());
        observer->observe(snapshot);
      }
  }

  template <int dim>
  void Audience<dim>::use(const Body<dim> &next)
  {
    body = &next;
    for (auto *observer : all())
      observer->use_mesh(next.nodes, next.locator, next.boundaries);
  }

  template <int dim>
  double Audience<dim>::hottest_now() const
  {
    return extremes.reduced(body->mesh.communicator()).hottest_now;
  }

  template <int dim>
  void Audience<dim>::archive(Archive &archive)
  {
    Extremes so_far = extremes.reduced(body->mesh.communicator());
    archive.section("extremes", [&]() { so_far.archive(archive); });
    extremes = so_far;
    archive.section("errors in space", [&]() {
      const auto field = [&](const std::string &name) {
        archive.shared(name + ", last", space_errors[name].last);
        archive.shared(name + ", largest", space_errors[name].largest);
      };
      if (scene.effects.has_heat())
        field("temperature");
      if (scene.effects.has_deformation())
        field("displacement");
    });
  }

  template <int dim>
  void Audience<dim>::archive_files(Archive &archive)
  {
    probes->archive(archive);
    for (auto &observer : others)
      observer->archive(archive);
  }

  template <int dim>
  void Audience<dim>::tell(RunRecord &record) const
  {
    record.extremes     = extremes.reduced(body->mesh.communicator());
    record.space_errors = space_errors;
    if (ablation)
      record.ablation = ablated();
  }

  template <int dim>
  RunRecord::Ablation Audience<dim>::ablated() const
  {
    RunRecord::Ablation zone;
    zone.volume = ablation->volume();
    zone.radius = ablation->radius();
    zone.centre = scene.output.ablation_centre;
    for (const auto &[id, volume] : ablation->volumes())
      zone.regions[std::to_string(id)] = {
        body->mesh.regions().at(id), volume, volume / body->mesh.volumes().at(id)};
    return zone;
  }

  template <int dim>
  std::vector<Observer<dim> *> Audience<dim>::all() const
  {
    std::vector<Observer<dim> *> result = {probes.get()};
    if (ablation)
      result.push_back(ablation.get());
    for (const auto &observer : others)
      result.push_back(observer.get());
    return result;
  }

  template class Audience<2>;
  template class Audience<3>;
} // namespace Cautery
