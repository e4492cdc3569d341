// SPDX-License-Identifier: LGPL-2.1-or-later
#include "manufactured.h"

namespace Verification
{
  namespace
  {
    // scenes/manufactured.prm
    constexpr double capacity = 1., conductivity = 0.7, delay = 0.3, perfusion = 0.5, reference = 2.,
                     transfer = 1.5;
    constexpr double lambda = 1.5, mu = 1., poisson = 0.3, beta = 3. * (lambda + 2. * mu / 3.) * 0.1;
    constexpr double expansion = beta / (lambda + 2. * mu);

    std::string number(const double value) { return "(" + to_text(value) + ")"; }

    std::string sum(const std::string &a, const std::string &b) { return "(" + a + " + " + b + ")"; }

    std::string times(const double factor, const std::string &text)
    {
      return number(factor) + "*(" + text + ")";
    }

    bool relaxes(const Model model)
    {
      return model == Model::non_fourier || model == Model::two_way_non_fourier;
    }

    bool feeds_back(const Model model)
    {
      return model == Model::two_way_fourier || model == Model::two_way_non_fourier;
    }

    /// rho C, with what the feedback adds.
    double effective_capacity(const Model model)
    {
      return capacity + (feeds_back(model) ? beta * reference * expansion : 0.);
    }

    using Path      = std::string;
    const Path held = "Boundaries/held/", heated = "Boundaries/heated/", cooled = "Boundaries/cooled/";

    void choose_effects(const Model model, std::vector<Override> &scene)
    {
      if (has_heat(model))
        {
          scene.push_back({"Effects/Heat", relaxes(model) ? "non-Fourier" : "Fourier"});
          scene.push_back({"Effects/Perfusion", "on"});
        }
      if (has_deformation(model))
        scene.push_back({"Effects/Deformation", "equilibrium"});
      if (has_heat(model) && has_deformation(model))
        scene.push_back({"Effects/Coupling", feeds_back(model) ? "two-way" : "expansion"});
    }

    /**
     * T = T_0 + s theta(t) by the source s q(t) and, through surfaces, heat k grad s flux(t), with flux + tau
     * flux' = theta in the non-Fourier model.
     */
    void heat(const Product     &s,
              const std::string &theta,
              const std::string &source,
              const std::string &flux,
              Manufactured      &result)
    {
      const std::string temperature = number(reference) + " + " + s.value() + "*" + theta;
      // the cooled surface faces -z, the heated one +y
      const std::string out = times(-conductivity / transfer, s.derivative({2}) + "*" + flux);
      result.temperature    = {Expression(temperature)};
      auto &scene           = result.scene;
      scene.push_back({"Heat sources/Names", "rod"});
      scene.push_back({"Heat sources/rod/Type", "expression"});
      scene.push_back({"Heat sources/rod/Distribution", s.value() + "*" + source});
      scene.push_back({held + "Temperature", temperature});
      scene.push_back({heated + "Flux", times(conductivity, s.derivative({1}) + "*" + flux)});
      scene.push_back({cooled + "Ambient temperature", temperature + " + " + out});
    }

    std::string vector(const std::array<std::string, 3> &texts)
    {
      return texts[0] + "; " + texts[1] + "; " + texts[2];
    }

    /// @p u and the tractions on the surfaces that face +y and -z, all times theta(t).
    void deformation(const std::array<std::string, 3> &u,
                     const std::array<std::string, 3> &along_y,
                     const std::array<std::string, 3> &against_z,
                     const std::string                &theta,
                     Manufactured                     &result)
    {
      const auto in_time = [&theta](std::array<std::string, 3> texts) {
        for (auto &text : texts)
          text = "(" + text + ")*" + theta;
        return texts;
      };
      for (const auto &text : in_time(u))
        result.displacement.emplace_back(text);
      result.scene.push_back({held + "Displacement", vector(in_time(u))});
      result.scene.push_back({heated + "Traction", vector(in_time(along_y))});
      result.scene.push_back({cooled + "Traction", vector(in_time(against_z))});
    }

    /// u = m grad Phi: stress 2 mu m Phi_ij + (lambda m - beta) s delta_ij.
    void thermal_deformation(const Product     &phi,
                             const double       scale, ///< of @p phi
                             const std::string &s,
                             const std::string &theta,
                             Manufactured      &result)
    {
      const auto stress = [&](const unsigned int i, const unsigned int j, const double sign) {
        std::string text = times(sign * scale * 2. * mu * expansion, phi.derivative({i, j}));
        return i == j ? sum(text, times(sign * (lambda * expansion - beta), s)) : text;
      };
      std::array<std::string, 3> u, along_y, against_z;
      for (unsigned int i = 0; i < 3; ++i)
        {
          u[i]         = times(scale * expansion, phi.derivative({i}));
          along_y[i]   = stress(i, 1, 1.);
          against_z[i] = stress(i, 2, -1.);
        }
      deformation(u, along_y, against_z, theta, result);
    }

