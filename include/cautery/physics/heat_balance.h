// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/coupling.h>
#include <cautery/physics/heat.h>

namespace Cautery
{
  /**
   * The books of heat over a run, all in J (per metre in two dimensions).
   */
  struct HeatTotals
  {
    double sources    = 0.; ///< put in by the sources
    double metabolism = 0.; ///< made by the tissue
    double stored     = 0.; ///< int rho C (T - T(0))
    double blood      = 0.; ///< carried away
    double boundary   = 0.; ///< lost through surfaces
    double expansion  = 0.; ///< consumed by the change of volume (two-way coupling)
    double adaption   = 0.; ///< made where merged cells cannot hold the temperature that their parts had

    HeatTotals &operator+=(const HeatTotals &other);

    double error() const { return sources + metabolism + adaption - stored - blood - boundary - expansion; }
    /** The error over all heat that was moved. */
    double relative_error() const;

    void archive(Archive &archive);
  };

  /**
   * Keeps the books: integrates over time what each step moved, and takes the heat through surfaces of
   * prescribed temperature from the balance of their own nodes. With backward Euler they close to the
   * tolerance of the linear solver; with IDA to the accuracy of its steps.
   *
   * In the non-Fourier model heat flows as k grad Y with tau Y' + Y = T and Y = T at the start (where k
   * changes: what is conducted off, K_c T in W per node, is relaxed in the place of T), besides what else
   * flowed then and dies out with tau: a body at rest (dT/dt = 0) that makes heat must carry it away.
   * Where tau differs between tissues this holds away from their interfaces only.
   */
  template <int dim>
  class HeatBalance
  {
  public:
    /** How temperature is integrated over a step: by its value at the end (backward Euler), or by the mean of
     * both ends. */
    enum class Rule
    {
      end_of_step,
      trapezoid
    };

    /** @p feedback: of two-way coupling, else nullptr. */
    HeatBalance(Heat<dim>                        &heat,
                const ThermoelasticFeedback<dim> *feedback,
                const State                      &start,
                const Rule                        rule);

    /**
     * Goes on with the books of another mesh, on which the last state was @p last. Collective.
     */
    void go_on(HeatBalance &before, const State &last, const State &start);

    /** Books the step that has just brought the state to @p now. */
    void record(const Step &step, const State &now);

    /** The books up to @p now, the state of the last recorded step. */
    HeatTotals totals(const State &now);

    void archive(Archive &archive);

  private:
    double heat_content(const State &state, const double base);
    Vector conducted(const Vector &temperature) const;
    void   relax(const double dt, const Vector &temperature);
    void   lend(const double dt);
    void   flush(const State &now);
    void   flush_delayed();

    Heat<dim>                        &heat;
    const ThermoelasticFeedback<dim> *feedback;
    const Rule                        rule;

    HeatTotals                        past; ///< of earlier meshes
    typename HeatLoads<dim>::Received received;
    Vector                            delivered; ///< heat from outside, J per node
    Vector left; ///< delivered + own - stored - conducted, J per node: what surfaces took
    double stored     = 0.;
    double blood      = 0.;
    double surfaces   = 0.; ///< by convection
    double metabolism = 0.;
    double expansion  = 0.;
    double first      = 0.; ///< by the first flux
    double lent       = 0.; ///< from the surroundings, by the limiter of temperatures
    Vector lending;         ///< its power, W per node

    // since the last flush
    double since = 0.;           ///< time of the last flush, s
    Vector last_temperature;     ///< of the last step, K; trapezoid only
    Vector temperature_then;     ///< K
    Vector displacement_then;    ///< m
    Vector temperature_integral; ///< int T dt, K s
    Vector first_flux;           ///< what is left of the first flux, W per node; non-Fourier only
    Vector delayed;              ///< Y, or what is conducted off with the lag: see above; non-Fourier only
    Vector delayed_integral;     ///< of it, over time
    Vector last_conducted;       ///< W per node, of the last step; trapezoid with a K that changes only
  };
} // namespace Cautery
