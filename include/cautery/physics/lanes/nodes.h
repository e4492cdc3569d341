// SPDX-License-Identifier: LGPL-2.1-or-later
// What is computed node by node.
#pragma once

#include <cautery/physics/lanes.h>
#include <cautery/physics/tled_kernel.h>

#include <limits>

namespace Cautery
{
  namespace
  {
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

    /** The pressures of four nodes; see NodePressures. */
    template <StretchForm form, typename Number>
    CAUTERY_INLINE void find_pressures(const SweepMaterial &material,
                                       const Number        *values,
                                       const Number        *volumes,
                                       Number              *volume_changes,
                                       Number              *pressures)
    {
      using L                         = Lanes<Number, 4>;
      constexpr double       smallest = std::numeric_limits<Number>::min();
      NodeRecords<Number, 4> nodes;
      for (int i = 0; i < 4; ++i)
        nodes.component[i] = L::load(values + node_record * i);
      transpose(nodes, std::make_integer_sequence<int, 4>());
      const L stretch           = 1. + stretch_excess<form>(nodes.component[3] * material.expansion);
      const L volume            = L::load(volumes) * (stretch * stretch * stretch);
      const L x                 = L::load(volume_changes) / at_least(L(smallest), volume); // J - 1
      const L pressure          = material.lambda * log1p(x) / (1. + x);
      record(pressures, 0)      = pressure.v;
      record(volume_changes, 0) = L(0.).v;
    }

    template <typename Number>
    void copy(const Number *from, const std::size_t n, Number *to)
    {
      for (std::size_t i = 0; i < n; ++i)
        to[i] = from[i];
    }

    /** See TledKernel::pressure. */
    template <StretchForm form, typename Number>
    void find_pressures(const NodePressures<Number> &nodes)
    {
      std::size_t i = 0;
      for (; i + 4 <= nodes.n_nodes; i += 4)
        find_pressures<form>(nodes.material,
                             nodes.values + node_record * i,
                             nodes.volumes + i,
                             nodes.volume_changes + i,
                             nodes.pressures + i);
      const std::size_t rest = nodes.n_nodes - i;
      if (rest == 0)
        return;
      alignas(64) Number values[4 * node_record] = {}, volumes[4] = {}, volume_changes[4] = {}, pressures[4];
      copy(nodes.values + node_record * i, node_record * rest, values);
      copy(nodes.volumes + i, rest, volumes);
      copy(nodes.volume_changes + i, rest, volume_changes);
      find_pressures<form>(nodes.material, values, volumes, volume_changes, pressures);
      copy(volume_changes, rest, nodes.volume_changes + i);
      copy(pressures, rest, nodes.pressures + i);
    }

    template <typename Number>
    void any_pressures(const NodePressures<Number> &nodes)
    {
      switch (nodes.stretch)
        {
        case StretchForm::linearised:
          return find_pressures<StretchForm::linearised>(nodes);
        case StretchForm::exact:
          return find_pressures<StretchForm::exact>(nodes);
        default:
          return find_pressures<StretchForm::none>(nodes);
        }
    }
  } // namespace
} // namespace Cautery
