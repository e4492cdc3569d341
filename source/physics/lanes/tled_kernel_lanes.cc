// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled once for each instruction set: CAUTERY_FILL names the function to define, CAUTERY_LANE_BYTES is
// the size of a register. Nothing but lanes.h and the laws may be included here, see there.
#include <cautery/laws/neo_hookean.h>
#include <cautery/physics/lanes.h>
#include <cautery/physics/tled_kernel.h>

namespace Cautery
{
  namespace
  {
    using Law = SweepChoice::Law;

    /// A number of fibre families that is known only at run time.
    constexpr int some_fibres = -1;

    template <typename Number>
    constexpr int lanes = CAUTERY_LANE_BYTES / sizeof(Number) < 4 ? 4 : CAUTERY_LANE_BYTES / sizeof(Number);

    /**
     * One point of integration of a group of cells: values at their corners, then forces on them. Forces on
     * corner 0, which balance the others, are the caller's for hexahedra: once for all points.
     *
     * Memory and arithmetic of a group are apart in time, so that neither waits for the other: @p
     * meanwhile(0) and @p meanwhile(1), called within the arithmetic, write what the last group has left to
     * be written.
     */
    template <int corners, Law law, StretchForm form, int n_fibres, bool conduction, typename Number>
    struct GroupPoint
    {
      using L      = Lanes<Number, lanes<Number>>;
      using Values = NodeRecords<Number, lanes<Number>>[corners];

      const SweepMaterial &material;
      const Number        *constants;  ///< of the point
      const Number        *directions; ///< of the fibres

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

      CAUTERY_INLINE void conduct(const Values &at, Values &flow) const
      {
        const L weight  = volume() * material.conductivity;
        const L flux[3] = {weight * slope(at, 3, 0, Others()),
                           weight * slope(at, 3, 1, Others()),
                           weight * slope(at, 3, 2, Others())};
        distribute(flux, 3, flow, Others());
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
          if constexpr (n_fibres == some_fibres)
            for (int f = 0; f < static_cast<int>(material.n_fibres); ++f)
              add_fibre(f, k, stress);
          else if constexpr (n_fibres == 1)
            add_fibre(0, k, stress);
        };
        const Matrix3<L> h = displacement_gradient(at);
        meanwhile(0);
        using Ground = std::conditional_t<law == Law::neo_hookean, NeoHookean, SmallStrain>;
        return point_stress<form>(
          Ground{material.lambda, material.mu}, add_fibres, h, heating * material.expansion);
      }

      /** @p heating is T - T_0 at the point. Returns J, which is positive unless the cell is inverted. */
      template <typename Meanwhile>
      CAUTERY_INLINE L
      forces(const Values &at, const L &heating, Values &on, const Meanwhile &meanwhile) const
      {
        L jacobian(1.);
        if constexpr (law != Law::none)
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
        if constexpr (law != Law::neo_hookean)
          meanwhile(1);
        if constexpr (conduction)
          conduct(at, on);
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

    /** All groups of tetrahedra; see TledKernel::Sweep. */
    template <Law law, StretchForm form, int n_fibres, bool conduction, typename Number>
    [[gnu::flatten]] bool sweep_tetrahedra(const CellSweep<Number> &cells)
    {
      constexpr int width = lanes<Number>;
      using L             = Lanes<Number, width>;
      if (cells.n_groups == 0)
        return true;
      const SweepMaterial material = cells.material;
      const std::size_t   n_rows   = 10 + 3 * material.n_fibres;

      NodeRecords<Number, width> next[4], now[4], last[4], forces[4];
      for (int corner = 0; corner < 4; ++corner)
        gather(cells.values, cells.offsets + corner * width, next[corner]);
      for (auto &records : last)
        for (L &component : records.component)
          component = L(0.);

      const std::uint32_t *last_offsets = cells.offsets;
      auto                 healthy      = L(1.).v > L(0.).v;
      for (std::size_t g = 0; g < cells.n_groups; ++g)
        {
          const std::uint32_t *offsets      = cells.offsets + 4 * width * g;
          const std::uint32_t *next_offsets = g + 1 < cells.n_groups ? offsets + 4 * width : offsets;
          for (int corner = 0; corner < 4; ++corner)
            now[corner] = next[corner];
          // measured: of several orders, this leaves both memory and arithmetic waiting least
          const auto read = [&](const int corner) {
            gather(cells.values, next_offsets + corner * width, next[corner]);
          };
          const auto write = [&](const int corner) {
            scatter_add(last[corner], last_offsets + corner * width, cells.forces);
          };
          const auto meanwhile = [&](const int part) {
            write(2 * part);
            write(2 * part + 1);
          };
          const Number *constants = cells.constants + n_rows * width * g;
          const GroupPoint<4, law, form, n_fibres, conduction, Number> group = {
            material, constants, constants + 10 * width};
          const L heating =
            (now[0].component[3] + now[1].component[3] + now[2].component[3] + now[3].component[3]) * 0.25;
          const L jacobian = group.forces(now, heating, forces, meanwhile);
          read(0);
          read(1);
          read(2);
          read(3);
          healthy = healthy & (jacobian.v > L(0.).v);
          for (int corner = 0; corner < 4; ++corner)
            last[corner] = forces[corner];
          last_offsets = offsets;
        }
      for (int corner = 0; corner < 4; ++corner)
        scatter_add(last[corner], last_offsets + corner * width, cells.forces);
      return all(healthy);
    }

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
    template <Law law, StretchForm form, int n_fibres, bool conduction, typename Number>
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
              const GroupPoint<8, law, form, n_fibres, conduction, Number> point = {
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
              resist_hourglass<law == Law::none ? 3 : 0, conduction ? 4 : 3>(gamma, stiffness, at, on);
            }
          for (int i = 0; i < 4; ++i)
            for (int corner = 1; corner < 8; ++corner)
              on[0].component[i] = on[0].component[i] - on[corner].component[i];
          for (int corner = 0; corner < 8; ++corner)
            scatter_add(on[corner], offsets + corner * width, cells.forces);
        }
      return all(healthy);
    }

