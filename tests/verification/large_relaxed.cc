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
  }
} // namespace Verification
