// SPDX-License-Identifier: LGPL-2.1-or-later
// The kernel of explicit dynamics in all instruction sets that this processor has, against the laws point by
// point, against closed forms, and against what must be conserved.
#include "tled/tests.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Cautery::Test
{
  namespace
  {
    void test_lanes()
    {
      for (const Case &item : cases())
        for (const double size : {1e-4, 0.08})
          {
            const Body        body     = make_body(item);
            const Records     values   = random_values(body, size);
            const Records     expected = scalar_forces(body, values);
            const std::string what     = size < 0.01 ? "small deformation" : "large deformation";
            at_most(item.name,
                    what + ", double",
                    worst([&](const auto set) {
                      return difference(lane_forces<double>(body, values, set), expected);
                    }),
                    1e-13);
            at_most(item.name,
                    what + ", single",
                    worst([&](const auto set) {
                      return difference(lane_forces<float>(body, values, set), expected);
                    }),
                    size < 0.01 ? 5e-5 : 1e-5);
          }
    }

    void test_energy()
    {
      for (const Case &item : cases())
        if (item.choice.law != SweepChoice::Law::none)
          {
            const Body    body      = make_body(item);
            const Records values    = random_values(body, 0.08);
            const Records direction = random_values(body, 0.08);
            const double  step      = 1e-4;
            const auto    energy_at = [&](const double s) {
              Records moved = values;
              for (unsigned int i = 0; i < moved.size(); ++i)
                if (i % node_record != 3)
                  moved[i] += s * direction[i];
              return energy(body, moved);
            };
            // differences of fourth order
            const double slope =
              (8. * (energy_at(step) - energy_at(-step)) - energy_at(2. * step) + energy_at(-2. * step)) /
              (12. * step);
            at_most(item.name,
                    "the force is the slope of the energy",
                    worst([&](const auto set) {
                      const Records forces = lane_forces<double>(body, values, set);
                      double        work = 0., force_norm = 0., direction_norm = 0.;
                      for (unsigned int i = 0; i < forces.size(); ++i)
                        if (i % node_record != 3)
                          {
                            work += forces[i] * direction[i];
                            force_norm += forces[i] * forces[i];
                            direction_norm += direction[i] * direction[i];
                          }
                      return std::abs(slope - work) / std::sqrt(force_norm * direction_norm);
                    }),
                    1e-7);
          }
    }

    void test_conservation()
    {
      for (const Case &item : cases())
        {
          const Body    body   = make_body(item);
          const Records values = random_values(body, 0.08);
          at_most(item.name,
                  "forces and heat flows sum to nothing",
                  worst([&](const auto set) {
                    const Records forces = lane_forces<double>(body, values, set, hourglass);
                    double        sum[4] = {}, scale[4] = {};
                    for (unsigned int i = 0; i < forces.size(); ++i)
                      {
                        sum[i % 4] += forces[i];
                        scale[i % 4] += std::abs(forces[i]);
                      }
                    double error = 0.;
                    for (int c = 0; c < 4; ++c)
                      error = std::max(error, std::abs(sum[c]) / (scale[c] + 1e-30));
                    return error;
                  }),
                  1e-14);
          if (item.choice.law != SweepChoice::Law::neo_hookean)
            continue;
          at_most(item.name,
                  "nor do they turn the body",
                  worst([&](const auto set) {
                    const Records forces = lane_forces<double>(body, values, set, hourglass);
                    double        sum = 0., scale = 0.;
                    for (unsigned int n = 0; n < body.nodes.size(); ++n)
                      {
                        const double x = body.nodes[n][0] + values[4 * n];
                        const double y = body.nodes[n][1] + values[4 * n + 1];
                        sum += x * forces[4 * n + 1] - y * forces[4 * n];
                        scale += std::abs(x * forces[4 * n + 1]) + std::abs(y * forces[4 * n]);
                      }
                    return std::abs(sum) / scale;
                  }),
                  1e-13);
          if (item.choice.stretch != StretchForm::none)
            continue;
          const double  area  = 1. / 9.; // of a small cube's face
          const Records moved = affine_values(body, rotation(), {{0.3, -2., 5.}}, 0.);
          at_most(item.name,
                  "no force in a body that moves as a whole",
                  worst([&](const auto set) {
                    const Records forces  = lane_forces<double>(body, moved, set, hourglass);
                    double        largest = 0.;
                    for (unsigned int i = 0; i < forces.size(); ++i)
                      if (i % node_record != 3)
                        largest = std::max(largest, std::abs(forces[i]));
                    return largest / (mu * area);
                  }),
                  1e-12);
        }
    }

    /** Homogeneous deformation: nothing inside, and on the face x = 1 what Eq. 7-14 says. */
    void test_homogeneous()
    {
      const std::vector<std::pair<std::string, Tensor<2, 3>>> deformations = {
        {"uniaxial stretch", Tensor<2, 3>({{1.4, 0., 0.}, {0., 0.9, 0.}, {0., 0., 0.9}})},
        {"biaxial stretch", Tensor<2, 3>({{1.3, 0., 0.}, {0., 1.2, 0.}, {0., 0., 0.7}})},
        {"shear", Tensor<2, 3>({{1., 0.6, 0.}, {0., 1., 0.}, {0., 0., 1.}})},
        {"compression to a tenth", Tensor<2, 3>({{0.1, 0., 0.}, {0., 1., 0.}, {0., 0., 1.}})},
        {"stretch to the fourfold", Tensor<2, 3>({{4., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}})}};
      for (const Case &item : cases())
        if (item.choice.law == SweepChoice::Law::neo_hookean)
          for (const auto &f : deformations)
            {
              const Body         body     = make_body(item);
              const double       heating  = item.choice.stretch == StretchForm::none ? 0. : 40.;
              const Records      values   = affine_values(body, f.second, {}, heating);
              const Tensor<2, 3> expected = textbook_first_stress(body, f.second, heating);
              at_most(item.name,
                      f.first,
                      worst([&](const auto set) {
                        const Records forces = lane_forces<double>(body, values, set, hourglass);
                        Tensor<1, 3>  traction;
                        double        inside = 0.;
                        for (unsigned int n = 0; n < body.nodes.size(); ++n)
                          for (int c = 0; c < 3; ++c)
                            {
                              if (body.nodes[n][0] > 1. - 1e-12)
                                traction[c] += forces[4 * n + c];
                              if (is_inside(body, n))
                                inside = std::max(inside, std::abs(forces[4 * n + c]));
                            }
                        const Tensor<1, 3> wanted({expected[0][0], expected[1][0], expected[2][0]});
                        return ((traction - wanted).norm() + inside) / wanted.norm();
                      }),
                      1e-12);
            }
    }

    /**
     * What locking of tetrahedra adds to the energy of a body that hardly changes its volume, in units of
     * what it should be, 2/3 mu c^2, for a bending that leaves volumes as they are: c (x y, -(x^2 + y^2) / 2,
     * 0).
     */
    double locking(const bool averaged_pressure, const InstructionSet set)
    {
      Case item                     = {"bending", {SweepChoice::Law::neo_hookean}};
      item.choice.averaged_pressure = averaged_pressure;
      Body body                     = make_body(item);
      body.lambda                   = 1e4 * mu;
      const double c                = 1e-6;
      Records      values(node_record * body.nodes.size());
      for (unsigned int n = 0; n < body.nodes.size(); ++n)
        {
          const double x = body.nodes[n][0], y = body.nodes[n][1];
          values[node_record * n]     = c * x * y;
          values[node_record * n + 1] = -c * (x * x + y * y) / 2.;
        }
      const Records forces = lane_forces<double>(body, values, set);
      return std::inner_product(forces.begin(), forces.end(), values.begin(), 0.) / (4. / 3. * mu * c * c) -
             1.;
    }

    void test_locking()
    {
      at_most("bending",
              "averaged pressure leaves a tenth of the locking",
              worst([](const auto set) { return locking(true, set) / locking(false, set); }),
              0.1);
    }

    /** A cube of 0.5 m whose corners move in x by h(y, z) = +-1 mm, and are warm by +-1 K: that is gamma. */
    void test_hourglass()
    {
      HexahedraMesh mesh;
      Records       values;
      for (unsigned int a = 0; a < 8; ++a)
        {
          mesh.nodes.emplace_back(0.5 * (a % 2), 0.5 * (a / 2 % 2), 0.5 * (a / 4));
          const double mode = (a / 2 % 2 == a / 4) ? 1. : -1.;
          values.insert(values.end(), {1e-3 * mode, 0., 0., mode});
        }
      mesh.cells = {{{0, 1, 2, 3, 4, 5, 6, 7}}};
      for (const double control : {0., 0.1})
        at_most("a cube",
                control == 0. ? "one point alone does not see it" : "and with control resists as promised",
                worst([&](const auto set) {
                  const TledKernel<double>   kernel = tled_kernel<double>(set);
                  const TledCells<8, double> cells(mesh, kernel.lanes, 1);
                  AlignedVector<double>      x(32), f(32);
                  std::copy(values.begin(), values.end(), x.begin());
                  CellSweep<double> sweep = cells.sweep({lambda, mu, nullptr, 0, 0., conductivity});
                  sweep.values            = x.data();
                  sweep.forces            = f.data();
                  sweep.hourglass         = control;
                  kernel.find({SweepChoice::Law::neo_hookean,
                               StretchForm::none,
                               0,
                               SweepChoice::Conduction::reference,
                               true})(sweep);
                  // |grad N_a|^2 = 3 (1 / (4 L))^2 at the centre of eight corners, gamma.u = 8 u
                  const double size  = control * 0.5 * 0.5 * 0.5 * 8. * 3. / (2. * 2.) * 8.;
                  double       error = 0.;
                  for (unsigned int i = 0; i < 32; ++i)
                    {
                      const double scale = i % 4 == 0 ? lambda + 2. * mu : i % 4 == 3 ? conductivity : 0.;
                      error              = std::max(error, std::abs(f[i] - size * scale * values[i]));
                    }
                  return error;
                }),
                1e-12);
    }

    void test_inversion(const Case &item)
    {
      const Body         body   = make_body(item);
      const Records      values = random_values(body, 0.05);
      Records            turned = values;
      const unsigned int corner =
        item.choice.hexahedra ? body.hexahedra.cells[14][2] : body.tetrahedra.cells[77][2];
      turned[4 * corner] += 3.;
      Records broken         = values;
      broken[4 * corner + 1] = std::nan("");
      // +1 where all instruction sets and precisions say so, -1 where none does
      const auto verdict = [&](const Records &state) {
        int sum = 0, n = 0;
        for (const InstructionSet set : instruction_sets())
          {
            sum += is_healthy<float>(body, state, set) ? 1 : -1;
            sum += is_healthy<double>(body, state, set) ? 1 : -1;
            n += 2;
          }
        return static_cast<double>(sum) / n;
      };
      holds(item.name, "a sound body is found sound", verdict(values) == 1.);
      holds(item.name, "an inverted cell is seen", verdict(turned) == -1.);
      holds(item.name, "one that is no number too", verdict(broken) == -1.);
      if (item.choice.hexahedra)
        return;
      const TledCells<4, double> cells(body.tetrahedra, 8);
      const auto                 cell = cells.inverted_cell(turned.data(), 0.);
      holds(item.name,
            "and found: it has the node that went astray",
            !cells.inverted_cell(values.data(), 0.) && cell &&
              std::count(body.tetrahedra.cells[cell->cell].begin(),
                         body.tetrahedra.cells[cell->cell].end(),
                         corner) == 1);
    }

    void test_inversions()
    {
      for (const Case &item : cases())
        if (item.choice.law == SweepChoice::Law::neo_hookean ||
            item.choice.conduction == SweepChoice::Conduction::deformed)
          test_inversion(item);
    }

  } // namespace
} // namespace Cautery::Test

int main(int argc, char **argv)
{
  using namespace Cautery::Test;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  section("Lanes give what the laws give, point by point", test_lanes);
  section("Energy", test_energy);
  section("Conservation", test_conservation);
  section("Homogeneous deformation", test_homogeneous);
  section("Conduction", test_conduction);
  section("Conduction in bodies deformed at random", test_deformed_conduction);
  section("Hourglass of a cube", test_hourglass);
  section("Locking", test_locking);
  section("Inverted cells", test_inversions);
  section("Pressures of the nodes", test_pressure);
  section("Step of the nodes", test_step);
  return all_good() ? 0 : 1;
}
