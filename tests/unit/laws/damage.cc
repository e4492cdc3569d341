// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check.h"

#include <cautery/laws/damage.h>

#include <cmath>
#include <iostream>

namespace Cautery::Test
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    void test_arrhenius()
    {
      Arrhenius law;
      expect("thesis constants at 340 K: ln A - E / (R T)",
             law.ln_rate(340., 0.),
             std::log(1.98) + 106. * std::log(10.) - 667000. / (8.314 * 340.));
      expect(
        "Omega = 1 after 1 / rate", law.ln_rate(340., 0.) + std::log(std::exp(-law.ln_rate(340., 0.))), 0.);
      expect("strain energy lowers the barrier by V_mol W",
             law.ln_rate(340., 1e5) - law.ln_rate(340., 0.),
             0.285 * 1e5 / (8.314 * 340.),
             1e-12);
      expect("strain energy above the barrier: faster than A",
             law.ln_rate(340., 3e6) - std::log(1.98e106),
             (0.285 * 3e6 - 667000.) / (8.314 * 340.),
             1e-11);
      expect("no damage at 0 K", law.ln_rate(0., 0.), -infinity);
      expect("nor below", law.ln_rate(-1., 0.), -infinity);

      read("set Constants = skin", law);
      expect("preset skin: A", law.frequency_factor, 3.1e98);
      expect("preset skin: E", law.activation_energy, 6.3e5);
      read("set Constants = retina", law);
      expect("preset retina: A", law.frequency_factor, 1e44);
      expect("preset retina: E", law.activation_energy, 2.9e5);
      read("set Constants = liver", law);
      expect("preset liver: A", law.frequency_factor, 1e70);
      expect("preset liver: E", law.activation_energy, 4e5);
      read("set Constants = thesis", law);
      expect("preset thesis: A", law.frequency_factor, 1.98e106);
      expect("preset thesis: E", law.activation_energy, 667000.);

      read("set Frequency factor = 1e300\nset Activation energy = 1e5", law);
      holds("A = 1e300 at 2000 K stays finite", std::isfinite(law.ln_rate(2000., 1e9)));
      expect("refused: a preset that does not exist",
             refusal<Arrhenius>("set Constants = kidney"),
             "Constants = kidney: choose one of: none, thesis, retina, skin, liver");
    }

    void test_doses()
    {
      Cem43        cem43;
      const double freezing = 273.15, hour = 3600.;
      const auto   dose = [&](const double celsius, const double seconds) {
        return std::exp(cem43.ln_rate(freezing + celsius)) * seconds;
      };
      expect("240 min at 43 C are lethal", dose(43., 4. * hour), 1., 1e-12);
      expect("120 min at 44 C too", dose(44., 2. * hour), 1., 1e-12);
      expect("1 min at 53 C counts 1024 min", dose(53., 60.), 1024. / 240., 1e-12);
      expect("240 min at 42 C count a quarter", dose(42., 4. * hour), 0.25, 1e-12);
      expect("at 37 C they count 1/4096", dose(37., 4. * hour), 1. / 4096., 1e-12);
      read("set Lethal dose = 60", cem43);
      expect("another lethal dose", dose(43., hour), 1., 1e-12);

      CriticalThermalLoad load;
      expect("100 W/m2 reach 1 MJ/m2 in 10000 s", load.ln_rate(100.) + std::log(1e4), 0., 1e-13);
      expect("no flux, no damage", load.ln_rate(0.), -infinity);
    }

    void test_ln_add()
    {
      for (const double a : {-3., 0.5, 40.})
        for (const double b : {-40., -3., 0.25, 41.})
          expect("ln(exp(" + to_text(a) + ") + exp(" + to_text(b) + "))",
                 ln_add(a, b),
                 static_cast<double>(
                   std::log(std::exp(static_cast<long double>(a)) + std::exp(static_cast<long double>(b)))));
      expect("far beyond the range of exp", ln_add(1e6, 1e6), 1e6 + std::log(2.));
      expect("nothing and something", ln_add(no_damage, 3.), 3., 0.);
      expect("something and nothing", ln_add(3., no_damage), 3., 0.);
      expect("nothing and nothing", ln_add(no_damage, no_damage), -infinity);
    }

    /** ln int_0^d exp(a + (b - a) t/d) dt by Simpson's rule in long double. */
    double quadrature(const double a, const double b, const double duration)
    {
      const int   n   = 20000;
      long double sum = 0.;
      for (int i = 0; i <= n; ++i)
        sum += (i == 0 || i == n ? 1 : (i % 2 == 1 ? 4 : 2)) *
               std::exp(static_cast<long double>(a) + (static_cast<long double>(b) - a) * i / n);
      return static_cast<double>(std::log(sum * duration / (3 * n)));
    }

    void test_ln_integral()
    {
      for (const double fall : {0., 1e-13, 1e-11, 1e-6, 0.1, 5., 60.})
        for (const double sign : {-1., 1.})
          expect("rate from exp(-2) by " + to_text(sign * fall),
                 ln_integral(-2., -2. + sign * fall, 3.),
                 quadrature(-2., -2. + sign * fall, 3.),
                 1e-11);
      // the rate of Eq. 2-2 for A = 1e300 at 2000 K, heated by 1 K in a second
      Arrhenius hot;
      read("set Frequency factor = 1e300", hot);
      const double from = hot.ln_rate(2000., 0.), to = hot.ln_rate(2001., 0.);
      expect("A = 1e300 at 2000 K", ln_integral(from, to, 1.), quadrature(from, to, 1.), 1e-11);
      expect("as long with strain energy", ln_integral(1e6, 1e6, 4.), 1e6 + std::log(4.));
      expect("never any rate", ln_integral(no_damage, no_damage, 1.), -infinity);
      expect("a rate that comes from or goes to nothing at once",
             ln_integral(no_damage, 5., 1.) + ln_integral(5., no_damage, 1.),
             -infinity);

      // second order for a smooth rate: temperature 330 + 10 t K, against many small steps
      const Arrhenius law;
      const auto      omega = [&law](const int steps) {
        double ln_omega = no_damage;
        for (int i = 0; i < steps; ++i)
          ln_omega = ln_add(ln_omega,
                            ln_integral(law.ln_rate(330. + 10. * i / steps, 0.),
                                        law.ln_rate(330. + 10. * (i + 1) / steps, 0.),
                                        1. / steps));
        return std::exp(ln_omega);
      };
      const double exact = omega(4096);
      expect("half the step, a quarter of the error", (omega(32) - exact) / (omega(64) - exact), 4., 0.01);
    }
  } // namespace

  void test_damage()
  {
    std::cout << "Arrhenius\n";
    test_arrhenius();
    std::cout << "Thermal doses\n";
    test_doses();
    std::cout << "Sums and integrals of logarithms\n";
    test_ln_add();
    test_ln_integral();
  }
} // namespace Cautery::Test
