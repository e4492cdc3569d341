// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check.h"

#include <cautery/laws/elastic_law.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>
#include <iostream>
#include <random>

namespace Cautery::Test
{
  namespace
  {
    using Tensor2 = Tensor<2, 3>;

    const Tensor2 identity = unit_symmetric_tensor<3>();

    Matrix3<double> matrix(const Tensor2 &t)
    {
      Matrix3<double> result;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result(i, j) = t[i][j];
      return result;
    }

    Tensor2 tensor(const Matrix3<double> &m)
    {
      Tensor2 result;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result[i][j] = m(i, j);
      return result;
    }

    Tensor2 random_gradient(const double size)
    {
      static std::mt19937              generator(7);
      std::uniform_real_distribution<> number(-size, size);
      Tensor2                          result;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result[i][j] = number(generator);
      return result;
    }

    Tensor2 rotation()
    {
      const double c = std::cos(1.1), s = std::sin(1.1), d = std::cos(0.4), e = std::sin(0.4);
      return Tensor2({{c, -s, 0.}, {s, c, 0.}, {0., 0., 1.}}) *
             Tensor2({{1., 0., 0.}, {0., d, -e}, {0., e, d}});
    }

    struct Case
    {
      std::string name;
      ElasticLaw  law;
    };

    const double lambda = 2347.3, mu = 1006.;

    /// Any two unit vectors.
    const ElasticLaw::Directions directions = {{{0.6, 0.8, 0.}}, {{0.48, -0.6, 0.64}}};

    std::vector<Case> cases()
    {
      const Fibres tension = {2363.2, 0.8393, true}, both = {1500., 1.2, false};
      return {{"linear", {SmallStrain{lambda, mu}, {}}},
              {"neo-Hookean", {NeoHookean{lambda, mu}, {}}},
              {"with fibres in tension only", {NeoHookean{lambda, mu}, {tension}}},
              {"with fibres that resist compression", {NeoHookean{lambda, mu}, {both}}},
              {"with two families", {NeoHookean{lambda, mu}, {tension, both}}}};
    }

    const std::vector<std::pair<std::string, StretchForm>> forms = {
      {"", StretchForm::none},
      {", heated, linearised", StretchForm::linearised},
      {", heated, exact", StretchForm::exact}};

    /** Equation 7-14 with J = det F / s^3, word by word. */
    Tensor2 textbook_stress(const ElasticLaw &law, const Tensor2 &f, const double s)
    {
      const Tensor2 c      = transpose(f) * f;
      const double  j      = determinant(f) / (s * s * s);
      Tensor2       result = s * s * s * (lambda * std::log(j) - mu) * invert(c) + s * mu * identity;
      for (unsigned int i = 0; i < law.fibres.size(); ++i)
        {
          const auto        &v = directions[i].entries;
          const Tensor<1, 3> a({v[0], v[1], v[2]});
          const double       stretch = a * (c * a) / (s * s) - 1.;
          if (stretch > 0. || !law.fibres[i].tension_only)
            result += 2. * s * law.fibres[i].stiffness * stretch *
                      std::exp(law.fibres[i].stiffening * stretch * stretch) * outer_product(a, a);
        }
      return result;
    }

    Tensor2 second_stress(const ElasticLaw &law, const Tensor2 &f, const double thermal_strain)
    {
      const auto h = matrix(f - identity);
      return tensor(
        second_piola_kirchhoff_stress(Deformation<double>(h), law.stress(h, directions, thermal_strain)));
    }

    /** The largest error of stress and tangent against differences of energy and stress, over their norms. */
    std::pair<double, double> derivative_errors(const ElasticLaw &law, const double thermal_strain)
    {
      double stress_error = 0., tangent_error = 0.;
      for (int sample = 0; sample < 20; ++sample)
        {
          const Tensor2 h = random_gradient(0.3), change = random_gradient(1.);
          const double  step   = 1e-5;
          const auto    ahead  = matrix(h + step * change);
          const auto    behind = matrix(h - step * change);
          const Tensor2 stress = tensor(law.stress(matrix(h), directions, thermal_strain));
          const double  slope =
            (law.energy(ahead, directions, thermal_strain) - law.energy(behind, directions, thermal_strain)) /
            (2. * step);
          const Tensor2 bend = (tensor(law.stress(ahead, directions, thermal_strain)) -
                                tensor(law.stress(behind, directions, thermal_strain))) /
                               (2. * step);
          const Tensor2 tangent =
            tensor(law.stress_change(matrix(h), directions, thermal_strain, matrix(change)));
          stress_error = std::max(
            stress_error, std::abs(slope - scalar_product(stress, change)) / (stress.norm() * change.norm()));
          tangent_error = std::max(tangent_error, (bend - tangent).norm() / tangent.norm());
        }
      return {stress_error, tangent_error};
    }

    void test_derivatives()
    {
      for (Case item : cases())
        for (const auto &form : forms)
          {
            item.law.stretch    = form.second;
            const double strain = form.second == StretchForm::none ? 0. : 0.02;
            const auto   errors = derivative_errors(item.law, strain);
            expect(item.name + form.first + ": stress is the slope of the energy", errors.first, 0., 1e-8);
            expect(item.name + form.first + ": tangent is the slope of the stress", errors.second, 0., 1e-8);
          }
    }

