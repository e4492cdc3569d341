// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/balance.h>
#include <cautery/physics/heat_cell.h>
#include <cautery/physics/heat_loads.h>
#include <cautery/physics/prescribed.h>
#include <cautery/physics/stopped_perfusion.h>
#include <cautery/physics/temperature_limiter.h>

#include <memory>

namespace Cautery
{
  /** For Prescribed: the temperature that @p boundary prescribes, or nullptr. */
  const Expression *prescribed_temperature(const Boundary &boundary, const unsigned int component);

  /** At the nodes at t = 0, in K. */
  template <int dim>
  Vector initial_temperature(const Scene &scene, const Field<dim> &nodes);

  /**
   * The balance of heat (thesis Eqs. 4-22 and 6-8) without its coupling to deformation:
   * M = int tau rho C N N, C = int (rho C + tau w) N N, K = int k grad N grad N + int w N N,
   * with w = C_b omega_b, and for convection h in the place of w on surfaces. tau = 0 is Fourier's: no M.
   */
  template <int dim>
  class Heat : public Balance
  {
  public:
    Heat(const Scene             &scene,
         const Field<dim>        &field,
         const TissueMap<dim>    &tissues,
         const BoundaryMap<dim>  &boundaries,
         const PointLocator<dim> &locator);

    std::string              name() const override { return "heat"; }
    const ConstrainedMatrix *inertia() const override { return non_fourier ? &relaxation : nullptr; }
    const ConstrainedMatrix *damping() const override { return &storage; }
    const ConstrainedMatrix &stiffness() const override { return conduction; }
    const ConstrainedMatrix *damping_excess() const override
    {
      return properties_change ? &storage_excess : nullptr;
    }
    const ConstrainedMatrix *inertia_excess() const override
    {
      return properties_change && non_fourier ? &relaxation_excess : nullptr;
    }
    Vector State::*unknown() const override { return &State::temperature; }
    Vector State::*rate() const override { return non_fourier ? &State::temperature_rate : nullptr; }

    const Elimination &elimination() const override { return eliminated; }
    bool               prescription_changes() const override { return prescribed.depends_on_time(); }
    void               prescribe(const double time, Vector &x) const override { prescribed.set(time, x); }
    void               load(const Step &step, const State &state, Vector &force) const override;
    bool               jumps_within(const double from, const double to) const override
    {
      return outside.jumps_within(from, to);
    }
    bool changes() const override
    {
      return properties_change || stopped != nullptr || scene.effects.metabolism == Effects::Metabolism::q10;
    }
    bool refresh(const State &state, const Vector &x) override;
    void limit(const Step &step, const State &state, const SparseMatrix &system, Vector &rate) override;
    const LinearSolverSettings &solver_settings() const override { return scene.numerics.heat_solver; }
    const IndexSet             &kept_unknowns() const override { return kept; }
    unsigned int                n_components() const override { return 1; }
    std::vector<Vector>         near_null_space() const override;

    /** @p state is that of the archive already. Collective where it brings back. */
    void archive(Archive &archive, const State &state);

    /** F and tau dF/dt at one time, see HeatLoads::add_at. */
    void load_at(const double time, const double within, Vector &force) const;

    HeatLoads<dim>        &loads() { return outside; }
    const HeatLoads<dim>  &loads() const { return outside; }
    const Prescribed<dim> &prescribed_temperatures() const { return prescribed; }
    const Field<dim>      &nodes() const { return field; }
    bool                   relaxes() const { return non_fourier; }

    /**
     * What the books of heat need besides. All per node: `blood` and `surface` weights in W/K, sources in W,
     * tau in s; `capacity` and `exchange` as matrices, of the non-Fourier model only (else they are C and a
     * part of K).
     */
    struct Bookkeeping
    {
      Vector       blood_weights;   ///< int w N
      Vector       surface_weights; ///< int h N
      Vector       blood_source;    ///< int w T_b N
      Vector       metabolism;      ///< int Q_met N
      Vector       delay;           ///< tau
      SparseMatrix capacity;        ///< int rho C N N
      SparseMatrix exchange;        ///< int w N N + int h N N
    };
    const Bookkeeping &books() const { return bookkeeping; }

    /** Does a limiter keep temperatures above the coldest data? Then what it gave to the nodes in the last
     * step, in W, on the right-hand side of the balance. */
    bool          is_limited() const { return limiter != nullptr; }
    const Vector &lent() const { return lent_by_limiter; }

  private:
    void   initialize_matrices();
    void   initialize_books();
    void   assemble(const Vector *before, const Vector *now, const Vector *ln_damage);
    void   distribute(const double tau, HeatCellTerms<dim> &terms);
    void   distribute_metabolism(const double tau, HeatCellTerms<dim> &terms);
    void   assemble_metabolism(const Vector &temperature_before, const Vector &temperature_now);
    void   finish();
    double coldest_data(const Step &step) const;

    const Scene              &scene;
    const Field<dim>         &field;
    const TissueMap<dim>     &tissues;
    const BoundaryMap<dim>   &boundaries;
    const bool                non_fourier;
    const bool                properties_change;
    Prescribed<dim>           prescribed;
    AffineConstraints<double> fixed;
    Elimination               eliminated;
    const IndexSet            kept;
    AffineConstraints<double> nothing_fixed;
    HeatLoads<dim>            outside;
    ConstrainedMatrix         relaxation;        ///< M
    ConstrainedMatrix         relaxation_excess; ///< with properties that change only
    ConstrainedMatrix         storage;           ///< C
    ConstrainedMatrix         storage_excess;    ///< with properties that change only
    ConstrainedMatrix         conduction;        ///< K
    Vector                    inside; ///< int (w T_b + Q_met) N and, where Q_met changes, tau dQ_met/dt; W
    Bookkeeping               bookkeeping;
    bool                      assembled = false;
    std::unique_ptr<TemperatureLimiter>    limiter;
    Vector                                 lent_by_limiter;    ///< W
    double                                 coldest_start = 0.; ///< K
    std::unique_ptr<StoppedPerfusion<dim>> stopped; ///< where it stops in dead tissue, else nullptr
  };
} // namespace Cautery
