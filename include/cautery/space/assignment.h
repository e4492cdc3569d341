// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/scene.h>
#include <cautery/space/mesh.h>

#include <map>
#include <vector>

namespace Cautery
{
  /**
   * Which tissue each region of the mesh consists of.
   * Errors: ExcInput for a region without tissue or with two, and for names that the mesh does not have.
   */
  template <int dim>
  class TissueMap
  {
  public:
    TissueMap(const Mesh<dim> &mesh, const std::vector<Tissue> &tissues);

    unsigned int  index(const types::material_id region) const { return of_region.at(region); }
    const Tissue &operator[](const types::material_id region) const { return tissues[index(region)]; }
    const Tissue &tissue(const unsigned int index) const { return tissues[index]; }
    unsigned int  size() const { return tissues.size(); }

  private:
    const std::vector<Tissue>                 &tissues;
    std::map<types::material_id, unsigned int> of_region;
  };

  /**
   * Which boundary condition each surface of the mesh has.
   * Errors: ExcInput for a surface without condition or with two, and for names that the mesh does not have.
   */
  template <int dim>
  class BoundaryMap
  {
  public:
    BoundaryMap(const Mesh<dim> &mesh, const std::vector<Boundary> &boundaries);

    unsigned int    index(const types::boundary_id surface) const { return of_surface.at(surface); }
    const Boundary &operator[](const types::boundary_id surface) const { return boundaries[index(surface)]; }

    /** The surfaces that have the boundary condition number @p index. */
    std::set<types::boundary_id> surfaces(const unsigned int index) const;

  private:
    const std::vector<Boundary>               &boundaries;
    std::map<types::boundary_id, unsigned int> of_surface;
  };
} // namespace Cautery
