// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check.h"

#include <cautery/scene/tissue.h>

#include <cmath>
#include <iostream>

namespace Cautery::Test
{
  namespace
  {
    using Strain = SymmetricTensor<2, 3>;

    Strain diagonal(const double xx, const double yy, const double zz)
    {
      Strain strain;
      strain[0][0] = xx;
      strain[1][1] = yy;
      strain[2][2] = zz;
      return strain;
    }

    void test_blood()
    {
      const Tissue tissue = make_tissue("thesis type I");
      expect("perfusion, 0.5 kg/(m3 s) of 3600 J/(kg K)", tissue.perfusion.coefficient(), 1800.);
      expect("heat capacity rho C", tissue.thermal.heat_capacity(350.), 4192e3);
      Metabolism metabolism;
      expect("metabolism at the base temperature", metabolism.q10_heat(310.), 33800.);
      expect("10 K above", metabolism.q10_heat(320.), 67600.);
      expect("20 K below", metabolism.q10_heat(290.), 8450.);
      metabolism.q10 = 3.;
      expect("with another factor", metabolism.q10_heat(330.), 9. * 33800.);
      metabolism.q10 = 1.;
      expect("with none", metabolism.q10_heat(330.), 33800.);
    }

    void test_elasticity()
    {
      const double  young = 10.2e6, poisson = 0.35, e = 1e-3;
      LinearElastic elastic;
      const Lame    lame = elastic.lame(310.);
      expect("Lame's lambda", lame.lambda, young * poisson / (1.35 * 0.3));
      expect("Lame's mu", lame.mu, young / 2.7);
      expect("bulk modulus E / (3 (1 - 2 nu))", lame.bulk_modulus(), young / 0.9);
      const Strain pulled = lame.stress(diagonal(e, -poisson * e, -poisson * e));
      expect("pulled along x: stress E eps", pulled[0][0], young * e);
      expect("and none across", pulled[1][1] / young, 0., 1e-15);
      expect(
        "compressed on all sides: K tr(eps)", lame.stress(diagonal(-e, -e, -e))[2][2], -3. * e * young / 0.9);
      Strain sheared;
      sheared[0][1] = e;
      expect("sheared: 2 mu eps", lame.stress(sheared)[0][1], young / 1.35 * e);
      SymmetricTensor<2, 2> plane;
      plane[0][0] = e;
      plane[0][1] = 2. * e;
      Strain space;
      space[0][0] = e;
      space[0][1] = 2. * e;
      expect("plane strain is space without eps_zz",
             (lame.stress(plane)[1][1] + lame.stress(plane)[0][1]),
             lame.stress(space)[1][1] + lame.stress(space)[0][1]);

      elastic.poissons_ratio = 0.;
      expect("nu = 0: lambda = 0", elastic.lame(310.).lambda, 0.);
      elastic.poissons_ratio = 0.4999;
      expect("nu = 0.4999: K = E / (3 (1 - 2 nu))", elastic.lame(310.).bulk_modulus(), young / 0.0006, 1e-9);
      for (const std::string nu : {"0.5", "0.6", "-1"})
        expect("refused: nu = " + nu,
               refusal<LinearElastic>("set Poisson's ratio = " + nu),
               "Poisson's ratio = " + nu + ": it must be > -1 and < 0.5");
      elastic.youngs_modulus = TemperatureFunction("310: 10e6, 330: 5e6");
      expect("a modulus that falls with temperature", elastic.lame(320.).mu, 7.5e6 / (2. * 1.4999));
    }

    void test_expansion()
    {
      const Lame       lame = LinearElastic().lame(310.);
      ThermalExpansion linear, exact;
      exact.form = ThermalExpansion::Form::exact;

      expect("held in place, linear: 3 K alpha dT", linear.pressure_factor(360.), 3. * 3e-4 * 50.);
      const double s = std::exp(3e-4 * 50.);
      expect("held in place, exact: 3/2 (s - 1/s) K", exact.pressure_factor(360.), 1.5 * (s - 1. / s));
      expect("stiffness divided by s", exact.stiffness_factor(360.), 1. / s);
      expect("nothing at the reference temperature",
             std::abs(linear.pressure_factor(310.)) + std::abs(exact.pressure_factor(310.)) +
               std::abs(exact.stiffness_factor(310.) - 1.),
             0.);
      expect("free to expand, exact: no stress at Green's strain (s^2 - 1) / 2",
             exact.stiffness_factor(360.) *
                 trace(lame.stress(0.5 * (s * s - 1.) * unit_symmetric_tensor<3>())) / lame.bulk_modulus() -
               3. * exact.pressure_factor(360.),
             0.,
             1e-14);
      expect(
        "thermoelastic coefficient beta = 3 K alpha", linear.beta(lame, 400.), 10.2e6 * 3e-4 / (1. - 0.7));
      const double dT = 0.01;
      expect("the exact pressure starts with slope 3 alpha",
             (exact.pressure_factor(310. + dT) - exact.pressure_factor(310. - dT)) / (2. * dT),
             9e-4,
             1e-10);

      // the stress of both forms at a strain in proportion to dT: the difference is of second order
      const auto difference = [&](const double rise) {
        const double stress = trace(lame.stress(rise * diagonal(2e-4, 1e-4, -1e-4))) / lame.bulk_modulus();
        return (exact.stiffness_factor(310. + rise) - 1.) * stress -
               3. * (exact.pressure_factor(310. + rise) - linear.pressure_factor(310. + rise));
      };
      expect("both forms of the stress agree to second order", difference(0.2) / difference(0.1), 4., 1e-3);

      linear.coefficient = TemperatureFunction("310: 1e-4, 330: 3e-4");
      expect("alpha from a table: strain is its integral", linear.strain(330.), 4e-3);
      expect("below the reference temperature it shrinks", linear.strain(300.), -1e-3);
      holds("linear only with a constant and the linearised form",
            !linear.linear() && !exact.linear() && ThermalExpansion().linear());
    }

    void test_presets()
    {
      expect("all presets", join(tissue_presets()), "thesis type I, thesis type II, porcine liver");
      const Tissue second = make_tissue("thesis type II"), porcine = make_tissue("porcine liver");
      expect("type II: E", second.elastic.youngs_modulus.value(0.), 120e6);
      expect("type II: nu", second.elastic.poissons_ratio, 0.49);
      expect("porcine liver: rho C", porcine.thermal.heat_capacity(0.), 1050. * 3628.);
      expect("porcine liver: no perfusion", porcine.perfusion.coefficient(), 0.);
      expect("refused: a preset that does not exist",
             message_of([]() { make_tissue("kidney"); }),
             "there is no tissue preset `kidney`; choose one of: " + join(tissue_presets()));
    }
  } // namespace

  void test_tissue()
  {
    std::cout << "Blood and metabolism\n";
    test_blood();
    std::cout << "Elasticity\n";
    test_elasticity();
    std::cout << "Thermal expansion\n";
    test_expansion();
    std::cout << "Tissue presets\n";
    test_presets();
  }
} // namespace Cautery::Test
