// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/critical_step.h>
#include <cautery/physics/explicit_motion.h>
#include <cautery/time/equilibrium.h>

#include <memory>

namespace Cautery
{
  /**
   * Equilibrium in large deformation without any matrix: a motion with masses that suit its steps only,
   * damped until it rests (Underwood, Dynamic relaxation, in: Computational methods for transient analysis,
   * 1983; for TLED: Joldes, Wittek and Miller, Comput. Methods Appl. Mech. Engrg. 199, 2010, 994-1001).
   *
   * Masses are such that all cells vibrate about equally fast. The damping is critical for the lowest
   * frequency that is in the motion, which is its Rayleigh quotient. Loads, prescribed displacements and heat
   * come gradually; where that inverts a cell, more slowly once more.
   */
  class DynamicRelaxation : public Equilibrium
  {
  public:
    using Records = TledNodes<double>::Records;

    /** Arguments must live as long as it. */
    DynamicRelaxation(const Scene        &scene,
                      TledBody<double>   &body,
                      TledNodes<double>  &nodes,
                      const Supports<3>  &supports,
                      const OuterLoad<3> &load,
                      Cost               &cost);

    void                          solve(State &state) override;
    void                          archive(Archive &archive, const State &state) override;
    std::map<std::string, double> statistics() const override;

  private:
    /** Why there is no equilibrium; empty: there is. */
    using Failure = std::string;

    Failure relax(const State &state, const unsigned int n_gradual);
    void    renew_step();
    void    find_forces();
    void    look();
    void    damp();
    void    approach(const State &state, const unsigned int n_left);
    void    take_step();

    const RelaxationSettings &settings;
    const OuterLoad<3>       &outer_load;
    const bool                expands;
    TledBody<double>         &body;
    TledNodes<double>        &nodes;
    Cost                     &cost;
    ExplicitMotion<double>    motion;
    std::vector<double>       masses; ///< not the body's, kg
    CriticalStep<double>      critical;

    Records       values, rates, forces, last_forces, loads, target_loads, keep, gain;
    bool          healthy  = true; ///< no cell is inverted
    double        duration = 0.;   ///< of a step, s
    double        damping  = 0.;   ///< 1/s
    double        largest  = 0.;   ///< square of the norm of the forces that have acted, N2
    double        left     = 0.;   ///< norm of the forces left over, relative to it
    std::uint64_t n_steps  = 0;
  };
} // namespace Cautery
