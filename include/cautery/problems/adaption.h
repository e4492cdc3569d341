// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/problems/problem.h>

namespace Cautery
{
  /** A body, and what is simulated on it; nothing where the present one will do. */
  template <int dim>
  struct Adapted
  {
    std::unique_ptr<Body<dim>>    body;
    std::unique_ptr<Problem<dim>> problem;
  };

  /**
   * Replaces @p body and @p problem by those that the scene's first step needs: it is taken from the start,
   * and the mesh adapted, until that stays as it is. Does nothing where the scene's mesh does not adapt.
   * Errors: ExcInput, ExcRun. Collective.
   */
  template <int dim>
  void adapt_to_first_step(const Scene                   &scene,
                           std::unique_ptr<Body<dim>>    &body,
                           std::unique_ptr<Problem<dim>> &problem,
                           Cost                          &cost);

  /**
   * The body and problem that @p state needs. Where these are others, @p state is on their nodes afterwards,
   * and the problem goes on from it; @p problem must be there until then. Errors: ExcRun. Collective.
   */
  template <int dim>
  Adapted<dim>
  adapt(const Scene &scene, const Body<dim> &body, Problem<dim> &problem, State &state, Cost &cost);

  /** The same for a mesh with @p cells (see Mesh); the problem has not been started. Errors: ExcInput. */
  template <int dim>
  Adapted<dim>
  adapt(const Scene &scene, const Body<dim> &body, const std::vector<CellNumber> &cells, Cost &cost);
} // namespace Cautery
