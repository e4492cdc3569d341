// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/laws/fibre_family.h>

namespace Cautery
{
  Vector3<double> FibreFamily::unit_direction(const Point<3> &place) const
  {
    const Tensor<1, 3> vector = direction.value(place, 0.);
    const double       length = vector.norm();
    AssertThrow(
      length > 0.,
      ExcInput("Fibre direction = " + direction.text() + ": it has no length at " + to_text(place)));
    return {{vector[0] / length, vector[1] / length, vector[2] / length}};
  }

  void FibreFamily::parameters(Parameters &p)
  {
    p.entry("Fibre stiffness", law.stiffness, "Pa", "k_1 of the fibres", Bounds::non_negative());
    p.entry("Fibre stiffening", law.stiffening, "", "k_2 of the fibres", Bounds::positive());
    p.entry("Fibres in tension only",
            law.tension_only,
            "Fibres that are shorter than at rest bear no load; false: as in the thesis");
    p.entry("Fibre direction",
            direction,
            "",
            "Where the fibres run in the undeformed body, any length, in x, y, z");
    if (p.reading() && direction.depends_on_time())
      p.reject("Fibre direction", direction.text(), "it must not depend on t");
  }
} // namespace Cautery
