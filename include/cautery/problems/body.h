// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/assignment.h>
#include <cautery/space/field.h>
#include <cautery/space/points.h>

#include <utility>

namespace Cautery
{
  /**
   * The body of a scene in space: mesh, nodes, and what its regions and surfaces are.
   */
  template <int dim>
  struct Body
  {
    Body(const Scene &scene, const MPI_Comm communicator) : Body(scene, Mesh<dim>(scene.mesh, communicator))
    {
    }

    /** That of @p scene on a mesh that may be adapted. Collective. */
    Body(const Scene &scene, Mesh<dim> its_mesh)
      : mesh(std::move(its_mesh))
      , nodes(mesh, scene.numerics.degree, scene.numerics.method)
      , tissues(mesh, scene.tissues)
      , boundaries(mesh, scene.boundaries)
      , locator(mesh)
    {
    }

    Mesh<dim>         mesh;
    Field<dim>        nodes; ///< scalar: temperature, damage, and the places of all nodal output
    TissueMap<dim>    tissues;
    BoundaryMap<dim>  boundaries;
    PointLocator<dim> locator;
  };
} // namespace Cautery
