// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/gmsh_file.h>
#include <cautery/space/mesh_file.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <unordered_map>

namespace Cautery
{
  namespace
  {
    template <int dim>
    void check_kinds(const std::vector<ElementBlock> &cells, const GmshFile &file)
    {
      const std::string wanted = (dim == 3 ? "tetrahedra or hexahedra" : "triangles or quadrilaterals");
      if (dim == 2)
        {
          const auto volumes = file.elements(3);
          AssertThrow(volumes.empty(),
                      ExcInput(file.label() + " has volume cells (" + count_text(volumes) +
                               "), but the scene is two-dimensional; set Dimension = 3"));
        }
      AssertThrow(!cells.empty(),
                  ExcInput(file.label() + " has no cells of dimension " + std::to_string(dim) + ", only " +
                           count_text(file.elements(dim - 1)) + "; export its " + wanted));
      for (const auto &block : cells)
        AssertThrow(block.kind() == cells.front().kind() &&
                      (block.n_corners == dim + 1 || block.n_corners == GeometryInfo<dim>::vertices_per_cell),
                    ExcInput(file.label() + " has " + count_text(cells) + "; all cells must be " + wanted));
    }

    void check_is_plane(const std::vector<double> &heights, const double length, const GmshFile &file)
    {
      const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
      AssertThrow(*highest - *lowest <= 1e-9 * length,
                  ExcInput(file.label() + " is a surface in space, z = " + to_text(*lowest) + " to " +
                           to_text(*highest) +
                           " m; a two-dimensional mesh must lie in a plane of constant z"));
    }

    /** What the cells need a node for. */
    enum class Use : unsigned char
    {
      none,
      middle,
      corner
    };

    std::unordered_map<std::size_t, Use> uses_of_nodes(const std::vector<ElementBlock> &cells)
    {
      std::unordered_map<std::size_t, Use> uses;
      for (const auto &block : cells)
        for (std::size_t n = 0; n < block.nodes.size(); ++n)
          {
            Use &use = uses[block.nodes[n]];
            use      = std::max(use, n % block.n_nodes < block.n_corners ? Use::corner : Use::middle);
          }
      return uses;
    }

    double metres(const MeshSettings::LengthUnit unit)
    {
      switch (unit)
        {
        case MeshSettings::LengthUnit::centimetre:
          return 1e-2;
        case MeshSettings::LengthUnit::millimetre:
          return 1e-3;
        default:
          return 1.;
        }
    }

    /** Numbers the corner nodes of @p cells in the file's order; the map goes from gmsh's tags to them. */
    template <int dim>
    std::unordered_map<std::size_t, unsigned int> number_vertices(PlainMesh<dim>                  &mesh,
                                                                  const std::vector<ElementBlock> &cells,
                                                                  const GmshFile                  &file,
                                                                  const double                     scale)
    {
      const auto                                    nodes = file.nodes();
      const auto                                    uses  = uses_of_nodes(cells);
      std::unordered_map<std::size_t, unsigned int> vertex_of;
      std::vector<double>                           heights;
      unsigned int                                  n_orphans = 0, n_middle = 0;
      for (std::size_t n = 0; n < nodes.tags.size(); ++n)
        {
          const auto use = uses.find(nodes.tags[n]);
          n_orphans += (use == uses.end());
          n_middle += (use != uses.end() && use->second == Use::middle);
          if (use == uses.end() || use->second != Use::corner)
            continue;
          vertex_of[nodes.tags[n]] = mesh.vertices.size();
          Point<dim> vertex;
          for (unsigned int d = 0; d < dim; ++d)
            vertex[d] = scale * nodes.places[3 * n + d];
          mesh.vertices.push_back(vertex);
          heights.push_back(scale * nodes.places[3 * n + 2]);
        }
      if (dim == 2)
        check_is_plane(heights, BoundingBox<dim>(mesh.vertices).side_length(0), file);
      if (n_middle > 0)
        mesh.notes.push_back(std::to_string(n_middle) +
                             " nodes within second-order cells dropped: cells are linear");
      if (n_orphans > 0)
        mesh.notes.push_back(std::to_string(n_orphans) + " nodes that belong to no cell dropped");
      return vertex_of;
    }

    /** gmsh goes round a quadrilateral, deal.II goes row by row. */
    template <int structdim>
    void reorder(std::vector<unsigned int> &vertices)
    {
      if (vertices.size() == GeometryInfo<structdim>::vertices_per_cell)
        for (unsigned int v = 3; v < vertices.size(); v += 4)
          std::swap(vertices[v - 1], vertices[v]);
    }

    /** Elements with a node that is no vertex are left out and counted: faces that touch no cell. */
    template <int structdim>
    std::size_t append(std::vector<CellData<structdim>>                    &elements,
                       const std::vector<ElementBlock>                     &blocks,
                       const std::unordered_map<std::size_t, unsigned int> &vertex_of)
    {
      std::size_t left_out = 0;
      for (const auto &block : blocks)
        for (std::size_t e = 0; e < block.n_elements(); ++e)
          {
            CellData<structdim> element(block.n_corners);
            bool                complete = true;
            for (unsigned int v = 0; v < block.n_corners && complete; ++v)
              {
                const auto vertex = vertex_of.find(block.nodes[e * block.n_nodes + v]);
                complete          = (vertex != vertex_of.end());
                if (complete)
                  element.vertices[v] = vertex->second;
              }
            if (!complete)
              {
                ++left_out;
                continue;
              }
            reorder<structdim>(element.vertices);
            element.material_id = block.group; // of faces this is the boundary id: a union
            elements.push_back(std::move(element));
          }
      return left_out;
    }

    template <typename Id>
    std::map<Id, std::string> names_of(const std::vector<ElementBlock> &blocks, const GmshFile &file)
    {
      std::map<Id, std::string> names;
      for (const auto &block : blocks)
        names[block.group] = (block.group == 0 ? "" : file.group_name(block.dimension, block.group));
      return names;
    }
  } // namespace

  template <int dim>
  PlainMesh<dim> read_mesh_file(const MeshSettings &settings)
  {
    const GmshFile file(settings.file_name);
    PlainMesh<dim> mesh;
    const auto     cells = file.elements(dim);
    check_kinds<dim>(cells, file);
    const auto vertex_of = number_vertices(mesh, cells, file, metres(settings.length_unit));

    const std::size_t without_nodes = append(mesh.cells, cells, vertex_of);
    AssertThrow(
      without_nodes == 0,
      ExcInput(file.label() + ": " + std::to_string(without_nodes) +
               " cells refer to nodes that the file does not have; it may be cut off, export it again"));

    auto faces = file.elements(dim - 1);
    faces.erase(
      std::remove_if(faces.begin(), faces.end(), [](const auto &block) { return block.group == 0; }),
      faces.end());
    const std::size_t loose_faces = append(mesh.faces, faces, vertex_of);
    if (loose_faces > 0)
      mesh.notes.push_back(std::to_string(loose_faces) +
                           " faces of physical surfaces ignored: they touch no cell");

    mesh.regions  = names_of<types::material_id>(cells, file);
    mesh.surfaces = names_of<types::boundary_id>(faces, file);
    return mesh;
  }

  template PlainMesh<2> read_mesh_file(const MeshSettings &);
  template PlainMesh<3> read_mesh_file(const MeshSettings &);
} // namespace Cautery
