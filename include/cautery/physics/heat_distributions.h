// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>
#include <cautery/space/assignment.h>
#include <cautery/space/field.h>
#include <cautery/space/points.h>

#include <functional>

namespace Cautery
{
  /** Where heat from outside enters the body. */
  struct HeatDistribution
  {
    /**
     * Adds what falls on the nodes at a time (s): to @p load in W for amplitude 1 and, where it is given, to
     * @p relaxed the same times the relaxation time of the tissue (W s). Neither is compressed.
     */
    std::function<void(const double time, Vector &load, Vector *relaxed)> assemble;

    bool changes = false; ///< in time?
  };

  /** Of a source, for amplitude 1. Errors: ExcInput for a point outside or a region that does not exist. */
  template <int dim>
  HeatDistribution source_distribution(const HeatSource        &source,
                                       const Field<dim>        &field,
                                       const TissueMap<dim>    &tissues,
                                       const PointLocator<dim> &locator);

  /** Of the flux through @p surfaces, where @p boundary has a thermal condition `flux` or `convection`. */
  template <int dim>
  HeatDistribution surface_distribution(const Boundary                     &boundary,
                                        const std::set<types::boundary_id> &surfaces,
                                        const Field<dim>                   &field,
                                        const TissueMap<dim>               &tissues);
} // namespace Cautery
