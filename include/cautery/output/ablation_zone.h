// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/output/observer.h>

#include <map>
#include <vector>

namespace Cautery
{
  /**
   * The dead part of the body, Omega >= 1, at the last output time. Every cell is divided into simplices on
   * which ln(Omega) is linear; their dead parts are exact.
   */
  template <int dim>
  class AblationZone : public Observer<dim>
  {
  public:
    AblationZone(const Point<3> &centre, const Field<dim> &nodes);

    std::string name() const override { return "damage: ablation zone"; }
    void        observe(const Snapshot<dim> &snapshot) override;

    double                                      volume() const;                  ///< m^dim
    const std::map<types::material_id, double> &volumes() const { return dead; } ///< of each region, m^dim
    double radius() const { return largest; } ///< from the centre to the farthest dead point, m

  private:
    /// The corners of a linear simplex, all of them nodes of the cell: local numbers of their shape
    /// functions.
    using Part = std::vector<unsigned int>;

    void add_part(const std::vector<Point<dim>> &corners,
                  const std::vector<double>     &ln_damage,
                  const types::material_id       region);

    Point<dim>                           centre;
    std::vector<Part>                    parts;
    std::map<types::material_id, double> dead;
    double                               largest = 0.;
  };
} // namespace Cautery
