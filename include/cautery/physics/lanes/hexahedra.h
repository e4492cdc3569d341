// SPDX-License-Identifier: LGPL-2.1-or-later
// All groups of hexahedra: their forces.
#pragma once

#include <cautery/physics/lanes/group_point.h>

namespace Cautery
{
  namespace
  {
    /** 1/8 (1 +- 1/sqrt(3))...: shape functions of a hexahedron at its eight points, by differing signs. */
    constexpr double shape_by_distance[4] = {
      0.490562612162344, 0.131445855765802, 0.035220810900865, 0.009437387837656};

    /** T - T_0 at point @p q of @p n. */
    template <typename Values>
    CAUTERY_INLINE auto heating_at(const int q, const int n, const Values &at)
    {
      auto sum = at[0].component[3] * (n == 1 ? 0.125 : shape_by_distance[__builtin_popcount(q)]);
      for (int corner = 1; corner < 8; ++corner)
        sum = sum +
              at[corner].component[3] * (n == 1 ? 0.125 : shape_by_distance[__builtin_popcount(q ^ corner)]);
      return sum;
    }

    /** Adds the forces against hourglass modes; @p constants begin with the vectors gamma, see CellSweep. */
    template <int first, int last, typename Number, typename Values>
    CAUTERY_INLINE void resist_hourglass(const Number *constants,
                                         const Lanes<Number, lanes<Number>> (&stiffness)[4],
                                         const Values &at,
                                         Values       &on)
    {
      using L = Lanes<Number, lanes<Number>>;
      for (int mode = 0; mode < 4; ++mode)
        for (int i = first; i < last; ++i)
          {
            L size(0.);
            for (int a = 1; a < 8; ++a)
              size = size + L::load(constants + (7 * mode + a - 1) * lanes<Number>) *
                              (at[a].component[i] - at[0].component[i]);
            size = size * stiffness[i];
            for (int a = 1; a < 8; ++a)
              on[a].component[i] =
                on[a].component[i] + L::load(constants + (7 * mode + a - 1) * lanes<Number>) * size;
          }
    }

    /** All groups of hexahedra; see TledKernel::Sweep. */
    template <typename Terms, typename Number>
    [[gnu::flatten]] bool sweep_hexahedra(const CellSweep<Number> &cells)
    {
      constexpr int width = lanes<Number>, point_rows = 22, hourglass_rows = 29;
      using L                       = Lanes<Number, width>;
      const SweepMaterial material  = cells.material;
      const bool          control   = cells.n_points == 1;
      const std::size_t   fibre_row = cells.n_points * point_rows + (control ? hourglass_rows : 0);
      const std::size_t   n_rows    = fibre_row + 3 * material.n_fibres;

      auto healthy = L(1.).v > L(0.).v;
      for (std::size_t g = 0; g < cells.n_groups; ++g)
        {
          const std::uint32_t       *offsets   = cells.offsets + 8 * width * g;
          const Number              *constants = cells.constants + n_rows * width * g;
          NodeRecords<Number, width> at[8], on[8];
          for (int corner = 0; corner < 8; ++corner)
            {
              gather(cells.values, offsets + corner * width, at[corner]);
              for (L &component : on[corner].component)
                component = L(0.);
            }
          for (int q = 0; q < cells.n_points; ++q)
            {
              const GroupPoint<8, Terms, Number> point = {
                material, constants + q * point_rows * width, constants + fibre_row * width};
              const L jacobian = point.forces(at, heating_at(q, cells.n_points, at), on, [](const int) {});
              healthy          = healthy & (jacobian.v > L(0.).v);
            }
          if (control)
            {
              const Number *gamma        = constants + point_rows * width;
              const L       size         = L::load(gamma + 28 * width) * cells.hourglass;
              const L       elastic      = size * (material.lambda + 2. * material.mu);
              const L       stiffness[4] = {elastic, elastic, elastic, size * material.conductivity};
              constexpr int first        = Terms::law == Law::none ? 3 : 0;
              constexpr int last         = Terms::conduction == Conduction::none ? 3 : 4;
              resist_hourglass<first, last>(gamma, stiffness, at, on);
            }
          for (int i = 0; i < 4; ++i)
            for (int corner = 1; corner < 8; ++corner)
              on[0].component[i] = on[0].component[i] - on[corner].component[i];
          for (int corner = 0; corner < 8; ++corner)
            scatter_add(on[corner], offsets + corner * width, cells.forces);
        }
      return all(healthy);
    }
  } // namespace
} // namespace Cautery
