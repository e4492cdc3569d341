// SPDX-License-Identifier: LGPL-2.1-or-later
#include "large.h"

namespace Verification
{
  namespace
  {
    const std::vector<Override> stretched = {{"Boundaries/x0/Mechanical", "fixed"},
                                             {"Boundaries/y0/Mechanical", "free"},
                                             {"Boundaries/z0/Mechanical", "roller"},
                                             {"Boundaries/x1/Mechanical", "displacement"},
                                             {"Boundaries/x1/Displacement", "0.2; 0.05*z; 0"},
                                             {"Boundaries/y1/Mechanical", "traction"},
                                             {"Boundaries/y1/Traction", "0; 100; 50"},
                                             {"Effects/Gravity", "on"},
                                             {"Loads/Gravity", "0, 0, -0.1"}};
    const std::vector<Override> relaxed   = {{"Numerics/Large equilibrium", "dynamic relaxation"},
                                             {"Numerics/Relaxation/Tolerance", "1e-10"}};

    void compare(Checks &checks, const Element &element, const Variant &law, const Variant &heat)
    {
      const auto        all    = joined({bent_cube(element), law.overrides, heat.overrides, stretched});
      const std::string name   = element.name + ", " + law.name + heat.name;
      const Outcome     newton = run("large", all);
      checks.below(name + ": relaxed against Newton's method",
                   difference(run("large", joined({all, relaxed})), newton),
                   1e-6);
    }

    /// Fibres that are stretched by half stiffen, and steps become shorter by themselves.
    void stiffening(Checks &checks)
    {
      const auto                  all  = joined({bent_cube(elements[0]), laws[3].overrides});
      const std::vector<Override> fast = {{"Effects/Deformation", "explicit dynamics"},
                                          {"Boundaries/x1/Mechanical", "displacement"},
                                          {"Boundaries/x1/Displacement", "0.06*min(t, 10); 0; 0"},
                                          {"Numerics/Explicit/Damping", "4"}};
      const auto                  step = [](const Outcome &outcome) {
        return outcome.summary.at("statistics").at("stable_motion_step_s").get<double>();
      };
      const Outcome newton = run("large",
                                 joined({all,
                                         {{"Boundaries/x1/Mechanical", "displacement"},
                                          {"Boundaries/x1/Displacement", "0.6; 0; 0"}}}));
      const Outcome first  = run("large", joined({all, fast, {{"Time/End", "0.01"}}}));
      const Outcome moved  = run("large", joined({all, fast, {{"Time/End", "30"}}}));
      checks.below("fibres that stiffen: the last step over the first", step(moved) / step(first), 0.6);
      checks.below(
        "fibres that stiffen: moved to rest against Newton's method", difference(moved, newton), 1e-6);
    }

    /// Of a body that is pressed to half of its length, conduction needs shorter steps, and motion too: they
    /// follow, so no temperature leaves the range of the first ones, and a body without heat from outside
    /// becomes even.
    void pressed(Checks &checks)
    {
      const Outcome outcome  = run("large",
                                  {{"Mesh/Subdivisions", "6, 2, 2"},
                                    {"Effects/Heat", "Fourier"},
                                    {"Effects/Heat sources", "off"},
                                    {"Effects/Deformation", "explicit dynamics"},
                                    {"Effects/Conduction in", "deformed body"},
                                    {"Time/Integrator", "explicit"},
                                    {"Tissues/tissue/Conductivity", "6e4"},
                                    {"Tissues/tissue/Poisson's ratio", "0.2"},
                                    {"Initial state/Temperature", "310 + 10*sin(9*x)*cos(7*y)"},
                                    {"Boundaries/x1/Mechanical", "displacement"},
                                    {"Boundaries/x1/Displacement", "-0.05*min(t, 10); 0; 0"},
                                    {"Numerics/Explicit/Damping", "4"},
                                    {"Time/End", "300"}});
      const auto   &extremes = outcome.summary.at("extremes");
      checks.below("pressed to half: hottest, K", extremes.at("temperature_max_K"), 320.);
      checks.below(
        "pressed to half: less than the coldest, K", -extremes.at("temperature_min_K").get<double>(), -300.);
      checks.near("pressed to half: even in the end, K",
                  outcome.end("inside", "temperature_K"),
                  outcome.end("corner", "temperature_K"),
                  1e-3);
    }
  } // namespace

  void relaxation(Checks &checks)
  {
    for (const auto &element : {elements[0], elements[2]})
      for (const auto &law : laws)
        for (const auto &heat : heats)
          compare(checks, element, law, heat);
  }

  void motion(Checks &checks)
  {
    // the same body, let loose, damped, and looked at when it rests
    for (const auto &element : {elements[0], elements[2]})
      {
        const auto    all    = joined({bent_cube(element), laws[2].overrides, stretched});
        const Outcome newton = run("large", all);
        const Outcome moved =
          run("large",
              joined({all,
                      {{"Effects/Deformation", "explicit dynamics"},
                       {"Boundaries/x1/Displacement", "0.02*min(t, 10); 0.005*z*min(t, 10); 0"},
                       {"Boundaries/y1/Traction", "0; 10*min(t, 10); 5*min(t, 10)"},
                       {"Numerics/Explicit/Damping", "4"},
                       {"Time/End", "30"}}}));
        checks.below(
          element.name + ": moved to rest against Newton's method", difference(moved, newton), 1e-6);
      }
    stiffening(checks);
    pressed(checks);
  }
} // namespace Verification
