// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/parameters.h>
#include <cautery/laws/elastic_law.h>

namespace Cautery
{
  namespace
  {
    /** Calls @p work with the stretch's form as a constant. */
    template <typename Work>
    auto with_form(const StretchForm form, const Work &work)
    {
      switch (form)
        {
        case StretchForm::linearised:
          return work(std::integral_constant<StretchForm, StretchForm::linearised>());
        case StretchForm::exact:
          return work(std::integral_constant<StretchForm, StretchForm::exact>());
        default:
          return work(std::integral_constant<StretchForm, StretchForm::none>());
        }
    }

    /** @p factor times @p matrix. */
    Matrix3<double> scaled(const double factor, Matrix3<double> matrix)
    {
      for (double &entry : matrix.entries)
        entry *= factor;
      return matrix;
    }
  } // namespace

  double ElasticLaw::energy(const Matrix3<double> &gradient,
                            const Directions      &directions,
                            const double           thermal_strain) const
  {
    return with_form(stretch, [&](const auto form) {
      const double excess = stretch_excess<form()>(thermal_strain);
      if (const SmallStrain *law = std::get_if<SmallStrain>(&ground))
        {
          // the stress at rest is the thermal part, and the rest is linear
          const auto at_rest = point_stress<form()>(*law, nullptr, Matrix3<double>(), thermal_strain);
          const auto stress  = point_stress<form()>(*law, nullptr, gradient, thermal_strain);
          return 0.5 * (stress.factor * double_dot(stress.stress, gradient) +
                        at_rest.factor * double_dot(at_rest.stress, gradient));
        }
      const auto k      = elastic_part<form()>(gradient, excess);
      double     energy = std::get<NeoHookean>(ground).energy(k);
      for (unsigned int f = 0; f < fibres.size(); ++f)
        energy += fibres[f].energy(k, directions[f]);
      return energy * std::pow(1. + excess, 3);
    });
  }

  Matrix3<double> ElasticLaw::stress(const Matrix3<double> &gradient,
                                     const Directions      &directions,
                                     const double           thermal_strain) const
  {
    const auto add_fibres = [&](const Deformation<double> &k, Matrix3<double> &stress) {
      for (unsigned int f = 0; f < fibres.size(); ++f)
        fibres[f].add_stress(k, directions[f], stress);
    };
    return with_form(stretch, [&](const auto form) {
      return std::visit(
        [&](const auto &law) {
          const auto result = point_stress<form()>(law, add_fibres, gradient, thermal_strain);
          return scaled(result.factor, result.stress);
        },
        ground);
    });
  }

  Matrix3<double> ElasticLaw::stress_change(const Matrix3<double> &gradient,
                                            const Directions      &directions,
                                            const double           thermal_strain,
                                            const Matrix3<double> &change) const
  {
    return with_form(stretch, [&](const auto form) {
      const double excess = stretch_excess<form()>(thermal_strain);
      if (const SmallStrain *law = std::get_if<SmallStrain>(&ground))
        return scaled(form() == StretchForm::exact ? 1. / (1. + excess) : 1., law->stress(change));
      // P = s^2 P_e(H_e) and dH_e = dH / s
      const auto      k      = elastic_part<form()>(gradient, excess);
      Matrix3<double> result = std::get<NeoHookean>(ground).stress_change(k, change);
      for (unsigned int f = 0; f < fibres.size(); ++f)
        fibres[f].add_stress_change(k, directions[f], change, result);
      return scaled(1. + excess, result);
    });
  }

  void ElasticLaw::check() const
  {
    std::visit(
      [](const auto &law) {
        AssertThrow(law.mu > 0. && law.lambda + 2. / 3. * law.mu > 0.,
                    ExcInput("Lamé parameters lambda = " + to_text(law.lambda) + " Pa, mu = " +
                             to_text(law.mu) + " Pa: shear and bulk modulus must be positive"));
      },
      ground);
    AssertThrow(fibres.empty() || std::holds_alternative<NeoHookean>(ground),
                ExcInput("fibres need the neo-Hookean law: linear elasticity has none"));
    for (const Fibres &family : fibres)
      AssertThrow(family.stiffness >= 0. && family.stiffening > 0.,
                  ExcInput("fibres with k_1 = " + to_text(family.stiffness) + " Pa, k_2 = " +
                           to_text(family.stiffening) + ": k_1 must not be negative, k_2 must be positive"));
  }
} // namespace Cautery
