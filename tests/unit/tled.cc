// SPDX-License-Identifier: LGPL-2.1-or-later
// The kernel of explicit dynamics in all instruction sets that this processor has, against the laws point by
// point, against closed forms, and against what must be conserved.
#include "tled/body.h"

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>

namespace Cautery::Test
{
  namespace
  {
    unsigned int bad = 0;

    /// Of hexahedra with one point, where it must change nothing.
    constexpr double hourglass = 0.1;

    void holds(const std::string &what, const bool truth)
    {
      bad += !truth;
      std::cout << (truth ? "  ok  " : "  BAD ") << what << '\n';
    }

    /** Is @p error, of the worst instruction set, at most @p tolerance? */
    void at_most(const std::string &what, const double error, const double tolerance)
    {
      bad += !(error <= tolerance);
      if (error <= tolerance)
        std::cout << "  ok  " << what << '\n';
      else
        std::cout << "  BAD " << what << ": " << error << " more than " << tolerance << '\n';
    }

    /** The largest of @p error(instruction set); not a number counts as infinite. */
    template <typename Error>
    double worst(const Error &error)
    {
      double result = 0.;
      for (const InstructionSet instruction_set : instruction_sets())
        {
          const double value = error(instruction_set);
          result = std::isnan(value) ? std::numeric_limits<double>::infinity() : std::max(result, value);
        }
      return result;
    }

    double difference(const Records &a, const Records &b)
    {
      double square = 0., scale = 0.;
      for (unsigned int i = 0; i < a.size(); ++i)
        {
          square += (a[i] - b[i]) * (a[i] - b[i]);
          scale += b[i] * b[i];
        }
      return std::sqrt(square / scale);
    }

