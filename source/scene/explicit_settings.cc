// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/explicit_settings.h>

namespace Cautery
{
  void ExplicitSettings::parameters(Parameters &p)
  {
    p.entry(
      "Precision",
      precision,
      Choices<Precision>{{"double", Precision::double_precision}, {"single", Precision::single_precision}},
      "Of the numbers that the loop computes with; single is twice as fast and right to some 6 digits");
    p.entry("Motion step",
            motion_step,
            "s",
            "Step of explicit dynamics; 0: the largest stable one times the safety factor",
            Bounds::non_negative());
    p.entry("Heat step",
            heat_step,
            "s",
            "Step of Time/Integrator = explicit; 0: the largest stable one times the safety factor",
            Bounds::non_negative());
    p.entry(
      "Safety factor",
      safety,
      "",
      "Share of the largest stable step that is taken, or 0.7 where fibres in tension only could resonate",
      Bounds{0., 1., true, false});
    p.entry("Unstable steps",
            unstable_steps,
            "Take the given steps although they are longer than those that are known to be stable");
    p.entry(
      "Damping", damping, "1/s", "Of explicit dynamics: force per mass and velocity", Bounds::non_negative());
    p.entry("Points of hexahedra",
            hexahedron_points,
            "Points of integration: 8, or 1 with hourglass control, which is faster",
            Bounds::between(1, 8));
    p.entry("Hourglass stiffness",
            hourglass,
            "",
            "Of hexahedra with 1 point: resistance to the motions that the point does not see, relative to "
            "that against compression",
            Bounds::between_open(0., 1.));
    p.entry(
      "Averaged pressure",
      averaged_pressure,
      "Tetrahedra take the mean pressure of their nodes, so that they do not lock where Poisson's ratio "
      "is near 0.5 (Bonet and Burton 1998)");
    if (p.reading() && hexahedron_points != 1 && hexahedron_points != 8)
      p.reject("Points of hexahedra", std::to_string(hexahedron_points), "it must be 8 or 1");
  }
} // namespace Cautery
