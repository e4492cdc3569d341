// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/explicit_heat.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace Cautery
{
  namespace
  {
    bool any_convection(const Scene &scene)
    {
      for (const auto &boundary : scene.boundaries)
        if (boundary.thermal == Boundary::Thermal::convection)
          return true;
      return false;
    }

    constexpr unsigned int heat = node_record - 1; ///< its place in a record
  }                                                // namespace

  template <typename Number>
  ExplicitHeat<Number>::ExplicitHeat(const Scene             &scene,
                                     const Field<3>          &field,
                                     const TissueMap<3>      &tissues,
                                     const BoundaryMap<3>    &boundaries,
                                     const PointLocator<3>   &locator,
                                     const TledBody<Number>  &body,
                                     const TledNodes<Number> &nodes)
    : scene(scene)
    , field(field)
    , tissues(tissues)
    , boundaries(boundaries)
    , non_fourier(scene.effects.heat == Effects::Heat::non_fourier)
    , exchanges(scene.effects.perfusion || any_convection(scene))
    , zero_temperature(body.reference_temperature())
    , prescribed(field, boundaries, prescribed_temperature)
    , outside(scene, field, tissues, boundaries, locator)
  {
    std::vector<typename HeldRecords<Number>::Held> all;
    prescribed.for_each_owned(
      [&](const types::global_dof_index node, const Expression &temperature, const Point<3> &place) {
        all.push_back({node_record * nodes.local(node) + heat, &temperature, place});
      });
    held = HeldRecords<Number>(std::move(all));
    for (auto *vector : {&capacity, &storage, &blood_weights, &surface_weights, &inside, &delivered})
      *vector = field.vector();
    if (non_fourier)
      {
        relaxation = field.vector();
        impulse    = field.vector();
        conducted  = field.vector();
        if (scene.effects.perfusion_stops_in_dead_tissue)
          delayed_blood = field.vector();
      }
    assemble(nullptr, nullptr, nullptr);
  }

  template <typename Number>
  void ExplicitHeat<Number>::assemble(const Vector *before, const Vector *now, const Vector *ln_damage)
  {
    const std::vector<Vector *> vectors = {
      &capacity, &relaxation, &storage, &blood_weights, &surface_weights, &inside, &impulse, &delayed_blood};
    for (Vector *vector : vectors)
      *vector = 0.;
    double                 blood_of_cells = 0., metabolism_of_cells = 0.;
    HeatCellTerms<3>       terms(scene, field);
    dealii::Vector<double> local(terms.dofs.size());
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const Tissue &tissue = tissues[cell->material_id()];
        const double  tau    = non_fourier ? tissue.thermal.relaxation_time : 0.;
        terms.reinit(cell, before, now, ln_damage);
        terms.add_volume(tissue);
        terms.add_metabolism(tissue);
        if (cell->at_boundary())
          terms.add_surfaces(cell, boundaries);
        terms.lump();
        const auto add = [&terms, &local](Vector &vector, const auto &value) {
          for (unsigned int i = 0; i < local.size(); ++i)
            local(i) = value(i);
          vector.add(terms.dofs, local);
        };
        add(capacity, [&](const unsigned int i) { return terms.capacity(i, i); });
        add(storage, [&](const unsigned int i) { return terms.capacity(i, i) + tau * terms.exchange(i, i); });
        add(inside, [&](const unsigned int i) { return terms.blood_source(i) + terms.metabolism(i); });
        blood_weights.add(terms.dofs, terms.blood_weights);
        surface_weights.add(terms.dofs, terms.surface_weights);
        blood_of_cells += std::accumulate(terms.blood_source.begin(), terms.blood_source.end(), 0.);
        metabolism_of_cells += std::accumulate(terms.metabolism.begin(), terms.metabolism.end(), 0.);
        if (non_fourier)
          {
            add(relaxation, [&](const unsigned int i) { return tau * terms.capacity(i, i); });
            add(impulse, [&](const unsigned int i) { return tau * terms.metabolism_growth(i); });
            if (scene.effects.perfusion_stops_in_dead_tissue)
              add(delayed_blood, [&](const unsigned int i) { return tau * terms.blood_source(i); });
          }
      }
    for (Vector *vector : vectors)
      vector->compress(VectorOperation::add);
    blood_source = Utilities::MPI::sum(blood_of_cells, field.communicator());
    metabolism   = Utilities::MPI::sum(metabolism_of_cells, field.communicator());
  }

  template <typename Number>
  void ExplicitHeat<Number>::start(const State &state)
  {
    start_temperature = state.temperature;
    last_temperature  = state.temperature;
    refresh(state);
    if (!non_fourier)
      return;
    // what a body at rest makes and takes up is carried away by a flux that dies out with tau
    conducted = inside;
    outside.add_last(state.time, conducted);
    for (std::uint32_t node = 0; node < conducted.locally_owned_size(); ++node)
      conducted.begin()[node] -=
        (blood_weights.begin()[node] + surface_weights.begin()[node]) * state.temperature.begin()[node];
    conducted *= -1.;
  }

  /** With blood and surroundings: int tau (w (T - T_b) + h T) N, J per node. */
  template <typename Number>
  Vector ExplicitHeat<Number>::delayed_exchange(const Vector &temperature) const
  {
    Vector result = storage;
    result -= capacity;
    result.scale(temperature);
    result -= delayed_blood;
    return result;
  }

  template <typename Number>
  bool ExplicitHeat<Number>::refresh(const State &state)
  {
    const bool grows    = scene.effects.metabolism == Effects::Metabolism::q10;
    const bool is_first = dead.ln_damage().size() == 0; // the constructor knew no damage
    const bool new_dead = scene.effects.perfusion_stops_in_dead_tissue && dead.update(state.ln_damage);
    if (!grows && !new_dead)
      return false;
    const bool   falls     = non_fourier && new_dead && !is_first; // see StoppedPerfusion
    Vector       fallen    = falls ? delayed_exchange(state.temperature) : Vector();
    const Vector before    = field.ghosted(last_temperature);
    const Vector now       = field.ghosted(state.temperature);
    const Vector ln_damage = scene.effects.has_damage() ? field.ghosted(state.ln_damage) : Vector();
    assemble(&before, &now, scene.effects.has_damage() ? &ln_damage : nullptr);
    if (falls)
      {
        fallen -= delayed_exchange(state.temperature);
        impulse += fallen;
      }
    last_temperature = state.temperature;
    return new_dead;
  }

  template <typename Number>
  void
  ExplicitHeat<Number>::fill(const double duration, Records &keep, Records &gain, Records &exchange) const
  {
    for (std::uint32_t node = 0; node < capacity.locally_owned_size(); ++node)
      {
        const double      e        = blood_weights.begin()[node] + surface_weights.begin()[node];
        const double      inertia  = non_fourier ? relaxation.begin()[node] / duration : 0.;
        const double      together = inertia + storage.begin()[node] + duration * e;
        const std::size_t entry    = node_record * node + heat;
        keep[entry]                = inertia / together;
        gain[entry]                = 1. / together;
        exchange[entry]            = e;
      }
    held.keep_rates(keep, gain);
  }

  template <typename Number>
  void ExplicitHeat<Number>::load(const Step &step, const Records &values, Records &loads)
  {
    Vector force = inside;
    if (non_fourier)
      {
        // all at once, as metabolism itself has changed
        force.add(1. / step.length(), impulse);
        impulse = 0.;
      }
    outside.add(step, force);
    for (std::uint32_t node = 0; node < force.locally_owned_size(); ++node)
      loads[node_record * node + heat] =
        force.begin()[node] -
        zero_temperature * (blood_weights.begin()[node] + surface_weights.begin()[node]);

    delivered = 0.;
    outside.record(step, false, delivered, received);
    delivered *= 1. / step.length();
    delivered += inside;
    sum_settled(values);
  }

  template <typename Number>
  void ExplicitHeat<Number>::prescribe(const Step    &step,
                                       const Records &values,
                                       const Records &flow,
                                       Records       &rates)
  {
    const std::size_t before = held.n_settled();
    held.set_rates(step.to, step.length(), zero_temperature, values, rates);
    if (held.n_settled() != before)
      sum_settled(values);

    double into_held = 0.;
    if (non_fourier)
      relax(step, flow);
    for (const auto &number : held.all())
      into_held += non_fourier ? conducted.begin()[number.entry / node_record] : -flow[number.entry];
    taken += step.length() * into_held;
  }

  /** The flux follows the @p flow late: tau (q - q_before) / dt + q = - flow. */
  template <typename Number>
  void ExplicitHeat<Number>::relax(const Step &step, const Records &flow)
  {
    double sum = 0.;
    for (std::uint32_t node = 0; node < conducted.locally_owned_size(); ++node)
      {
        const double r = relaxation.begin()[node] / (capacity.begin()[node] * step.length());
        double      &q = conducted.begin()[node];
        q              = (r * q - flow[node_record * node + heat]) / (r + 1.);
        sum += q;
      }
    first -= step.length() * sum;
  }

  /** By the load, less what blood and surroundings take where T - T_0 is @p heating; W. */
  template <typename Number>
  double ExplicitHeat<Number>::brought(const std::uint32_t node, const Number heating) const
  {
    return delivered.begin()[node] -
           (blood_weights.begin()[node] + surface_weights.begin()[node]) * (zero_temperature + heating);
  }

  template <typename Number>
  void ExplicitHeat<Number>::sum_settled(const Records &values)
  {
    settled = 0.;
    for (std::size_t i = 0; i < held.n_settled(); ++i)
      settled += brought(held.all()[i].entry / node_record, values[held.all()[i].entry]);
  }

  template <typename Number>
  void ExplicitHeat<Number>::record(const double duration, const Records &values, const Records &rates)
  {
    made += duration * metabolism;
    if (exchanges)
      {
        double to_blood = 0., to_surroundings = 0.;
        for (std::uint32_t node = 0; node < capacity.locally_owned_size(); ++node)
          {
            const double temperature = zero_temperature + values[node_record * node + heat];
            to_blood += blood_weights.begin()[node] * temperature;
            to_surroundings += surface_weights.begin()[node] * temperature;
          }
        blood += duration * to_blood;
        convected += duration * to_surroundings;
      }
    bled += duration * blood_source;
    taken += duration * settled;
    for (std::size_t i = held.n_settled(); i < held.all().size(); ++i)
      {
        const std::uint32_t entry = held.all()[i].entry;
        const std::uint32_t node  = entry / node_record;
        taken += duration * (brought(node, values[entry]) - capacity.begin()[node] * rates[entry]);
      }
  }

  template <typename Number>
  double ExplicitHeat<Number>::stable_step(const double rate) const
  {
    double tau = non_fourier ? std::numeric_limits<double>::max() : 0.;
    for (unsigned int t = 0; t < tissues.size(); ++t)
      tau = std::min(tau, tissues.tissue(t).thermal.relaxation_time);
    // |z| <= 1 for both roots of (z - 1) (m (z - 1) / dt + c z) + dt k z = 0 with k = rate c, m = tau c
    return (1. + std::sqrt(1. + 4. * tau * rate)) / rate;
  }

  template <typename Number>
  HeatTotals ExplicitHeat<Number>::totals(const State &state) const
  {
    const auto over_all = [this](const double own) { return Utilities::MPI::sum(own, field.communicator()); };
    Vector     change   = state.temperature;
    change -= start_temperature;
    HeatTotals result;
    result.sources    = received.sources;
    result.metabolism = made;
    result.stored     = change * capacity;
    result.blood      = over_all(blood) - bled;
    result.boundary   = over_all(convected + first + taken) - received.surfaces;
    return result;
  }

  template <typename Number>
  void ExplicitHeat<Number>::archive(Archive &archive, const State &state)
  {
    if (scene.effects.metabolism == Effects::Metabolism::q10)
      archive.nodal("last temperature", last_temperature);
    dead.archive(archive, state.temperature);
    if (archive.restores() && scene.effects.perfusion_stops_in_dead_tissue)
      {
        const Vector temperature = field.ghosted(state.temperature),
                     ln_damage   = field.ghosted(dead.ln_damage());
        assemble(&temperature, &temperature, &ln_damage);
      }
    std::vector<double> settled_nodes = {static_cast<double>(held.n_settled())};
    if (archive.own("settled nodes", settled_nodes))
      held.set_settled(static_cast<std::size_t>(settled_nodes.front()));

    outside.archive(archive);
    received.archive(archive);
    archive.nodal("start temperature", start_temperature);
    archive.nodal("conducted", conducted);
    archive.nodal("inside", inside);
    archive.nodal("impulse", impulse);
    archive.summed("lost to blood", blood);
    archive.shared("brought by blood", bled);
    archive.shared("made by metabolism", made);
    archive.summed("lost by convection", convected);
    archive.summed("taken by prescribed temperatures", taken);
    archive.summed("carried by the first flux", first);
  }

  template class ExplicitHeat<float>;
  template class ExplicitHeat<double>;
} // namespace Cautery
