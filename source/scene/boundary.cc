// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/boundary.h>

namespace Cautery
{
  void Boundary::parameters(Parameters &p)
  {
    p.entry("Surfaces",
            surfaces,
            "Surfaces of the mesh, by number or name (a box has x min, x max, y min, ...); `all`, or "
            "`remaining` for "
            "what no other boundary names");
    p.entry("Thermal",
            thermal,
            Choices<Thermal>{{"none", Thermal::missing},
                             {"temperature", Thermal::temperature},
                             {"flux", Thermal::flux},
                             {"convection", Thermal::convection},
                             {"insulated", Thermal::insulated}},
            "The thermal condition; needed where Heat is on");
    p.entry("Temperature",
            temperature,
            "K",
            "For `temperature`; an expression in x, y, z, t",
            Bounds::non_negative());
    p.entry("Flux", flux, "W/m2", "For `flux`, into the body; an expression in x, y, z, t");
    p.entry("Transfer coefficient",
            transfer_coefficient,
            "W/(m2 K)",
            "For `convection`; an expression in x, y, z",
            Bounds::non_negative());
    if (p.reading() && transfer_coefficient.depends_on_time())
      p.reject("Transfer coefficient", transfer_coefficient.text(), "it cannot depend on t");
    p.entry("Ambient temperature",
            ambient_temperature,
            "K",
            "For `convection`; an expression in x, y, z, t",
            Bounds::non_negative());
    p.entry("Mechanical",
            mechanical,
            Choices<Mechanical>{{"none", Mechanical::missing},
                                {"fixed", Mechanical::fixed},
                                {"free", Mechanical::free},
                                {"roller", Mechanical::roller},
                                {"displacement", Mechanical::displacement},
                                {"traction", Mechanical::traction}},
            "The mechanical condition; needed where Deformation is on; roller: no motion along the normal");
    p.entry("Displacement", displacement, "m", "For `displacement`; expressions in x, y, z, t");
    p.entry("Traction", traction, "Pa", "For `traction`; expressions in x, y, z, t");
  }

  void PointLoad::parameters(Parameters &p)
  {
    p.entry("Place", place, "m", "Where the force acts");
    p.entry("Force", force, "N", "The force; expressions in t");
  }
} // namespace Cautery
