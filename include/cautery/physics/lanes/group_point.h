// SPDX-License-Identifier: LGPL-2.1-or-later
// One point of integration in a group of cells.
#pragma once

#include <cautery/laws/neo_hookean.h>
#include <cautery/physics/lanes.h>
#include <cautery/physics/tled_kernel.h>

namespace Cautery
{
  namespace
  {
    using Law        = SweepChoice::Law;
    using Conduction = SweepChoice::Conduction;

    /// A number of fibre families that is known only at run time.
    constexpr int some_fibres = -1;

    template <typename Number>
    constexpr int lanes = CAUTERY_LANE_BYTES / sizeof(Number) < 4 ? 4 : CAUTERY_LANE_BYTES / sizeof(Number);

    /** A SweepChoice that the compiler knows, for cells of either shape. */
    template <Law law_, StretchForm stretch_, int n_fibres_, Conduction conduction_, bool averaged_pressure_>
    struct TermsOf
    {
      static constexpr Law         law               = law_;
      static constexpr StretchForm stretch           = stretch_;
      static constexpr int         n_fibres          = n_fibres_;
      static constexpr Conduction  conduction        = conduction_;
      static constexpr bool        averaged_pressure = averaged_pressure_;
    };

    /** The neo-Hookean law with a pressure, Pa, that does not follow from the point's own J. */
    template <typename L>
    struct PressedNeoHookean
    {
      double mu;
      L      pressure;

      CAUTERY_INLINE Matrix3<L> stress(const Deformation<L> &k) const
      {
        return NeoHookean{0., mu}.stress(k, pressure * k.jacobian);
      }
    };

    /**
     * One point of integration of a group of cells: values at their corners, then forces on them. Forces on
     * corner 0, which balance the others, are the caller's for hexahedra: once for all points.
     *
     * Memory and arithmetic of a group are apart in time, so that neither waits for the other: @p
     * meanwhile(0) and @p meanwhile(1), called within the arithmetic, write what the last group has left to
     * be written.
     */
    template <int corners, typename Terms, typename Number>
    struct GroupPoint
    {
      using L      = Lanes<Number, lanes<Number>>;
      using Values = NodeRecords<Number, lanes<Number>>[corners];

      const SweepMaterial &material;
      const Number        *constants;        ///< of the point
      const Number        *directions;       ///< of the fibres
      L                    pressure = L(0.); ///< Pa, of Terms::averaged_pressure

      CAUTERY_INLINE L row(const int i) const { return L::load(constants + i * lanes<Number>); }
      CAUTERY_INLINE L volume() const { return row(3 * corners - 3); }

      /** Corners 1, 2, ... as 0, 1, ...: written out, because GCC keeps arrays that loops run over in memory.
       */
      using Others = std::make_index_sequence<corners - 1>;

      /** The derivative along axis @p j of component @p c of the values. */
      template <std::size_t... other>
      CAUTERY_INLINE L slope(const Values &at, const int c, const int j, std::index_sequence<other...>) const
      {
        const L origin = at[0].component[c];
        return (... + ((at[other + 1].component[c] - origin) * row(3 * other + j)));
      }

      CAUTERY_INLINE Matrix3<L> displacement_gradient(const Values &at) const
      {
        Matrix3<L> h;
        for (int i = 0; i < 3; ++i)
          {
            const L origin = at[0].component[i];
            for (int j = 0; j < 3; ++j)
              h(i, j) = (at[1].component[i] - origin) * row(j);
            for (int corner = 2; corner < corners; ++corner)
              for (int j = 0; j < 3; ++j)
                h(i, j) = h(i, j) + (at[corner].component[i] - origin) * row(3 * corner - 3 + j);
          }
        return h;
      }

      /** Gives component @p i of the forces: @p flux times the gradients. */
      template <std::size_t... other>
      CAUTERY_INLINE void
      distribute(const L (&flux)[3], const int i, Values &on, std::index_sequence<other...>) const
      {
        const auto part = [&](const int k) {
          return flux[0] * row(3 * k) + flux[1] * row(3 * k + 1) + flux[2] * row(3 * k + 2);
        };
        if constexpr (corners == 4)
          {
            ((on[other + 1].component[i] = part(other)), ...);
            on[0].component[i] = -(... + on[other + 1].component[i]);
          }
        else
          ((on[other + 1].component[i] = on[other + 1].component[i] + part(other)), ...);
      }