    void test_lanes()
    {
      for (const Case &item : cases())
        for (const double size : {1e-4, 0.08})
          {
            const Body        body     = make_body(item);
            const Records     values   = random_values(body, size);
            const Records     expected = scalar_forces(body, values);
            const std::string what     = item.name + (size < 0.01 ? ", small" : ", large") + " deformation";
            at_most(what + ", double",
                    worst([&](const auto set) {
                      return difference(lane_forces<double>(body, values, set), expected);
                    }),
                    1e-13);
            at_most(what + ", single",
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
            at_most(item.name + ": the force is the slope of the energy",
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
          at_most(item.name + ": forces and heat flows sum to nothing",
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
          at_most(item.name + ": nor do they turn the body",
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
          at_most(item.name + ": no force in a body that moves as a whole",
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
              at_most(item.name + ", " + f.first,
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

    void test_conduction()
    {
      for (const Case &item : cases())
        if (item.choice.law == SweepChoice::Law::none)
          {
            const Body body   = make_body(item);
            Records    values = affine_values(body, Tensor<2, 3>(), {}, 0.);
            for (unsigned int n = 0; n < body.nodes.size(); ++n)
              values[4 * n + 3] = 7. - 50. * body.nodes[n][0];
            at_most(
              item.name +
                ": a gradient of -50 K/m: k times 50 W/m2 leave through the face x = 1, nothing stays inside",
              worst([&](const auto set) {
                const Records flows  = lane_forces<double>(body, values, set, hourglass);
                double        out    = 0.;
                double        inside = 0.;
                for (unsigned int n = 0; n < body.nodes.size(); ++n)
                  {
                    out -= body.nodes[n][0] > 1. - 1e-12 ? flows[4 * n + 3] : 0.;
                    inside = std::max(inside, is_inside(body, n) ? std::abs(flows[4 * n + 3]) : 0.);
                  }
                return std::abs(out / (50. * conductivity) - 1.) + inside;
              }),
              1e-13);
          }
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
        at_most(control == 0. ? "one point alone does not see it" : "and with control resists as promised",
                worst([&](const auto set) {
                  const TledKernel<double>   kernel = tled_kernel<double>(set);
                  const TledCells<8, double> cells(mesh, kernel.lanes, 1);
                  AlignedVector<double>      x(32), f(32);
                  std::copy(values.begin(), values.end(), x.begin());
                  CellSweep<double> sweep = cells.sweep({lambda, mu, nullptr, 0, 0., conductivity});
                  sweep.values            = x.data();
                  sweep.forces            = f.data();
                  sweep.hourglass         = control;
                  kernel.find({SweepChoice::Law::neo_hookean, StretchForm::none, 0, true, true})(sweep);
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

    void test_inversion()
    {
      const Body body =
        make_body({"neo-Hookean", {SweepChoice::Law::neo_hookean, StretchForm::none, 0, false}});
      const Records      values = random_values(body, 0.05);
      Records            turned = values;
      const unsigned int corner = body.tetrahedra.cells[77][2];
      turned[4 * corner] += 1.;
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
      const auto first_inverted = [&](const Records &state) {
        const TledCells<4, double> cells(body.tetrahedra, 8);
        return cells.inverted_cell(state.data());
      };
      holds("a sound body is found sound", verdict(values) == 1. && !first_inverted(values));
      holds("an inverted cell is seen", verdict(turned) == -1.);
      holds("one that is no number too", verdict(broken) == -1.);
      const auto cell = first_inverted(turned);
      holds("and found: it has the node that went astray",
            cell && std::count(
                      body.tetrahedra.cells[*cell].begin(), body.tetrahedra.cells[*cell].end(), corner) == 1);
    }

    /** One node: a spring in x, a load in y, a given rate in z, and cooling. */
    template <typename Number>
    double step_error(const InstructionSet set, const bool motion, const bool heat)
    {
      AlignedVector<Number> values(4), rates(4), forces(4), loads(4), keep(4), gain(4), exchange(4);
      const double          mass = 2., damping = 0.6, spring = 3., capacity = 5., cooling = 0.8, dt = 0.125;
      const double          sum = mass / dt + damping / 2.;
      for (int c = 0; c < 2; ++c)
        {
          keep[c] = (mass / dt - damping / 2.) / sum;
          gain[c] = 1. / sum;
        }
      keep[2]     = 1.;
      rates[2]    = 0.25;
      gain[3]     = dt / capacity / dt;
      exchange[0] = spring;
      exchange[3] = cooling;
      loads[1]    = 4.;
      values[0]   = 1.;
      values[3]   = 10.;

      NodeStep<Number> step;
      step.n_nodes  = 1;
      step.values   = values.data();
      step.rates    = rates.data();
      step.forces   = forces.data();
      step.loads    = loads.data();
      step.keep     = keep.data();
      step.gain     = gain.data();
      step.exchange = exchange.data();
      step.duration = dt;
      step.motion   = motion;
      step.heat     = heat;

      // Eq. 7-50 with x(-dt) from the initial rates, and Euler's forward step
      double       before[3] = {1., 0., -0.25 * dt}, now[3] = {1., 0., 0.}, temperature = 10.;
      const double k[2] = {spring, 0.}, load[2] = {0., 4.};
      for (int i = 0; i < 50; ++i)
        {
          forces[1] = 1.5; // an internal force
          tled_kernel<Number>(set).step(step);
          if (motion)
            {
              double next[3];
              for (int c = 0; c < 2; ++c)
                next[c] = (load[c] - (c == 1 ? 1.5 : 0.) - k[c] * now[c] + 2. * mass / (dt * dt) * now[c] -
                           (mass / (dt * dt) - damping / (2. * dt)) * before[c]) /
                          (mass / (dt * dt) + damping / (2. * dt));
              next[2] = 2. * now[2] - before[2];
              std::copy(now, now + 3, before);
              std::copy(next, next + 3, now);
            }
          if (heat)
            temperature -= dt * cooling / capacity * temperature;
        }
      double error = std::abs(values[3] - temperature);
      for (int c = 0; c < 3; ++c)
        error = std::max(error, std::abs(values[c] - now[c]));
      return error + std::abs(forces[1] - (motion ? 0. : 1.5));
    }

    void test_step()
    {
      at_most("central differences and Euler's step",
              worst([](const auto set) { return step_error<double>(set, true, true); }),
              1e-12);
      at_most("in single precision",
              worst([](const auto set) { return step_error<float>(set, true, true); }),
              1e-4);
      at_most(
        "motion only", worst([](const auto set) { return step_error<double>(set, true, false); }), 1e-12);
      at_most("heat only", worst([](const auto set) { return step_error<double>(set, false, true); }), 1e-12);
    }
  } // namespace
} // namespace Cautery::Test

int main(int argc, char **argv)
{
  using namespace Cautery::Test;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << "Lanes give what the laws give, point by point\n";
  test_lanes();
  std::cout << "Energy\n";
  test_energy();
  std::cout << "Conservation\n";
  test_conservation();
  std::cout << "Homogeneous deformation\n";
  test_homogeneous();
  std::cout << "Conduction\n";
  test_conduction();
  std::cout << "Hourglass of a cube\n";
  test_hourglass();
  std::cout << "Inverted cells\n";
  test_inversion();
  std::cout << "Step of the nodes\n";
  test_step();
  return bad == 0 ? 0 : 1;
}
