// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/dead_nodes.h>
#include <cautery/physics/heat_balance.h>
#include <cautery/physics/held_records.h>
#include <cautery/physics/tled_body.h>

namespace Cautery
{
  /**
   * What explicit steps of heat need at the nodes, in the records of TledNodes: the balance of Heat with
   * lumped matrices, and its books. Its share of a record is the last number, the temperature above that of
   * TledBody::reference_temperature.
   *
   * A step finds the rate v from m (v - v_before) / dt + c v + e (T + dt v) = F - (flow of T), with m = int
   * tau rho C N, c = int (rho C + tau w) N and e = int w N, where w is that of Heat: conduction is explicit,
   * so only it bounds the step; m = 0 is Fourier's heat. A step of the thesis's central differences (Eq.
   * 7-51) has the mean of both rates in the place of v; then no step is stable as tau goes to 0.
   */
  template <typename Number>
  class ExplicitHeat
  {
  public:
    using Records = typename TledNodes<Number>::Records;

    /** Arguments must live as long as it. */
    ExplicitHeat(const Scene             &scene,
                 const Field<3>          &field,
                 const TissueMap<3>      &tissues,
                 const BoundaryMap<3>    &boundaries,
                 const PointLocator<3>   &locator,
                 const TledBody<Number>  &body,
                 const TledNodes<Number> &nodes);

    bool relaxes() const { return non_fourier; }

    /** Begins the books at @p state. */
    void start(const State &state);

    /** Renews what depends on temperature or damage; true if NodeStep's coefficients do. Collective. */
    bool refresh(const State &state);

    /** Sets what NodeStep needs for a step of @p duration (s). */
    void fill(const double duration, Records &keep, Records &gain, Records &exchange) const;

    /** Sets and books the heat that comes from outside, in the mean over @p step. */
    void load(const Step &step, const Records &values, Records &loads);

    /** Sets @p rates where the temperature is prescribed, so that it is right after @p step; and takes the @p
     * flow that was found for the books. */
    void prescribe(const Step &step, const Records &values, const Records &flow, Records &rates);

    /** Books the step of @p duration (s) that has led to @p values and @p rates. */
    void record(const double duration, const Records &values, const Records &rates);

    /** Collective. */
    HeatTotals totals(const State &state) const;

    /** @p state is that of the archive already. Collective where it brings back. */
    void archive(Archive &archive, const State &state);

    /** Lumped capacities rho C V of the process's own nodes, J/K. */
    std::vector<double> capacities() const { return {capacity.begin(), capacity.end()}; }

    /** The longest stable step (s), where @p rate (1/s) bounds the eigenvalues of conduction over capacity.
     */
    double stable_step(const double rate) const;

  private:
    void   assemble(const Vector *before, const Vector *now, const Vector *ln_damage);
    void   relax(const Step &step, const Records &flow);
    double brought(const std::uint32_t node, const Number heating) const;
    void   sum_settled(const Records &values);
    Vector delayed_exchange(const Vector &temperature) const;

    const Scene          &scene;
    const Field<3>       &field;
    const TissueMap<3>   &tissues;
    const BoundaryMap<3> &boundaries;
    const bool            non_fourier;
    const bool            exchanges; ///< perfusion or convection
    const double          zero_temperature;
    Prescribed<3>         prescribed;
    HeatLoads<3>          outside;
    HeldRecords<Number>   held; ///< temperatures

    // per own node
    Vector    capacity;                           ///< int rho C N, J/K
    Vector    relaxation;                         ///< m, J s/K; non-Fourier only
    Vector    storage;                            ///< c, J/K
    Vector    blood_weights;                      ///< int w N, W/K
    Vector    surface_weights;                    ///< int h N, W/K
    Vector    inside;                             ///< int (w T_b + Q_met) N, W
    Vector    impulse;                            ///< int tau (changes of Q_met and w (T_b - T)) N, J
    double    blood_source = 0., metabolism = 0.; ///< sums, W
    Vector    delayed_blood;                      ///< int tau w T_b N, J; for the impulse only
    DeadNodes dead;                               ///< where perfusion stops in them
    Vector    last_temperature;                   ///< of the step before, K; where metabolism grows

    // the books: sums of this process but for those of HeatLoads, J
    typename HeatLoads<3>::Received received;
    Vector                          start_temperature; ///< K
    Vector                          conducted;         ///< q into the node's share, W; non-Fourier only
    Vector                          delivered;         ///< by the load of the running step, W
    double                          blood     = 0.;    ///< int w T dt
    double                          bled      = 0.;    ///< int w T_b dt; of all processes
    double                          made      = 0.;    ///< by metabolism; of all processes
    double                          convected = 0.;    ///< int h T dt
    double                          taken     = 0.;    ///< through nodes of prescribed temperature
    double                          settled   = 0.;    ///< of it, what settled nodes are brought; W
    double                          first     = 0.;    ///< by the first flux, see HeatBalance
  };
} // namespace Cautery
