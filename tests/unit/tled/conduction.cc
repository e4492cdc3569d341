// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests.h"

#include <cmath>
#include <numeric>

namespace Cautery::Test
{
  namespace
  {
    /** T - T_0 = 7 - 50 X, and @p expected watts that leave through the face X = 1; nothing stays inside. */
    void test_flow(const Case &item, const std::string &what, const Tensor<2, 3> &f, const double expected)
    {
      const Body body   = make_body(item);
      Records    values = affine_values(body, f, {}, 0.);
      for (unsigned int n = 0; n < body.nodes.size(); ++n)
        values[4 * n + 3] = 7. - 50. * body.nodes[n][0];
      at_most(item.name,
              what,
              worst([&](const auto set) {
                const Records flows  = lane_forces<double>(body, values, set, hourglass);
                double        out    = 0.;
                double        inside = 0.;
                for (unsigned int n = 0; n < body.nodes.size(); ++n)
                  {
                    out -= body.nodes[n][0] > 1. - 1e-12 ? flows[4 * n + 3] : 0.;
                    inside = std::max(inside, is_inside(body, n) ? std::abs(flows[4 * n + 3]) : 0.);
                  }
                return std::abs(out / expected - 1.) + inside;
              }),
              1e-13);
    }

    /** Flows for @p temperature, K, of the nodes, displaced by @p values. */
    Records
    flows(const Body &body, Records values, const Records &temperature, const InstructionSet instruction_set)
    {
      for (unsigned int i = 3; i < values.size(); i += node_record)
        values[i] = temperature[i];
      Records result = lane_forces<double>(body, values, instruction_set, hourglass);
      for (unsigned int i = 0; i < result.size(); ++i)
        if (i % node_record != 3)
          result[i] = 0.;
      return result;
    }

    double product(const Records &a, const Records &b)
    {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    }
  } // namespace

  void test_conduction()
  {
    const Tensor<2, 3> identity = unit_symmetric_tensor<3>();
    const Tensor<2, 3> stretch({{1.6, 0., 0.}, {0., 0.9, 0.}, {0., 0., 0.7}});
    const Tensor<2, 3> shear({{1., 0.6, 0.}, {0., 1., 0.}, {0., 0., 1.}});
    const double       watts = 50. * conductivity; // through 1 m2 of the body as it was
    for (const Case &item : cases())
      {
        if (item.choice.law == SweepChoice::Law::none)
          test_flow(item, "-50 K/m", identity, watts);
        if (item.choice.conduction == SweepChoice::Conduction::reference)
          test_flow(item, "-50 K/m, the body stretched or not", stretch, watts);
        if (item.choice.conduction != SweepChoice::Conduction::deformed)
          continue;
        test_flow(item, "a gradient less steep, a face smaller", stretch, watts / 1.6 * (0.9 * 0.7));
        test_flow(item, "and turned", rotation() * stretch, watts / 1.6 * (0.9 * 0.7));
        // planes y = const slide along x: layers of T = const lean, nearer to each other by 1/sqrt(1 +
        // 0.6^2), their areas larger by its inverse
        test_flow(item, "sheared", shear, watts * (1. + 0.6 * 0.6));
      }
  }

  /** In a body deformed at random. */
  void test_deformed_conduction()
  {
    for (const Case &item : cases())
      if (item.choice.conduction == SweepChoice::Conduction::deformed)
        {
          const Body    body   = make_body(item);
          const Records values = random_values(body, 0.08);
          const Records one = random_values(body, 0.08), other = random_values(body, 0.08);
          Records       turned = affine_values(body, rotation(), {{0.3, -2., 5.}}, 0.);
          for (unsigned int n = 0; n < body.nodes.size(); ++n)
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j)
                turned[4 * n + i] += rotation()[i][j] * values[4 * n + j];
          const auto worst_of = [&](const std::string &what, const auto &error) {
            at_most(item.name, what, worst(error), 1e-13);
          };
          worst_of("conduction is symmetric", [&](const auto set) {
            const double there = product(one, flows(body, values, other, set));
            return std::abs(there - product(other, flows(body, values, one, set))) / std::abs(there);
          });
          worst_of("a rotation changes no flow", [&](const auto set) {
            return difference(flows(body, turned, one, set), flows(body, values, one, set));
          });
          holds(item.name,
                "heat never flows to where it is warmer",
                worst([&](const auto set) {
                  return -std::min(product(one, flows(body, values, one, set)),
                                   product(other, flows(body, values, other, set)));
                }) == 0.);
        }
  }
} // namespace Cautery::Test
