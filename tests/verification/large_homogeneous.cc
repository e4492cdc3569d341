// SPDX-License-Identifier: LGPL-2.1-or-later
#include "large.h"

#include <deal.II/lac/full_matrix.h>

namespace Verification
{
  namespace
  {
    using Tensor2 = Tensor<2, 3>;

    constexpr double young = 3000., poisson = 0.35; // scenes/large.prm
    constexpr double mu     = young / (2. * (1. + poisson));
    constexpr double lambda = young * poisson / ((1. + poisson) * (1. - 2. * poisson));
    constexpr double k_1 = 2363.2, k_2 = 0.8393;
    constexpr double thermal_strain = 2e-3 * 30.;
    const Tensor2    identity       = unit_symmetric_tensor<3>();

    /// Relative to the largest displacement, to the shear modulus.
    constexpr double exactly = 1e-10;

    /// What a point of a law does, by the textbook.
    struct Textbook
    {
      std::string law, heat; ///< the variants' names

      bool linear() const { return law == "linear"; }

      double stretch() const
      {
        return heat.empty()                         ? 1. :
               heat.find("linearised") != heat.npos ? 1. + thermal_strain :
                                                      std::exp(thermal_strain);
      }

      /// Eq. 7-14 with J = det F / s^3.
      Tensor2 second_stress(const Tensor2 &f, const double s) const
      {
        const Tensor2 c      = transpose(f) * f;
        const double  j      = determinant(f) / (s * s * s);
        Tensor2       result = s * s * s * (lambda * std::log(j) - mu) * invert(c) + s * mu * identity;
        if (law.find("fibres") != law.npos)
          for (const double sign : {1., -1.})
            {
              Tensor<1, 3> a({0.73, sign * 0.68, 0.});
              a /= a.norm();
              const double excess = a * (c * a) / (s * s) - 1.;
              if (excess > 0. || law == "with fibres that resist compression")
                result += 2. * s * k_1 * excess * std::exp(k_2 * excess * excess) * outer_product(a, a);
            }
        return result;
      }

      /// Eqs. 4-9 and 4-11.
      Tensor2 small_stress(const Tensor2 &f, const bool with_heat) const
      {
        const Tensor2 e = strain(f);
        const double  s = stretch(), bulk = lambda + 2. / 3. * mu;
        const bool    exact  = heat.find("exact") != heat.npos;
        Tensor2       result = lambda * trace(e) * identity + 2. * mu * e;
        if (exact)
          result /= s;
        if (with_heat)
          result -= (exact ? 1.5 * (s - 1. / s) : 3. * (s - 1.)) * bulk * identity;
        return result;
      }

      Tensor2 first_stress(const Tensor2 &f) const
      {
        return linear() ? small_stress(f, true) : f * second_stress(f, stretch());
      }

      Tensor2 strain(const Tensor2 &f) const
      {
        return linear() ? 0.5 * (f + transpose(f)) - identity : 0.5 * (transpose(f) * f - identity);
      }

      /// Cauchy's.
      Tensor2 stress(const Tensor2 &f) const
      {
        return linear() ? first_stress(f) : first_stress(f) * transpose(f) / determinant(f);
      }

      /// Without the thermal part of the stress.
      double energy(const Tensor2 &f) const
      {
        return 0.5 * scalar_product(linear() ? small_stress(f, false) : second_stress(f, 1.), strain(f));
      }

      /// The stretches along the axes under the nominal stresses @p given along them.
      Tensor2 stretched(const Tensor<1, 3> &given) const
      {
        Tensor2    f      = stretch() * identity;
        const auto excess = [&](const Tensor2 &at) {
          const Tensor2 p = first_stress(at);
          return Tensor<1, 3>({p[0][0], p[1][1], p[2][2]}) - given;
        };
        for (unsigned int iteration = 0; iteration < 50; ++iteration)
          {
            Tensor2 slope;
            for (unsigned int d = 0; d < 3; ++d)
              {
                Tensor2 ahead = f, behind = f;
                ahead[d][d] += 1e-6;
                behind[d][d] -= 1e-6;
                const Tensor<1, 3> change = (excess(ahead) - excess(behind)) / 2e-6;
                for (unsigned int c = 0; c < 3; ++c)
                  slope[c][d] = change[c];
              }
            const Tensor<1, 3> change = invert(slope) * excess(f);
            for (unsigned int d = 0; d < 3; ++d)
              f[d][d] -= change[d];
          }
        return f;
      }
    };

