// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/explicit_motion.h>

#include <utility>

namespace Cautery
{
  namespace
  {
    constexpr unsigned int dim = 3;

    /**
     * The projector onto the displacements that the lines of a node allow: those spanned by the free
     * components, each with what follows from it.
     */
    Tensor<2, 3> allowed(const AffineConstraints<double> &lines, const types::global_dof_index first)
    {
      std::vector<Tensor<1, 3>> span;
      for (unsigned int free = 0; free < dim; ++free)
        {
          if (lines.is_constrained(first + free))
            continue;
          Tensor<1, 3> direction;
          direction[free] = 1.;
          for (unsigned int c = 0; c < dim; ++c)
            if (lines.is_constrained(first + c))
              for (const auto &[unknown, weight] : *lines.get_constraint_entries(first + c))
                if (unknown == first + free)
                  direction[c] = weight;
          for (const auto &other : span) // orthonormal by Gram and Schmidt
            direction -= (direction * other) * other;
          span.push_back(direction / direction.norm());
        }
      Tensor<2, 3> result;
      for (const auto &direction : span)
        result += outer_product(direction, direction);
      return result;
    }
  } // namespace

  template <typename Number>
  ExplicitMotion<Number>::ExplicitMotion(const TledBody<Number> &body,
                                         TledNodes<Number>      &nodes,
                                         const Supports<3>      &supports,
                                         const OuterLoad<3>     &load)
    : nodes(nodes), load(load), mass(nodes.sum(body.masses()))
  {
    find_held(supports);
    find_rollers(supports, load.steady().locally_owned_elements());
  }

  template <typename Number>
  void ExplicitMotion<Number>::find_held(const Supports<3> &supports)
  {
    std::vector<typename HeldRecords<Number>::Held> all;
    supports.prescribed_displacements().for_each_owned(
      [&](const types::global_dof_index unknown, const Expression &displacement, const Point<3> &place) {
        all.push_back({node_record * nodes.local(unknown / dim) + static_cast<std::uint32_t>(unknown % dim),
                       &displacement,
                       place});
      });
    held = HeldRecords<Number>(std::move(all));
  }

  template <typename Number>
  void ExplicitMotion<Number>::find_rollers(const Supports<3> &supports, const IndexSet &own)
  {
    const auto &lines = supports.constraints();
    for (types::global_dof_index first = 0; first < own.n_elements(); first += dim)
      {
        const auto unknown = own.nth_index_in_set(first);
        if (supports.prescribed_displacements().contains(unknown))
          continue;
        if (lines.is_constrained(unknown) || lines.is_constrained(unknown + 1) ||
            lines.is_constrained(unknown + 2))
          rollers.push_back({node_record * nodes.local(unknown / dim), allowed(lines, unknown)});
      }
  }

  template <typename Number>
  void ExplicitMotion<Number>::fill(const double               duration,
                                    const double               damping,
                                    const std::vector<double> &masses,
                                    Records                   &keep,
                                    Records                   &gain) const
  {
    for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double brake           = 0.5 * duration * damping;
          keep[node_record * node + c] = (1. - brake) / (1. + brake);
          gain[node_record * node + c] = duration / (masses[node] * (1. + brake));
        }
    held.keep_rates(keep, gain);
  }

  template <typename Number>
  void ExplicitMotion<Number>::fill_loads(Records &loads) const
  {
    const double *steady = load.steady().begin();
    for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        loads[node_record * node + c] = steady[dim * node + c];
    release_rollers(loads);
  }

  template <typename Number>
  void ExplicitMotion<Number>::apply_changing_loads(const double time, Records &forces) const
  {
    load.for_each_changing(time,
                           [this, &forces](const types::global_dof_index unknown, const Tensor<1, 3> &force) {
                             const std::uint32_t entry = node_record * nodes.local(unknown / dim);
                             for (unsigned int c = 0; c < dim; ++c)
                               forces[entry + c] -= force[c];
                           });
  }

  template <typename Number>
  void ExplicitMotion<Number>::release_rollers(Records &forces) const
  {
    for (const Roller &roller : rollers)
      {
        Tensor<1, 3> force;
        for (unsigned int c = 0; c < dim; ++c)
          force[c] = forces[roller.entry + c];
        force = roller.along * force;
        for (unsigned int c = 0; c < dim; ++c)
          forces[roller.entry + c] = force[c];
      }
  }

  template <typename Number>
  double ExplicitMotion<Number>::kinetic_energy(const Records &rates) const
  {
    double sum = 0.;
    for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        sum += 0.5 * mass[node] * rates[node_record * node + c] * rates[node_record * node + c];
    return Utilities::MPI::sum(sum, nodes.communicator());
  }

  template <typename Number>
  Vector unbalanced_forces(TledBody<Number>   &body,
                           TledNodes<Number>  &nodes,
                           const OuterLoad<3> &load,
                           const Field<3>     &displacement,
                           const State        &state)
  {
    auto values = nodes.zero(), forces = nodes.zero();
    for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
      {
        for (unsigned int c = 0; c < dim; ++c)
          values[node_record * node + c] = state.displacement.begin()[dim * node + c];
        if (state.temperature.size() > 0)
          values[node_record * node + dim] = state.temperature.begin()[node] - body.reference_temperature();
      }
    nodes.update(values);
    body.add_forces(TledBody<Number>::Part::motion, values, forces);
    nodes.collect(forces);
    Vector result = displacement.vector(), outer = displacement.vector();
    load.at(state.time, outer);
    for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        result.begin()[dim * node + c] = forces[node_record * node + c];
    result -= outer;
    return result;
  }

  template Vector unbalanced_forces(
    TledBody<float> &, TledNodes<float> &, const OuterLoad<3> &, const Field<3> &, const State &);
  template Vector unbalanced_forces(
    TledBody<double> &, TledNodes<double> &, const OuterLoad<3> &, const Field<3> &, const State &);

  template class ExplicitMotion<float>;
  template class ExplicitMotion<double>;
} // namespace Cautery