    /// Papkovich and Neuber: 2 mu u = 4 (1 - nu) b e_z - grad(z b) with a harmonic b.
    void elastic_deformation(const Product &b, Manufactured &result)
    {
      const auto stress = [&](const unsigned int i, const unsigned int j, const double sign) {
        std::string text = times(-sign, "z*" + b.derivative({i, j}));
        for (const auto &[axis, other] : {std::pair{i, j}, std::pair{j, i}})
          if (axis == 2)
            text = sum(text, times(sign * (1. - 2. * poisson), b.derivative({other})));
        return i == j ? sum(text, times(sign * 2. * poisson, b.derivative({2}))) : text;
      };
      std::array<std::string, 3> u, along_y, against_z;
      for (unsigned int i = 0; i < 3; ++i)
        {
          u[i]         = times(-0.5 / mu, "z*" + b.derivative({i}));
          along_y[i]   = stress(i, 1, 1.);
          against_z[i] = stress(i, 2, -1.);
        }
      u[2] = sum(u[2], times((3. - 4. * poisson) / (2. * mu), b.value()));
      deformation(u, along_y, against_z, "1", result);
    }
  } // namespace

  std::string Product::derivative(const std::vector<unsigned int> &axes) const
  {
    std::array<unsigned int, 3> orders{};
    for (const unsigned int axis : axes)
      ++orders[axis];
    return "(" + factors[0].at(orders[0]) + ")*(" + factors[1].at(orders[1]) + ")*(" +
           factors[2].at(orders[2]) + ")";
  }

  std::string name(const Model model)
  {
    switch (model)
      {
      case Model::fourier:
        return "Fourier";
      case Model::non_fourier:
        return "non-Fourier";
      case Model::elastic:
        return "elasticity";
      case Model::expansion:
        return "expansion, one way";
      case Model::two_way_fourier:
        return "two-way, Fourier";
      default:
        return "two-way, non-Fourier";
      }
  }

  bool has_heat(const Model model) { return model != Model::elastic; }

  bool has_deformation(const Model model) { return model != Model::fourier && model != Model::non_fourier; }

  Manufactured wave_in_space(const Model model)
  {
    Manufactured result;
    choose_effects(model, result.scene);
    if (model == Model::elastic)
      {
        const Product b = {{{{"sin(x)", "cos(x)", "-sin(x)"},
                             {"cos(y)", "-sin(y)", "-cos(y)"},
                             {"exp(sqrt(2)*z)", "sqrt(2)*exp(sqrt(2)*z)", "2*exp(sqrt(2)*z)"}}}};
        elastic_deformation(b, result);
        return result;
      }
    const Product    s          = {{{{"sin(2*x + 0.3)", "2*cos(2*x + 0.3)", "-4*sin(2*x + 0.3)"},
                                     {"cos(y)", "-sin(y)", "-cos(y)"},
                                     {"exp(z/2)", "exp(z/2)/2", "exp(z/2)/4"}}}};
    constexpr double eigenvalue = 4. + 1. - 0.25;
    constexpr double drain      = perfusion + conductivity * eigenvalue;
    // non-Fourier: the rate starts from zero and jumps with the source, rho C T'(0) = Q(0)
    const double      start = relaxes(model) ? delay * conductivity * eigenvalue / drain : 0.4;
    const double      lag   = relaxes(model) ? delay : 0.;
    const std::string theta = "(t + " + to_text(start) + ")";
    heat(s,
         theta,
         "(" + to_text(effective_capacity(model)) + " + " +
           times(drain, "t + " + to_text(relaxes(model) ? 0. : start)) + ")",
         "(t + " + number(start - lag) + ")",
         result);
    result.scene.push_back(
      {"Initial state/Temperature", number(reference) + " + " + times(start, s.value())});
    if (has_deformation(model))
      thermal_deformation(s, -1. / eigenvalue, s.value(), theta, result);
    return result;
  }

  Manufactured wave_in_time(const Model model)
  {
    Manufactured result;
    choose_effects(model, result.scene);
    // along z, so that the exchange with the surroundings changes in time too
    const Product     s     = {{{{"1", "0", "0"}, {"1", "0", "0"}, {"1 + z", "1", "0"}}}};
    const Product     phi   = {{{{"1", "0", "0"}, {"1", "0", "0"}, {"(1 + z)^3/6", "(1 + z)^2/2", "1 + z"}}}};
    const std::string theta = "sin(2*t)";
    const double      lag   = relaxes(model) ? 2. * delay : 0.;
    heat(s,
         theta,
         "(" + times(2. * effective_capacity(model), "cos(2*t)") + " + " + times(perfusion, theta) + ")",
         "(" + theta + " - " + times(lag, "cos(2*t)") + ")/" + number(1. + lag * lag),
         result);
    result.scene.push_back({"Initial state/Temperature", to_text(reference)});
    if (has_deformation(model))
      thermal_deformation(phi, 1., s.value(), theta, result);
    return result;
  }

  Manufactured straight(const Model model)
  {
    Manufactured result;
    choose_effects(model, result.scene);
    const Product s     = {{{{"1", "0", "0"}, {"1", "0", "0"}, {"1 + z", "1", "0"}}}};
    const Product phi   = {{{{"1", "0", "0"}, {"1", "0", "0"}, {"(1 + z)^3/6", "(1 + z)^2/2", "1 + z"}}}};
    const double  start = relaxes(model) ? 0. : 0.4; // the rate starts from zero and jumps with the source
    const double  lag   = relaxes(model) ? delay : 0.;
    const std::string theta = "(t + " + to_text(start) + ")";
    heat(s,
         theta,
         "(" + to_text(effective_capacity(model)) + " + " + times(perfusion, theta) + ")",
         "(t + " + number(start - lag) + ")",
         result);
    result.scene.push_back(
      {"Initial state/Temperature", number(reference) + " + " + times(start, s.value())});
    if (has_deformation(model))
      thermal_deformation(phi, 1., s.value(), theta, result);
    return result;
  }
} // namespace Verification
