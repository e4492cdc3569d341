// SPDX-License-Identifier: LGPL-2.1-or-later
// How many tetrahedra a second the explicit kernel does on one core, for each instruction set and precision,
// in and out of cache: the coupled step (neo-Hookean, one family of fibres, exact thermal stretch, Fourier's
// heat, step of the nodes). Beside it, what it would be if the machine did nothing but arithmetic or nothing
// but moving memory, both measured in the same run. Usage: tled_kernel [deformed] [averaged]
// [CELLS_PER_EDGE...], with conduction in the deformed body, with averaged nodal pressure (its sweep of
// volumes and its step too).
#include "peak.h"

#include <cautery/physics/tled_cells.h>

#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>

namespace Cautery::Benchmark
{
  namespace
  {
    /** The shortest of some calls of @p work, in seconds; half a second of them at least. */
    template <typename Work>
    double shortest(const Work &work)
    {
      using Clock    = std::chrono::steady_clock;
      double best    = 1e9;
      double elapsed = 0.;
      while (elapsed < 0.5)
        {
          const auto start = Clock::now();
          work();
          const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
          best                 = std::min(best, seconds);
          elapsed += seconds;
        }
      return best;
    }

    /** A cube of 0.1 m, each of its n^3 small cubes cut into 6 tetrahedra, fibres at 45 degrees. */
    TetrahedraMesh cube(const unsigned int n)
    {
      TetrahedraMesh mesh;
      const auto     node = [n](const unsigned int i, const unsigned int j, const unsigned int k) {
        return (i * (n + 1) + j) * (n + 1) + k;
      };
      for (unsigned int i = 0; i <= n; ++i)
        for (unsigned int j = 0; j <= n; ++j)
          for (unsigned int k = 0; k <= n; ++k)
            mesh.nodes.emplace_back(0.1 * i / n, 0.1 * j / n, 0.1 * k / n);
      const int paths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int k = 0; k < n; ++k)
            for (const auto &path : paths)
              {
                unsigned int            at[3] = {i, j, k};
                TetrahedraMesh::Corners corners;
                corners[0] = node(i, j, k);
                for (int step = 0; step < 3; ++step)
                  {
                    ++at[path[step]];
                    corners[step + 1] = node(at[0], at[1], at[2]);
                  }
                mesh.cells.push_back(corners);
              }
      mesh.n_fibres = 1;
      mesh.directions.assign(mesh.cells.size(), {{std::sqrt(0.5), std::sqrt(0.5), 0.}});
      return mesh;
    }

    /** Seconds of one step, of the tissue of thesis Table 10. */
    template <typename Number>
    double seconds_per_step(const TetrahedraMesh &mesh,
                            const SweepChoice    &choice,
                            const InstructionSet  instruction_set)
    {
      const TledKernel<Number>   kernel = tled_kernel<Number>(instruction_set);
      const TledCells<4, Number> cells(mesh, kernel.lanes);
      const std::size_t          n = node_record * mesh.nodes.size();
      AlignedVector<Number>      values(n), rates(n), forces(n), loads(n), keep(n), gain(n);
      const std::vector<double>  volumes  = lumped_volumes(mesh);
      const double               duration = 0.02 * 0.1 / std::cbrt(mesh.cells.size() / 6.), damping = 250.;
      for (std::size_t i = 0; i < n; ++i)
        {
          const Point<3> &place = mesh.nodes[i / node_record];
          values[i]             = i % node_record == 3 ? 5. * std::sin(30. * place[0]) :
                                                         1e-3 * std::sin(40. * place[i % node_record] + i % node_record);
          const double mass     = 1000. * volumes[i / node_record];
          keep[i] =
            i % node_record == 3 ? 0. : (1. - damping * duration / 2.) / (1. + damping * duration / 2.);
          gain[i] =
            i % node_record == 3 ? 1. / (4192. * mass) : duration / (mass * (1. + damping * duration / 2.));
        }
      AlignedVector<Number> shares(mesh.nodes.size()), volume_changes(shares.size()),
        pressures(shares.size());
      std::copy(volumes.begin(), volumes.end(), shares.begin());
      const Fibres      fibres;
      CellSweep<Number> sweep              = cells.sweep({2347.3, 1006., &fibres, 1, 3e-4, 0.613});
      sweep.values                         = values.data();
      sweep.forces                         = forces.data();
      sweep.volume_changes                 = volume_changes.data();
      sweep.pressures                      = pressures.data();
      const NodePressures<Number> pressure = {mesh.nodes.size(),
                                              values.data(),
                                              shares.data(),
                                              volume_changes.data(),
                                              pressures.data(),
                                              choice.stretch,
                                              sweep.material};
      const auto step = node_step(mesh.nodes.size(), values, rates, forces, loads, keep, gain, duration);

      const auto   add_volumes = kernel.find_volumes(choice);
      const auto   add_forces  = kernel.find(choice);
      bool         healthy     = true;
      const double seconds     = shortest([&]() {
        if (choice.averaged_pressure)
          {
            healthy = add_volumes(sweep) && healthy;
            kernel.pressure(pressure);
          }
        healthy = add_forces(sweep) && healthy;
        kernel.step(step);
      });
      if (!healthy || !std::isfinite(values[0] + values[n / 2]))
        std::cout << "(the body broke: the figure below is worth nothing)\n";
      return seconds;
    }

