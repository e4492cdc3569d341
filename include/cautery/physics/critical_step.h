// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/tled_body.h>

namespace Cautery
{
  /**
   * Bounds the largest eigenvalue of M^-1 K of an explicit loop, which bounds its stable steps: central
   * differences of motion are stable up to 2 / omega with omega^2 that eigenvalue, K being the tangent of the
   * deformed body.
   *
   * By Lanczos's method with the kernel's own sweeps: the largest eigenvalue of the tridiagonal matrix, plus
   * the residual of its vector (Zhou and Li, Linear Algebra Appl. 435, 2011, 480-493). All that the cells do
   * counts: fibres (slack ones too, because they may be taut a few steps later), thermal stretch, hourglass
   * control. Bounds from single cells were tried: with natural
   * shares of the nodal masses they are 1.5 times too small on a cube and over 4 times on a liver (in the
   * step); the thesis's L / c (Eq. 7-55) is up to 1.7 times too large.
   */
  template <typename Number>
  class CriticalStep
  {
  public:
    using Part    = typename TledBody<Number>::Part;
    using Records = typename TledNodes<Number>::Records;

    /**
     * @p part: motion, with @p weights the masses (kg) of the process's own nodes, or heat, with their heat
     * capacities (J/K). Arguments but the last must live as long as it.
     */
    CriticalStep(TledBody<Number>          &body,
                 TledNodes<Number>         &nodes,
                 const Part                 part,
                 const std::vector<double> &weights);

    /** The bound at @p values: 1/s2 for motion, 1/s for heat. Collective; the same on any number of processes
     * but for rounding. 0 where all nodes are held. */
    double largest_eigenvalue(const Records &values);

    /**
     * The largest share of the stable step that is steady: 1, or sqrt(1/2) for motion where fibres bear
     * tension only. Central differences of a spring whose stiffness changes with its sign are a piecewise
     * linear map that keeps areas (Lagarias and Rains, J. Difference Equ. Appl. 11, 2005, 1089-1108): near
     * the limit it resonates, and grows by up to 15 % a step at 0.9 of it. At sqrt(1/2) two steps turn the
     * taut spring by half a period, and it never does.
     */
    double steady_share() const;

  private:
    using Numbers = std::vector<double>; ///< of the own nodes, some components each

    Numbers start() const;
    void    tangent(const Numbers &direction, Numbers &result);
    double  product(const Numbers &a, const Numbers &b) const;

    TledBody<Number>         &body;
    TledNodes<Number>        &nodes;
    const Part                part;
    const std::vector<double> weights;
    const unsigned int        first, n_components; ///< of a record
    double                    length;              ///< of the shortest edge, m

    Records base;        ///< values
    Records base_forces; ///< N or W
    Records displaced, forces;
  };
} // namespace Cautery
