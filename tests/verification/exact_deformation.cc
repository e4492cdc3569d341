// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chain.h"

namespace Verification
{
  namespace
  {
    // the thesis's type I tissue, 30 K warmer than its stress-free state
    constexpr double young = 10.2e6, poisson = 0.35, expansion = 3e-4, warming = 30.;
    constexpr double mu     = young / (2. * (1. + poisson));
    constexpr double lambda = young * poisson / ((1. + poisson) * (1. - 2. * poisson));
    constexpr double bulk   = lambda + 2. * mu / 3.;

    /// Solutions of degree 1 in the space of the elements: right to the solver's tolerance.
    constexpr double exactly = 1e-9;

    const std::vector<std::vector<Override>> elements = {
      {{"Mesh/Cells", "tetrahedra"}, {"Numerics/Element degree", "1"}},
      {{"Mesh/Cells", "tetrahedra"}, {"Numerics/Element degree", "2"}},
      {{"Mesh/Cells", "hexahedra"}, {"Numerics/Element degree", "1"}},
      {{"Mesh/Cells", "hexahedra"}, {"Numerics/Element degree", "2"}}};

    std::string label(const std::vector<Override> &element)
    {
      return element[0].value + " of degree " + element[1].value;
    }

    Outcome warm_block(const std::vector<Override> &element, const std::vector<Override> &more)
    {
      auto all = element;
      all.insert(all.end(), more.begin(), more.end());
      return run("warm_block", all);
    }

    /// The block of 10 mm expands by the strain @p e along x and by @p across along y, z under the stresses
    /// @p xx and @p yy.
    void check_block(Checks            &checks,
                     const std::string &what,
                     const Outcome     &outcome,
                     const double       e,
                     const double       across,
                     const double       xx,
                     const double       yy)
    {
      const double pressure = 3. * bulk * expansion * warming;
      const auto   value    = [&](const std::string &column) { return outcome.end("inside", column); };
      checks.near(what + ", u_x, m", value("displacement_x_m"), e * 0.0031, exactly * 0.01);
      checks.near(what + ", u_y, m", value("displacement_y_m"), across * 0.0052, exactly * 0.01);
      checks.near(what + ", strain_zz", value("strain_zz"), across, exactly);
      checks.near(what + ", stress_xx, Pa", value("stress_xx_Pa"), xx, exactly * pressure);
      checks.near(what + ", stress_yy, Pa", value("stress_yy_Pa"), yy, exactly * pressure);
      checks.near(what + ", stress_xy, Pa", value("stress_xy_Pa"), 0., exactly * pressure);
    }

    void thermal_expansion(Checks &checks)
    {
      const double   e        = expansion * warming;
      const double   pressure = 3. * bulk * e;
      const double   stretch  = std::exp(e);
      const double   squeezed = pressure / (lambda + 2. * mu); // strain where only x is free
      const Override exact    = {"Tissues/tissue/Thermal stretch", "exact"};
      for (const auto &element : elements)
        {
          const std::string name = label(element) + ": ";
          check_block(checks, name + "free expansion", warm_block(element, {}), e, e, 0., 0.);
          check_block(checks,
                      name + "clamped",
                      warm_block(element,
                                 {{"Boundaries/outer/Mechanical", "fixed"},
                                  {"Boundaries/sliding/Mechanical", "fixed"}}),
                      0.,
                      0.,
                      -pressure,
                      -pressure);
          check_block(checks,
                      name + "free along x only",
                      warm_block(element,
                                 {{"Boundaries/Names", "sliding, outer, end"},
                                  {"Boundaries/outer/Mechanical", "roller"},
                                  {"Boundaries/end/Surfaces", "x max"},
                                  {"Boundaries/end/Thermal", "insulated"},
                                  {"Boundaries/end/Mechanical", "free"}}),
                      squeezed,
                      0.,
                      0.,
                      lambda * squeezed - pressure);
          // S = 0 where the Green strain is (s^2 - 1) / 2; held in place S = -3/2 (s - 1/s) K
          const double green = 0.5 * (stretch * stretch - 1.);
          check_block(checks,
                      name + "free expansion, exact stretch",
                      warm_block(element, {exact}),
                      green,
                      green,
                      0.,
                      0.);
          const double held = -1.5 * (stretch - 1. / stretch) * bulk;
          check_block(
            checks,
            name + "clamped, exact stretch",
            warm_block(
              element,
              {exact, {"Boundaries/outer/Mechanical", "fixed"}, {"Boundaries/sliding/Mechanical", "fixed"}}),
            0.,
            0.,
            held,
            held);
        }
    }