    void test_closed_forms()
    {
      const std::vector<std::pair<std::string, Tensor2>> deformations = {
        {"uniaxial", Tensor2({{1.4, 0., 0.}, {0., 0.9, 0.}, {0., 0., 0.9}})},
        {"biaxial", Tensor2({{1.3, 0., 0.}, {0., 1.2, 0.}, {0., 0., 0.7}})},
        {"shear", Tensor2({{1., 0.6, 0.}, {0., 1., 0.}, {0., 0., 1.}})},
        {"compression to a tenth", Tensor2({{0.1, 0., 0.}, {0., 1., 0.}, {0., 0., 1.}})},
        {"any", identity + random_gradient(0.3)}};
      for (Case item : cases())
        if (item.name != "linear")
          for (const auto &form : forms)
            for (const auto &f : deformations)
              {
                item.law.stretch       = form.second;
                const double  strain   = 0.02;
                const double  s        = form.second == StretchForm::none       ? 1. :
                                         form.second == StretchForm::linearised ? 1. + strain :
                                                                                  std::exp(strain);
                const Tensor2 expected = textbook_stress(item.law, f.second, s);
                const Tensor2 error    = second_stress(item.law, f.second, strain) - expected;
                expect(item.name + form.first + ", " + f.first + ": Eq. 7-14",
                       error.norm() / expected.norm(),
                       0.,
                       1e-13);
              }
    }

    void test_objectivity()
    {
      for (Case item : cases())
        if (item.name != "linear")
          {
            item.law.stretch       = StretchForm::exact;
            const Tensor2 f        = identity + random_gradient(0.3);
            const Tensor2 stress   = second_stress(item.law, f, 0.02);
            const Tensor2 rotated  = second_stress(item.law, rotation() * f, 0.02);
            const Tensor2 symmetry = stress - transpose(stress);
            expect(item.name + ": S does not see a rotation",
                   (rotated - stress).norm() / stress.norm(),
                   0.,
                   1e-12);
            expect(item.name + ": S is symmetric", symmetry.norm() / stress.norm(), 0., 1e-13);
            const auto    h = matrix(f - identity);
            const Tensor2 cauchy =
              tensor(cauchy_stress(Deformation<double>(h), item.law.stress(h, directions, 0.02)));
            expect(item.name + ": Cauchy's is F S F' / J",
                   (cauchy - f * stress * transpose(f) / determinant(f)).norm() / cauchy.norm(),
                   0.,
                   1e-13);
            expect(item.name + ": no stress in a rotation, unheated",
                   second_stress(item.law, rotation(), 0.).norm() / mu,
                   0.,
                   1e-13);
            expect(item.name + ": free thermal stretch has no stress",
                   second_stress(item.law, std::exp(0.02) * rotation(), 0.02).norm() / mu,
                   0.,
                   1e-13);
          }
    }

    void test_small_strain()
    {
      const Tensor2    h = random_gradient(1e-7);
      const ElasticLaw linear{SmallStrain{lambda, mu}, {}}, neo_hookean{NeoHookean{lambda, mu}, {}};
      const Tensor2    strain = 0.5 * (h + transpose(h));
      const Tensor2    hooke  = lambda * trace(strain) * identity + 2. * mu * strain;
      expect(
        "linear: Hooke", (tensor(linear.stress(matrix(h), {}, 0.)) - hooke).norm() / hooke.norm(), 0., 1e-14);
      expect("neo-Hookean: Hooke in the limit",
             (tensor(neo_hookean.stress(matrix(h), {}, 0.)) - hooke).norm() / hooke.norm(),
             0.,
             1e-6);

      const ElasticLaw linearised{SmallStrain{lambda, mu}, {}, StretchForm::linearised};
      const ElasticLaw exact{SmallStrain{lambda, mu}, {}, StretchForm::exact};
      const double     bulk = lambda + 2. / 3. * mu, s = std::exp(0.02);
      const Tensor2    h_large = random_gradient(0.1), e = 0.5 * (h_large + transpose(h_large));
      const Tensor2    large = lambda * trace(e) * identity + 2. * mu * e;
      const Tensor2    cold  = large - 3. * bulk * 0.02 * identity;
      const Tensor2    hot   = large / s - 1.5 * (s - 1. / s) * bulk * identity;
      expect("linear, heated: Eq. 4-11",
             (tensor(linearised.stress(matrix(h_large), {}, 0.02)) - cold).norm() / cold.norm(),
             0.,
             1e-14);
      expect("linear, heated, exact: Eq. 4-9",
             (tensor(exact.stress(matrix(h_large), {}, 0.02)) - hot).norm() / hot.norm(),
             0.,
             1e-14);
    }

    void test_refusals()
    {
      const auto message = [](const ElasticLaw &law) { return message_of([&law]() { law.check(); }); };
      expect("good parameters", message(cases().back().law), "ACCEPTED");
      expect("no shear modulus",
             message({NeoHookean{1., 0.}, {}}),
             "Lamé parameters lambda = 1 Pa, mu = 0 Pa: shear and bulk modulus must be positive");
      expect("fibres without the neo-Hookean law",
             message({SmallStrain{lambda, mu}, {Fibres()}}),
             "fibres need the neo-Hookean law: linear elasticity has none");
      expect("fibres that do not stiffen",
             message({NeoHookean{lambda, mu}, {{1., 0., true}}}),
             "fibres with k_1 = 1 Pa, k_2 = 0: k_1 must not be negative, k_2 must be positive");
    }
  } // namespace

  void test_large_deformation()
  {
    std::cout << "Stress and tangent by finite differences\n";
    test_derivatives();
    std::cout << "Stress in homogeneous deformation\n";
    test_closed_forms();
    std::cout << "Rotations\n";
    test_objectivity();
    std::cout << "Small strain\n";
    test_small_strain();
    std::cout << "Refusals\n";
    test_refusals();
  }
} // namespace Cautery::Test
