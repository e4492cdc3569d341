// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/output/space_errors.h>
#include <cautery/physics/mechanical_fields.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * The state at an output time, complete: what is solved for at outputs only is up to date.
   */
  template <int dim>
  struct Snapshot
  {
    const State                 &state;
    const Field<dim>            &nodes;
    const Field<dim>            *displacement = nullptr; ///< none: deformation is off
    const MechanicalFields<dim> *mechanical   = nullptr;
    const Vector         *unbalanced_forces   = nullptr; ///< see Problem; only where reactions are written
    const GradientErrors *gradient_errors     = nullptr;
  };

  /**
   * A quantity at the nodes, with its unit in the name: a column of probes.csv, a field of the .vtu files.
   */
  struct NodalColumn
  {
    std::string name;
    Vector      values;
  };

  /** All quantities that are on, displacement by component; ln_damage where damage is on. */
  template <int dim>
  std::vector<NodalColumn> nodal_columns(const Snapshot<dim> &snapshot);
} // namespace Cautery
