// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/output/nodal_columns.h>
#include <cautery/space/points.h>

#include <string>
#include <utility>
#include <vector>

namespace Cautery
{
  /**
   * Looks at the states at output times, and writes or keeps what it is for.
   */
  template <int dim>
  class Observer
  {
  public:
    virtual ~Observer() = default;

    /** What its time counts for in the ledger, e.g. "output: probes". */
    virtual std::string name() const = 0;

    /** The mesh has been adapted: these replace what it was made with. Collective. */
    virtual void use_mesh(const Field<dim> &, const PointLocator<dim> &, const BoundaryMap<dim> &) {}

    /** Collective. */
    virtual void observe(const Snapshot<dim> &snapshot) = 0;

    /** How far its files have come; where it brings back, what follows is cut off. Not collective. */
    virtual void archive(Archive &) {}
  };
} // namespace Cautery