    void compare(Checks            &checks,
                 const std::string &what,
                 const Outcome     &outcome,
                 const Textbook    &textbook,
                 const Tensor2     &f)
    {
      const std::string axes = "xyz";
      const Point<3>    place(0.31, 0.52, 0.73);
      const Tensor2     stress = textbook.stress(f), strain = textbook.strain(f);
      const auto        found   = [&](const std::string &column) { return outcome.end("inside", column); };
      double            u_error = 0., strain_error = 0., stress_error = 0.;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double u = (f * place - place)[i];
          u_error = std::max(u_error, std::abs(found(std::string("displacement_") + axes[i] + "_m") - u));
          for (unsigned int j = i; j < 3; ++j)
            {
              const std::string ij = {axes[i], axes[j]};
              strain_error         = std::max(strain_error, std::abs(found("strain_" + ij) - strain[i][j]));
              stress_error = std::max(stress_error, std::abs(found("stress_" + ij + "_Pa") - stress[i][j]));
            }
        }
      checks.below(what + ": displacement, m", u_error, exactly);
      checks.below(what + ": strain", strain_error, exactly);
      checks.below(what + ": Cauchy stress over mu", stress_error / mu, 10. * exactly);
      checks.below(what + ": energy over mu",
                   std::abs(found("strain_energy_J_per_m3") - textbook.energy(f)) / mu,
                   10. * exactly);
    }

    std::string vector(const double x, const double y, const double z)
    {
      std::ostringstream text;
      text << std::setprecision(17) << x << "; " << y << "; " << z;
      return text.str();
    }

    /// Dead tractions on the upper faces, rollers on the lower ones.
    void pulled(Checks             &checks,
                const std::string  &what,
                const Element      &element,
                const Variant      &law,
                const Variant      &heat,
                const Tensor<1, 3> &nominal)
    {
      const Textbook textbook{law.name, heat.name};
      const Outcome  outcome = run("large",
                                  joined({bent_cube(element),
                                           law.overrides,
                                           heat.overrides,
                                           {{"Boundaries/x1/Mechanical", "traction"},
                                            {"Boundaries/x1/Traction", vector(nominal[0], 0., 0.)},
                                            {"Boundaries/y1/Mechanical", "traction"},
                                            {"Boundaries/y1/Traction", vector(0., nominal[1], 0.)}}}));
      compare(checks,
              element.name + ", " + law.name + heat.name + ", " + what,
              outcome,
              textbook,
              textbook.stretched(nominal));
    }

    /// x = F X on the whole boundary.
    std::vector<Override> moved(const Tensor2 &f)
    {
      const auto row = [&](const unsigned int i) {
        const Tensor2      h = f - identity;
        std::ostringstream text;
        text << std::setprecision(17) << '(' << h[i][0] << ")*x + (" << h[i][1] << ")*y + (" << h[i][2]
             << ")*z";
        return text.str();
      };
      std::vector<Override> result;
      for (const std::string face : {"x0", "y0", "z0", "x1", "y1", "z1"})
        {
          result.push_back({"Boundaries/" + face + "/Mechanical", "displacement"});
          result.push_back({"Boundaries/" + face + "/Displacement", row(0) + "; " + row(1) + "; " + row(2)});
        }
      return result;
    }

    const Tensor2 shear({{1.1, 0.6, 0.}, {0.1, 1., 0.2}, {0., 0.05, 0.9}});

    void sheared(Checks &checks, const Element &element, const Variant &law)
    {
      compare(checks,
              element.name + ", " + law.name + ", shear",
              run("large", joined({bent_cube(element), law.overrides, moved(shear)})),
              {law.name, ""},
              shear);
    }

    /// Damage at 340 K for 1 s, with the strain energy of Eq. 7-49, of a cube whose corners are all moved.
    void damaged(Checks &checks, const std::string &deformation, const Variant &law, const Variant &heat)
    {
      const double  energy  = Textbook{law.name, heat.name}.energy(shear);
      const Outcome outcome = run("large",
                                  joined({law.overrides,
                                          heat.overrides,
                                          moved(shear),
                                          {{"Mesh/Subdivisions", "1"},
                                           {"Effects/Deformation", deformation},
                                           {"Effects/Damage", "thermo-mechanical strain energy"},
                                           {"Damage/Quadrature", "end of step"}}}));
      checks.near(deformation + ", " + law.name + heat.name + ": ln Omega",
                  outcome.end("inside", "ln_damage"),
                  std::log(1.98e106) - (667000. - 0.285 * energy) / (8.314 * 340.),
                  1e-8);
    }
  } // namespace

  void homogeneous(Checks &checks)
  {
    for (const auto &element : elements)
      for (const auto &law : laws)
        {
          for (const auto &heat : heats)
            pulled(checks, "uniaxial", element, law, heat, Tensor<1, 3>({700., 0., 0.}));
          pulled(checks, "pressed", element, law, heats[0], Tensor<1, 3>({-800., 0., 0.}));
          pulled(checks, "biaxial", element, law, heats[0], Tensor<1, 3>({600., 900., 0.}));
          sheared(checks, element, law);
        }
    for (const std::string deformation : {"large equilibrium", "explicit dynamics"})
      for (const auto &law : laws)
        for (const auto &heat : {heats[1], heats[2]})
          damaged(checks, deformation, law, heat);
  }
} // namespace Verification
