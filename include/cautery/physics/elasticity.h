// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/balance.h>
#include <cautery/physics/coupling.h>
#include <cautery/physics/outer_load.h>
#include <cautery/physics/supports.h>

#include <memory>

namespace Cautery
{
  /**
   * The balance of momentum of a linear thermoelastic body (thesis Eqs. 4-23 to 4-25): M = int rho N N
   * (inertia only), K from the elastic stress, loads by gravity, tractions, forces at points and thermal
   * expansion.
   */
  template <int dim>
  class Elasticity : public Balance
  {
  public:
    /** @p displacement is the vector field on the nodes of @p nodes. */
    Elasticity(const Scene             &scene,
               const Field<dim>        &displacement,
               const Field<dim>        &nodes,
               const TissueMap<dim>    &tissues,
               const BoundaryMap<dim>  &boundaries,
               const PointLocator<dim> &locator);

    std::string              name() const override { return "deformation"; }
    const ConstrainedMatrix *inertia() const override { return has_inertia ? &mass : nullptr; }
    const ConstrainedMatrix *damping() const override { return nullptr; }
    const ConstrainedMatrix &stiffness() const override { return elastic; }
    Vector State::*unknown() const override { return &State::displacement; }
    Vector State::*rate() const override { return keeps_rate ? &State::displacement_rate : nullptr; }

    const Elimination &elimination() const override { return supports.elimination(); }
    void               prescribe(const double time, Vector &x) const override { supports.prescribe(time, x); }
    bool               prescription_changes() const override { return supports.prescription_changes(); }
    void               load(const Step &step, const State &state, Vector &force) const override;
    bool               changes() const override { return properties_change; }
    bool               depends_on_iterate() const override { return false; }
    bool               refresh(const State &state, const Vector &x) override;
    const LinearSolverSettings &solver_settings() const override { return scene.numerics.deformation_solver; }
    const IndexSet             &kept_unknowns() const override { return kept; }
    unsigned int                n_components() const override { return dim; }
    std::vector<Vector>         near_null_space() const override;

    /** The load at @p time alone, for equilibrium; the thermal part is that of @p state's temperature. */
    void load_at(const double time, const State &state, Vector &force) const;

    /** Inner less outer forces without inertia, N per unknown, where the scene has reactions written. */
    Vector unbalanced_forces(const State &state) const;

    const Field<dim> &field() const { return displacement; }
    /** The linear thermal expansion; nullptr where it is off or not linear. */
    const ThermalExpansionOperator<dim> *expansion() const { return expansion_operator.get(); }

  private:
    void initialize_matrices();
    /** Where the tissue has the @p temperature (with ghosts), or nullptr for its reference temperature. */
    void assemble_stiffness(const Vector *temperature);
    void assemble_mass();

    const Scene          &scene;
    const Field<dim>     &displacement;
    const Field<dim>     &nodes;
    const TissueMap<dim> &tissues;
    const bool            has_inertia;
    const bool            properties_change;
    const bool            keeps_rate; ///< inertia, or non-Fourier heat that feels the rate's change
    bool                  needs_full;

    const Supports<dim>                            supports;
    const OuterLoad<dim>                           outer_load;
    const IndexSet                                 kept;
    AffineConstraints<double>                      nothing_fixed;
    ConstrainedMatrix                              mass;
    ConstrainedMatrix                              elastic;
    Vector                                         thermal_load; ///< where properties change, N
    std::unique_ptr<ThermalExpansionOperator<dim>> expansion_operator;
  };
} // namespace Cautery