    void patch_test(Checks &checks)
    {
      // the scene's gradient, row by row
      const double gradient[3][3] = {{0.01, 0.02, -0.005}, {0.004, -0.01, 0.006}, {0.003, 0.007, 0.008}};
      const std::map<std::string, Point<3>> places = {{"tumour", {0.062, 0.066, 0.080}},
                                                      {"front", {0.045, 0.045, 0.080}}};
      for (const std::string degree : {"1", "2"})
        {
          const Outcome outcome = run("patch", {{"Numerics/Element degree", degree}});
          for (const auto &[probe, place] : places)
            {
              const std::string what = "patch test on the liver, degree " + degree + ", " + probe + ", ";
              checks.near(what + "T, K",
                          outcome.end(probe, "temperature_K"),
                          310. + 100. * place[0] - 50. * place[1] + 20. * place[2],
                          exactly * 10.);
              for (unsigned int i = 0; i < 3; ++i)
                {
                  const std::string axis(1, "xyz"[i]);
                  double            u = 0.;
                  for (unsigned int j = 0; j < 3; ++j)
                    u += gradient[i][j] * place[j];
                  checks.near(what + "u_" + axis + ", m",
                              outcome.end(probe, "displacement_" + axis + "_m"),
                              u,
                              exactly * 1e-3);
                  checks.near(what + "strain_" + axis + axis,
                              outcome.end(probe, "strain_" + axis + axis),
                              gradient[i][i],
                              exactly * 0.01);
                }
              checks.near(what + "strain_yz",
                          outcome.end(probe, "strain_yz"),
                          0.5 * (gradient[1][2] + gradient[2][1]),
                          exactly * 0.01);
            }
        }
    }

    /// Own weight: (lambda + 2 mu) u' = -rho g (H - z); a parabola, in the space of degree 2, and linear
    /// elements meet it at nodes.
    void own_weight(Checks &checks)
    {
      const double height = 0.1;
      const auto   exact  = [&](const double z) {
        return -1000. * 9.81 / (lambda + 2. * mu) * (height * z - 0.5 * z * z);
      };
      for (const auto &element : elements)
        {
          if (label(element) == "tetrahedra of degree 1")
            continue; // does not hold the column's sections plane
          auto all = element;
          all.push_back({"Effects/Gravity", "on"});
          auto changing = all; // without heat, tissue has its reference temperature, 310 K
          changing.push_back({"Effects/Temperature-dependent properties", "on"});
          changing.push_back({"Tissues/tissue/Young's modulus", "10.2e6 * (1 - 0.003 * (T - 310))"});
          for (const auto &[name, overrides] : {std::pair{"", all}, std::pair{" with E(T)", changing}})
            {
              const Outcome outcome = run("column", overrides);
              for (const auto &[probe, z] : {std::pair{"top", 0.1}, std::pair{"middle", 0.05}})
                checks.near(label(element) + ": column" + name + " under its own weight, " + probe +
                              ", u_z, m",
                            outcome.end(probe, "displacement_z_m"),
                            exact(z),
                            exactly * std::abs(exact(0.1)));
            }
        }
    }

    /// Forces on the four corners of the top, 0.25 N each, are the load of an even traction on one
    /// hexahedron: F z / (A (lambda + 2 mu)).
    void corner_loads(Checks &checks)
    {
      std::vector<Override> overrides = {{"Mesh/Cells", "hexahedra"}, {"Loads/Names", "a, b, c, d"}};
      const std::vector<std::pair<std::string, std::string>> corners = {
        {"a", "0, 0, 0.1"}, {"b", "0.01, 0, 0.1"}, {"c", "0, 0.01, 0.1"}, {"d", "0.01, 0.01, 0.1"}};
      for (const auto &[name, place] : corners)
        {
          overrides.push_back({"Loads/" + name + "/Place", place});
          overrides.push_back({"Loads/" + name + "/Force", "0; 0; 0.25"});
        }
      const double exact = 0.1 / (1e-4 * (lambda + 2. * mu));
      checks.near("forces at points, u_z, m",
                  run("column", overrides).end("top", "displacement_z_m"),
                  exact,
                  exactly * exact);
      for (const std::string cells : {"tetrahedra", "hexahedra"})
        checks.near("the same as a traction, " + cells + ", u_z, m",
                    run("column",
                        {{"Mesh/Cells", cells},
                         {"Boundaries/top/Mechanical", "traction"},
                         {"Boundaries/top/Traction", "0; 0; 1e4"}})
                      .end("top", "displacement_z_m"),
                    exact,
                    exactly * exact);
    }
  } // namespace

  void deformation(Checks &checks)
  {
    thermal_expansion(checks);
    patch_test(checks);
    own_weight(checks);
    corner_loads(checks);
  }
} // namespace Verification
