// SPDX-License-Identifier: LGPL-2.1-or-later
// All groups of tetrahedra: their forces, and their volumes.
#pragma once

#include <cautery/physics/lanes/group_point.h>

namespace Cautery
{
  namespace
  {
    /** The number that a node has, the node given by the offset of its record: without a shift. */
    template <typename Number>
    CAUTERY_INLINE Number &number(Number *numbers, const std::uint32_t offset)
    {
      static_assert(sizeof(Number) % node_record == 0);
      return *reinterpret_cast<Number *>(reinterpret_cast<std::uintptr_t>(numbers) +
                                         offset * (sizeof(Number) / node_record));
    }

    /** Sums of the numbers of each lane's four nodes: by way of memory, which is faster than shuffles. */
    template <typename Number, std::size_t... lane>
    CAUTERY_INLINE void sum_numbers(const Number        *numbers,
                                    const std::uint32_t *offsets,
                                    Number              *sums,
                                    std::index_sequence<lane...>)
    {
      constexpr int width = sizeof...(lane);
      ((sums[lane] =
          (number(numbers, offsets[lane]) + number(numbers, offsets[lane + width])) +
          (number(numbers, offsets[lane + 2 * width]) + number(numbers, offsets[lane + 3 * width]))),
       ...);
    }

    /** Adds each lane's part to the numbers of its four nodes. */
    template <typename Number, std::size_t... lane>
    CAUTERY_INLINE void add_to_numbers(const Number        *parts,
                                       const std::uint32_t *offsets,
                                       Number              *numbers,
                                       std::index_sequence<lane...>)
    {
      constexpr int width = sizeof...(lane);
      const auto    add   = [&](const int i, const Number part) {
        for (int corner = 0; corner < 4; ++corner)
          number(numbers, offsets[corner * width + i]) += part;
      };
      (add(lane, parts[lane]), ...);
    }

    /** T - T_0 of the cell. */
    template <typename Values>
    CAUTERY_INLINE auto mean_heating(const Values &at)
    {
      return (at[0].component[3] + at[1].component[3] + at[2].component[3] + at[3].component[3]) * 0.25;
    }

    /** How early a group's constants are asked for, in groups: memory answers within the time of these. */
    constexpr int groups_ahead = 4;

    /** All groups of tetrahedra; see TledKernel::find. */
    template <typename Terms, typename Number>
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
      alignas(64) Number next_pressures[width]; // four times
      const auto         read_pressures = [&](const std::uint32_t *offsets) {
        if constexpr (Terms::averaged_pressure)
          sum_numbers(cells.pressures, offsets, next_pressures, std::make_index_sequence<width>());
      };
      read_pressures(cells.offsets);
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
            if (part == 1)
              read_pressures(next_offsets);
          };
          const Number *constants = cells.constants + n_rows * width * g;
          L             pressure(0.);
          if constexpr (Terms::averaged_pressure)
            pressure = L::load(next_pressures) * 0.25;
          const GroupPoint<4, Terms, Number> group = {material, constants, constants + 10 * width, pressure};
          const L jacobian                         = group.forces(now, mean_heating(now), forces, meanwhile);
          read(0);
          read(1);
          read(2);
          read(3);
          prefetch<(10 + 3 * (Terms::n_fibres > 0)) * width>(constants + groups_ahead * n_rows * width);
          healthy = healthy & (jacobian.v > L(0.).v);
          for (int corner = 0; corner < 4; ++corner)
            last[corner] = forces[corner];
          last_offsets = offsets;
        }
      for (int corner = 0; corner < 4; ++corner)
        scatter_add(last[corner], last_offsets + corner * width, cells.forces);
      return all(healthy);
    }

    /**
     * All groups of tetrahedra; see TledKernel::find_volumes. Their volume changes by V (J - s^3), J being
     * that of the whole deformation: that is s^3 V (J_e - 1).
     */
    template <StretchForm form, typename Number>
    [[gnu::flatten]] bool sweep_volumes(const CellSweep<Number> &cells)
    {
      constexpr int width = lanes<Number>;
      using L             = Lanes<Number, width>;
      using Motion        = TermsOf<Law::neo_hookean, form, 0, Conduction::none, true>;
      if (cells.n_groups == 0)
        return true;
      const SweepMaterial material = cells.material;
      const std::size_t   n_rows   = 10 + 3 * material.n_fibres;

      NodeRecords<Number, width> next[4], now[4];
      for (int corner = 0; corner < 4; ++corner)
        gather(cells.values, cells.offsets + corner * width, next[corner]);
      alignas(64) Number   changes[width] = {}; // of the last group, and so added while the next is computed
      const std::uint32_t *last_offsets   = cells.offsets;
      const auto           add_changes    = [&]() {
        add_to_numbers(changes, last_offsets, cells.volume_changes, std::make_index_sequence<width>());
      };
      auto healthy = L(1.).v > L(0.).v;
      for (std::size_t g = 0; g < cells.n_groups; ++g)
        {
          const std::uint32_t *offsets      = cells.offsets + 4 * width * g;
          const std::uint32_t *next_offsets = g + 1 < cells.n_groups ? offsets + 4 * width : offsets;
          for (int corner = 0; corner < 4; ++corner)
            now[corner] = next[corner];
          for (int corner = 0; corner < 4; ++corner)
            gather(cells.values, next_offsets + corner * width, next[corner]);
          add_changes();
          const Number                       *constants = cells.constants + n_rows * width * g;
          const GroupPoint<4, Motion, Number> group     = {material, constants, nullptr};
          const Deformation<L>                k(group.displacement_gradient(now));
          const L excess  = stretch_excess<form>(mean_heating(now) * material.expansion);
          const L thermal = excess * (3. + excess * (3. + excess)); // s^3 - 1
          const L change  = group.volume() * 0.25 * (k.volume_change - thermal);
          *reinterpret_cast<typename L::Vector *>(changes) = change.v;
          prefetch<10 * width>(constants + groups_ahead * n_rows * width);
          healthy      = healthy & (k.jacobian.v > L(0.).v);
          last_offsets = offsets;
        }
      add_changes();
      return all(healthy);
    }
  } // namespace
} // namespace Cautery