    /** Bytes a second that one core adds two long arrays with. */
    double bandwidth()
    {
      const std::size_t   n = 1 << 24;
      std::vector<double> a(n, 1.), b(n, 2.);
      return 3. * sizeof(double) * n / shortest([&]() {
               for (std::size_t i = 0; i < n; ++i)
                 a[i] += 0.5 * b[i];
             });
    }

    /** What one core can do. */
    struct Machine
    {
      double operations_per_second;
      double bytes_per_second;
    };

    double operations_per_second(const Peak peak)
    {
      const std::size_t n = 1000000;
      return peak(n) / shortest([&]() { peak(n); });
    }

    template <typename Number>
    Peak peak(const InstructionSet instruction_set)
    {
      constexpr bool single = std::is_same_v<Number, float>;
      switch (instruction_set)
        {
        case InstructionSet::x86_64_v4:
          return single ? peak_float_x86_64_v4 : peak_double_x86_64_v4;
        case InstructionSet::x86_64_v3:
          return single ? peak_float_x86_64_v3 : peak_double_x86_64_v3;
        default:
          return single ? peak_float_x86_64 : peak_double_x86_64;
        }
    }

    /// Of the step without options, for a tetrahedron, in single and double precision: counted in the loop's
    /// machine code, a fused multiplication and addition as two.
    constexpr double operations_single = 460, operations_double = 490;

    /** Bytes that a step moves at least: a sweep reads values once and adds to forces, the step of the nodes
     * reads or writes nine records. */
    template <typename Number>
    double bytes(const TetrahedraMesh &mesh)
    {
      const std::size_t of_cell   = 4 * sizeof(std::uint32_t) + (10 + 3 * mesh.n_fibres) * sizeof(Number);
      const std::size_t of_record = node_record * sizeof(Number);
      return of_cell * mesh.cells.size() + (3 + 9) * of_record * mesh.nodes.size();
    }

    template <typename Number>
    void print_row(const TetrahedraMesh &mesh,
                   const SweepChoice    &choice,
                   const InstructionSet  instruction_set,
                   const Machine         machine)
    {
      constexpr bool single     = std::is_same_v<Number, float>;
      const double   seconds    = seconds_per_step<Number>(mesh, choice, instruction_set);
      const double   operations = (single ? operations_single : operations_double) * mesh.cells.size();
      std::cout << std::setw(10) << name(instruction_set) << std::setw(8) << (single ? "single" : "double")
                << std::setw(12) << mesh.cells.size() << std::setprecision(1) << std::setw(12)
                << mesh.cells.size() / seconds / 1e6 << std::setprecision(3) << std::setw(10)
                << 1e3 * seconds;
      if (choice.conduction == SweepChoice::Conduction::reference && !choice.averaged_pressure)
        std::cout << std::setw(12) << 1e3 * operations / machine.operations_per_second << std::setw(10)
                  << 1e3 * bytes<Number>(mesh) / machine.bytes_per_second;
      std::cout << std::endl;
    }

    template <typename Number>
    void print_rows(const std::vector<unsigned int> &edges,
                    const SweepChoice               &choice,
                    const InstructionSet             instruction_set,
                    const double                     bytes_per_second)
    {
      const Machine machine = {operations_per_second(peak<Number>(instruction_set)), bytes_per_second};
      for (const unsigned int n : edges)
        print_row<Number>(cube(n), choice, instruction_set, machine);
    }
  } // namespace
} // namespace Cautery::Benchmark

int main(int argc, char **argv)
{
  using namespace Cautery;
  using namespace Cautery::Benchmark;
  SweepChoice choice = {
    SweepChoice::Law::neo_hookean, StretchForm::exact, 1, SweepChoice::Conduction::reference};
  std::vector<unsigned int> edges;
  for (const std::string &argument : std::vector<std::string>(argv + 1, argv + argc))
    if (argument == "deformed")
      choice.conduction = SweepChoice::Conduction::deformed;
    else if (argument == "averaged")
      choice.averaged_pressure = true;
    else
      edges.push_back(std::stoul(argument));
  if (edges.empty())
    edges = {8, 20, 44, 70};

  const double bytes_per_second = bandwidth();
  std::cout << std::fixed << std::setw(10) << "" << std::setw(8) << "" << std::setw(12) << "tetrahedra"
            << std::setw(12) << "million/s" << std::setw(10) << "step, ms" << std::setw(12) << "arithmetic"
            << std::setw(10) << "memory" << std::endl;
  for (const InstructionSet instruction_set : instruction_sets())
    {
      print_rows<float>(edges, choice, instruction_set, bytes_per_second);
      print_rows<double>(edges, choice, instruction_set, bytes_per_second);
    }
  return 0;
}
