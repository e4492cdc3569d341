// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/balance.h>
#include <cautery/physics/heat_distributions.h>

#include <vector>

namespace Cautery
{
  /**
   * The heat that comes from outside the balance: sources, and fluxes through surfaces. In the non-Fourier
   * model the balance is that of (1 + tau d/dt) of the heat (thesis Eq. 6-8), so every load has a twin
   * weighted with tau.
   */
  template <int dim>
  class HeatLoads
  {
  public:
    HeatLoads(const Scene             &scene,
              const Field<dim>        &field,
              const TissueMap<dim>    &tissues,
              const BoundaryMap<dim>  &boundaries,
              const PointLocator<dim> &locator);

    /** Adds the mean load over @p step and the difference quotient of the tau-weighted load, W per node. */
    void add(const Step &step, Vector &force) const;

    /**
     * Adds load and tau-weighted rate of the load at @p time, with those sources on that are on at @p within,
     * a time inside the interval between two switches.
     */
    void add_at(const double time, const double within, Vector &force) const;

    /**
     * Adds the load without any rate, with those sources that were on in the last recorded step as much as
     * they were: at the start of a run through surfaces alone.
     */
    void add_last(const double time, Vector &force) const;

    /** Goes on where the same loads on another mesh have come to. */
    void go_on(const HeatLoads &before);

    /** Adds the load h T_a N of convection alone, without any rate. */
    void add_convection_at(const double time, Vector &force) const;

    /** Does a source, or a given flux, take heat away from a node at the end of @p step? */
    bool take_heat(const Step &step) const;

    /** The tau-weighted load that comes suddenly at @p time; zero where jumps are neglected. */
    void add_jump(const double time, Vector &force) const;

    /** Is a source switched strictly between these times (s)? */
    bool jumps_within(const double from, const double to) const;

    /** All times in (0, end) at which a source is switched (s). */
    std::vector<double> switching_times(const double end) const;

    /** Heat that flowed in, in J. */
    struct Received
    {
      double sources  = 0.;
      double surfaces = 0.;

      void archive(Archive &archive)
      {
        archive.shared("received from sources", sources);
        archive.shared("received through surfaces", surfaces);
      }
    };

    /**
     * Books the heat of @p step: adds it node by node to @p nodal_heat (J) and in sum to @p received. What
     * changes in time counts with the mean of both ends (@p trapezoid), or with the end.
     */
    void record(const Step &step, const bool trapezoid, Vector &nodal_heat, Received &received);

    void archive(Archive &archive);

  private:
    struct Item
    {
      const HeatSource *source     = nullptr; ///< none: through a surface, always there
      bool              convection = false;
      HeatDistribution  distribution;
      Vector            load;    ///< W per node for amplitude 1
      Vector            relaxed; ///< the same times tau, W s; non-Fourier only
      double            sum        = 0.;
      double            delay      = 0.; ///< tau where it acts, s
      double            last_share = 0.; ///< of the last recorded step in which it was on
      double            effective  = 0.; ///< amplitude with which it really acts, where jumps are neglected
    };

    void   add_item(const HeatSource *source, const bool convection, const HeatDistribution &distribution);
    Vector load_at(const Item &item, const double time) const;
    void   assemble_now(const Item &item, const double time, Vector &load, Vector *relaxed) const;
    void   book(const Item  &item,
                const double time,
                const double seconds,
                Vector      &nodal_heat,
                Received    &received) const;
    double mean_amplitude(const Item &item, const Step &step) const;
    /** The amplitudes at both ends of a step, for the rate. */
    std::pair<double, double> end_amplitudes(const Item &item, const Step &step) const;
    void                      add_rate(const Item &item, const Step &step, Vector &force) const;

    const Field<dim> &field;
    const bool        non_fourier;
    const bool        jumps;
    std::vector<Item> items;
  };
} // namespace Cautery