    template <bool has_exchange, typename Number>
    void step(const NodeStep<Number> &nodes)
    {
      using L           = Lanes<Number, 4>;
      const auto active = [&nodes](const int component) -> Number {
        return component < 3 ? nodes.motion : nodes.heat;
      };
      const typename L::Vector on       = {active(0), active(1), active(2), active(3)};
      const L                  duration = L(on) * nodes.duration;
      for (std::size_t i = 0; i < node_record * nodes.n_nodes; i += node_record)
        {
          L force = L::load(nodes.loads + i) - L::load(nodes.forces + i);
          if constexpr (has_exchange)
            force = force - L::load(nodes.exchange + i) * L::load(nodes.values + i);
          const L old  = L::load(nodes.rates + i);
          const L rate = on > 0 ? (L::load(nodes.keep + i) * old + L::load(nodes.gain + i) * force).v : old.v;
          record(nodes.rates, i) = rate.v;
          record(nodes.values, i) += (duration * rate).v;
          record(nodes.forces, i) = on > 0 ? L(0.).v : L::load(nodes.forces + i).v;
        }
    }

    template <typename Number>
    void any_step(const NodeStep<Number> &nodes)
    {
      if (nodes.exchange == nullptr)
        step<false>(nodes);
      else
        step<true>(nodes);
    }

    template <typename Number, Law law, int n_fibres, StretchForm form>
    typename TledKernel<Number>::Sweep find_conduction(const SweepChoice &choice)
    {
      if (choice.hexahedra)
        return choice.conduction ? sweep_hexahedra<law, form, n_fibres, true, Number> :
                                   sweep_hexahedra<law, form, n_fibres, false, Number>;
      return choice.conduction ? sweep_tetrahedra<law, form, n_fibres, true, Number> :
                                 sweep_tetrahedra<law, form, n_fibres, false, Number>;
    }

    template <typename Number, Law law, int n_fibres>
    typename TledKernel<Number>::Sweep find_stretch(const SweepChoice &choice)
    {
      switch (choice.stretch)
        {
        case StretchForm::linearised:
          return find_conduction<Number, law, n_fibres, StretchForm::linearised>(choice);
        case StretchForm::exact:
          return find_conduction<Number, law, n_fibres, StretchForm::exact>(choice);
        default:
          return find_conduction<Number, law, n_fibres, StretchForm::none>(choice);
        }
    }

    template <typename Number>
    typename TledKernel<Number>::Sweep find(const SweepChoice &choice)
    {
      if (choice.law == Law::none)
        return choice.hexahedra ? sweep_hexahedra<Law::none, StretchForm::none, 0, true, Number> :
                                  sweep_tetrahedra<Law::none, StretchForm::none, 0, true, Number>;
      if (choice.law == Law::small_strain)
        return find_stretch<Number, Law::small_strain, 0>(choice);
      switch (choice.n_fibres)
        {
        case 0:
          return find_stretch<Number, Law::neo_hookean, 0>(choice);
        case 1:
          return find_stretch<Number, Law::neo_hookean, 1>(choice);
        default:
          return find_stretch<Number, Law::neo_hookean, some_fibres>(choice);
        }
    }
  } // namespace

  void CAUTERY_FILL(TledKernel<float> &kernel) { kernel = {lanes<float>, any_step<float>, find<float>}; }
  void CAUTERY_FILL(TledKernel<double> &kernel) { kernel = {lanes<double>, any_step<double>, find<double>}; }
} // namespace Cautery
