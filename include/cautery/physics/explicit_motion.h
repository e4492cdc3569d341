// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/held_records.h>
#include <cautery/physics/outer_load.h>
#include <cautery/physics/supports.h>
#include <cautery/physics/tled_body.h>
#include <cautery/space/state.h>

namespace Cautery
{
  /**
   * What explicit dynamics needs at the nodes: masses, damping, supports and outer loads, in the records of
   * TledNodes. Its share of a record is the first three numbers.
   */
  template <typename Number>
  class ExplicitMotion
  {
  public:
    using Records = typename TledNodes<Number>::Records;

    /** Arguments must live as long as it. */
    ExplicitMotion(const TledBody<Number> &body,
                   TledNodes<Number>      &nodes,
                   const Supports<3>      &supports,
                   const OuterLoad<3>     &load);

    /** Of the process's own nodes, kg. */
    const std::vector<double> &masses() const { return mass; }

    /** Sets what NodeStep needs for a step of @p duration (s) with the @p damping (1/s) and the @p masses
     * (kg) of the process's own nodes. */
    void fill(const double               duration,
              const double               damping,
              const std::vector<double> &masses,
              Records                   &keep,
              Records                   &gain) const;

    /** The constant loads, without those along the normals of rollers; N. */
    void fill_loads(Records &loads) const;

    /** Subtracts the changing loads at @p time from @p forces, before they are collected. */
    void apply_changing_loads(const double time, Records &forces) const;

    /** Takes the part of collected @p forces that rollers bear. */
    void release_rollers(Records &forces) const;

    /** Sets @p rates so that the prescribed displacements are those of @p to after a step of @p duration. */
    void prescribe(const double to, const double duration, const Records &values, Records &rates)
    {
      held.set_rates(to, duration, 0., values, rates);
    }

    /** The kinetic energy of all processes, J. Collective. */
    double kinetic_energy(const Records &rates) const;

  private:
    struct Roller
    {
      std::uint32_t entry; ///< the first of the node's record
      Tensor<2, 3>  along; ///< projects onto the directions that are free
    };
    void find_held(const Supports<3> &supports);
    void find_rollers(const Supports<3> &supports, const IndexSet &own);

    TledNodes<Number>  &nodes;
    const OuterLoad<3> &load;
    std::vector<double> mass;
    HeldRecords<Number> held; ///< displacements
    std::vector<Roller> rollers;
  };

  /** Inner less outer forces at @p state, N per unknown of @p displacement. Collective. */
  template <typename Number>
  Vector unbalanced_forces(TledBody<Number>   &body,
                           TledNodes<Number>  &nodes,
                           const OuterLoad<3> &load,
                           const Field<3>     &displacement,
                           const State        &state);
} // namespace Cautery
