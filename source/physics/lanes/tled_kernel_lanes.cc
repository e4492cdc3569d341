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
     * One group of tetrahedra: values at its corners, then forces on them.
     *
     * Memory and arithmetic of a group are apart in time, so that neither waits for the other: @p
     * meanwhile(0) and @p meanwhile(1), called within the arithmetic, write what the last group has left to
     * be written.
     */
    template <Law law, StretchForm form, int n_fibres, bool conduction, typename Number>
    struct Group
    {
      using L = Lanes<Number, lanes<Number>>;

      const SweepMaterial &material;
      const Number        *constants;

      CAUTERY_INLINE L row(const int i) const { return L::load(constants + i * lanes<Number>); }

      template <typename Values>
      CAUTERY_INLINE Matrix3<L> displacement_gradient(const Values (&at)[4]) const
      {
        Matrix3<L> h;
        for (int i = 0; i < 3; ++i)
          {
            const L origin = at[0].component[i];
            for (int j = 0; j < 3; ++j)
              h(i, j) = (at[1].component[i] - origin) * row(j);
            for (int corner = 2; corner < 4; ++corner)
              for (int j = 0; j < 3; ++j)
                h(i, j) = h(i, j) + (at[corner].component[i] - origin) * row(3 * corner - 3 + j);
          }
        return h;
      }

      /** Fills component @p i of the forces with @p flux times the gradients; corner 0 balances the others.
       */
      template <typename Forces>
      CAUTERY_INLINE void distribute(const L (&flux)[3], const int i, Forces (&on)[4]) const
      {
        for (int corner = 1; corner < 4; ++corner)
          on[corner].component[i] =
            flux[0] * row(3 * corner - 3) + flux[1] * row(3 * corner - 2) + flux[2] * row(3 * corner - 1);
        on[0].component[i] = -(on[1].component[i] + on[2].component[i] + on[3].component[i]);
      }

      template <typename Values>
      CAUTERY_INLINE void conduct(const Values (&at)[4], Values (&flow)[4]) const
      {
        const L weight = row(9) * material.conductivity;
        const L origin = at[0].component[3];
        L       flux[3];
        for (int j = 0; j < 3; ++j)
          flux[j] =
            weight * ((at[1].component[3] - origin) * row(j) + (at[2].component[3] - origin) * row(3 + j) +
                      (at[3].component[3] - origin) * row(6 + j));
        distribute(flux, 3, flow);
      }

      template <typename Values, typename Meanwhile>
      CAUTERY_INLINE auto stress(const Values (&at)[4], const Meanwhile &meanwhile) const
      {
        const auto add_fibre = [&](const int f, const Deformation<L> &k, Matrix3<L> &stress) {
          const Vector3<L> direction = {{row(10 + 3 * f), row(11 + 3 * f), row(12 + 3 * f)}};
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
        L thermal_strain(0.);
        if constexpr (form != StretchForm::none)
          thermal_strain =
            (at[0].component[3] + at[1].component[3] + at[2].component[3] + at[3].component[3]) *
            (0.25 * material.expansion);
        const Matrix3<L> h = displacement_gradient(at);
        meanwhile(0);
        using Ground = std::conditional_t<law == Law::neo_hookean, NeoHookean, SmallStrain>;
        return point_stress<form>(Ground{material.lambda, material.mu}, add_fibres, h, thermal_strain);
      }

      /** Returns J, which is positive unless the cell is inverted. */
      template <typename Values, typename Meanwhile>
      CAUTERY_INLINE L forces(const Values (&at)[4], Values (&on)[4], const Meanwhile &meanwhile) const
      {
        L jacobian(1.);
        if constexpr (law != Law::none)
          {
            const auto point  = stress(at, meanwhile);
            const L    weight = row(9) * point.factor;
            jacobian          = point.jacobian;
            for (int i = 0; i < 3; ++i)
              {
                const L flux[3] = {
                  weight * point.stress(i, 0), weight * point.stress(i, 1), weight * point.stress(i, 2)};
                distribute(flux, i, on);
              }
          }
        else
          {
            meanwhile(0);
            for (int corner = 0; corner < 4; ++corner)
              for (int i = 0; i < 3; ++i)
                on[corner].component[i] = L(0.);
          }
        if constexpr (law != Law::neo_hookean)
          meanwhile(1);
        if constexpr (conduction)
          conduct(at, on);
        else
          for (int corner = 0; corner < 4; ++corner)
            on[corner].component[3] = L(0.);
        return jacobian;
      }
    };

    /** All groups; see TledKernel::Sweep. */
    template <Law law, StretchForm form, int n_fibres, bool conduction, typename Number>
    [[gnu::flatten]] bool sweep(const TetrahedraSweep<Number> &cells)
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
          const Group<law, form, n_fibres, conduction, Number> group = {material,
                                                                        cells.constants + n_rows * width * g};
          const L jacobian                                           = group.forces(now, forces, meanwhile);
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
      for (int lane = 0; lane < width; ++lane)
        if (healthy[lane] == 0)
          return false;
      return true;
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
      return choice.conduction ? sweep<law, form, n_fibres, true, Number> :
                                 sweep<law, form, n_fibres, false, Number>;
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
        return sweep<Law::none, StretchForm::none, 0, true, Number>;
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