      /** In the reference body, K/m. */
      CAUTERY_INLINE Vector3<L> temperature_gradient(const Values &at) const
      {
        return {{slope(at, 3, 0, Others()), slope(at, 3, 1, Others()), slope(at, 3, 2, Others())}};
      }

      /** Gives the flow that belongs to conductivity times @p v. */
      CAUTERY_INLINE void conduct(const Vector3<L> &v, Values &flow) const
      {
        const L weight  = volume() * material.conductivity;
        const L flux[3] = {weight * v[0], weight * v[1], weight * v[2]};
        distribute(flux, 3, flow, Others());
      }

      CAUTERY_INLINE auto ground() const
      {
        if constexpr (Terms::averaged_pressure)
          return PressedNeoHookean<L>{material.mu, pressure};
        else if constexpr (Terms::law == Law::neo_hookean)
          return NeoHookean{material.lambda, material.mu};
        else
          return SmallStrain{material.lambda, material.mu};
      }

      template <typename Meanwhile>
      CAUTERY_INLINE auto stress(const Values &at, const L &heating, const Meanwhile &meanwhile) const
      {
        const auto add_fibre = [&](const int f, const Deformation<L> &k, Matrix3<L> &stress) {
          const Number    *a         = directions + 3 * f * lanes<Number>;
          const Vector3<L> direction = {
            {L::load(a), L::load(a + lanes<Number>), L::load(a + 2 * lanes<Number>)}};
          material.fibres[f].add_stress(k, direction, stress);
        };
        const auto add_fibres = [&](const Deformation<L> &k, Matrix3<L> &stress) {
          meanwhile(1);
          if constexpr (Terms::n_fibres == some_fibres)
            for (int f = 0; f < static_cast<int>(material.n_fibres); ++f)
              add_fibre(f, k, stress);
          else if constexpr (Terms::n_fibres == 1)
            add_fibre(0, k, stress);
        };
        const Matrix3<L> h = displacement_gradient(at);
        meanwhile(0);
        return point_stress<Terms::stretch>(ground(), add_fibres, h, heating * material.expansion);
      }

      /** @p heating is T - T_0 at the point. Returns J, which is positive unless the cell is inverted. */
      template <typename Meanwhile>
      CAUTERY_INLINE L
      forces(const Values &at, const L &heating, Values &on, const Meanwhile &meanwhile) const
      {
        L jacobian(1.);
        if constexpr (Terms::law != Law::none)
          {
            const auto point  = stress(at, heating, meanwhile);
            const L    weight = volume() * point.factor;
            jacobian          = point.jacobian;
            for (int i = 0; i < 3; ++i)
              {
                const L flux[3] = {
                  weight * point.stress(i, 0), weight * point.stress(i, 1), weight * point.stress(i, 2)};
                distribute(flux, i, on, Others());
              }
          }
        else
          {
            meanwhile(0);
            if constexpr (corners == 4)
              for (int corner = 0; corner < 4; ++corner)
                for (int i = 0; i < 3; ++i)
                  on[corner].component[i] = L(0.);
          }
        if constexpr (Terms::law != Law::neo_hookean)
          meanwhile(1);
        if constexpr (Terms::conduction == Conduction::deformed)
          {
            const Deformation<L> whole(displacement_gradient(at)); // not its elastic part
            conduct(flux_in_reference(whole, temperature_gradient(at)), on);
            if constexpr (Terms::law != Law::neo_hookean)
              jacobian = whole.jacobian;
          }
        else if constexpr (Terms::conduction == Conduction::reference)
          conduct(temperature_gradient(at), on);
        else if constexpr (corners == 4)
          for (int corner = 0; corner < 4; ++corner)
            on[corner].component[3] = L(0.);
        return jacobian;
      }
    };

    template <typename L>
    bool all(const L &lanes_of_ones)
    {
      for (unsigned int lane = 0; lane < sizeof(lanes_of_ones) / sizeof(lanes_of_ones[0]); ++lane)
        if (lanes_of_ones[lane] == 0)
          return false;
      return true;
    }
  } // namespace
} // namespace Cautery
