// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/parameters.h>
#include <cautery/space/plain_mesh.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

namespace Cautery
{
  namespace
  {
    /// A cell or face is the same as another when it has the same vertices in whatever order.
    using Key = std::array<unsigned int, 8>;

    template <typename Vertices>
    Key key_of(const Vertices &vertices)
    {
      Key key;
      key.fill(numbers::invalid_unsigned_int);
      std::copy(vertices.begin(), vertices.end(), key.begin());
      std::sort(key.begin(), key.end()); // the invalid ones are the largest
      return key;
    }

    template <int dim>
    std::string place_of(const PlainMesh<dim> &mesh, const std::vector<unsigned int> &vertices)
    {
      Point<dim> center;
      for (const unsigned int v : vertices)
        center += mesh.vertices[v] / static_cast<double>(vertices.size());
      std::vector<std::string> coordinates;
      for (unsigned int d = 0; d < dim; ++d)
        coordinates.push_back(to_text(center[d]));
      return "at (" + join(coordinates) + ") m";
    }

    /** `3 "liver"` */
    template <typename Names>
    std::string group_text(const Names &names, const unsigned int id)
    {
      const auto entry = names.find(id);
      return std::to_string(id) + " \"" + (entry == names.end() ? "" : entry->second) + "\"";
    }

    template <int dim>
    void check_coordinates(const PlainMesh<dim> &mesh, const std::string &name)
    {
      for (const auto &vertex : mesh.vertices)
        for (unsigned int d = 0; d < dim; ++d)
          AssertThrow(
            numbers::is_finite(vertex[d]),
            ExcInput(name + ": a node has a coordinate that is not a finite number; export the mesh again"));
    }

    /** Two nodes at one place are usually two parts that were meshed without a common interface. */
    template <int dim>
    void note_coinciding_vertices(PlainMesh<dim> &mesh)
    {
      std::vector<std::array<double, dim>> places(mesh.vertices.size());
      for (unsigned int v = 0; v < places.size(); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          places[v][d] = mesh.vertices[v][d];
      std::sort(places.begin(), places.end());
      const auto coinciding = places.end() - std::unique(places.begin(), places.end());
      if (coinciding > 0)
        mesh.notes.push_back(std::to_string(coinciding) +
                             " nodes lie exactly on others: nothing flows between the "
                             "cells that they separate");
    }

    template <int dim>
    void drop_duplicate_cells(PlainMesh<dim> &mesh, const std::string &name)
    {
      std::vector<std::pair<Key, unsigned int>> keys(mesh.cells.size());
      for (unsigned int c = 0; c < keys.size(); ++c)
        keys[c] = {key_of(mesh.cells[c].vertices), c};
      std::sort(keys.begin(), keys.end());

      std::vector<bool> duplicate(mesh.cells.size(), false);
      for (unsigned int i = 1; i < keys.size(); ++i)
        if (keys[i].first == keys[i - 1].first)
          {
            const auto &first = mesh.cells[keys[i - 1].second], &second = mesh.cells[keys[i].second];
            AssertThrow(first.material_id == second.material_id,
                        ExcInput(name + ": the cell " + place_of(mesh, first.vertices) +
                                 " is in two physical groups, " +
                                 group_text(mesh.regions, first.material_id) + " and " +
                                 group_text(mesh.regions, second.material_id) +
                                 "; put each volume into one group"));
            duplicate[keys[i].second] = true;
          }

      std::vector<CellData<dim>> unique;
      unique.reserve(mesh.cells.size());
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        if (!duplicate[c])
          unique.push_back(std::move(mesh.cells[c]));
      if (unique.size() < keys.size())
        mesh.notes.push_back(std::to_string(keys.size() - unique.size()) + " duplicate cells dropped");
      mesh.cells = std::move(unique);
    }

    /// The largest distance between two of them.
    template <int dim>
    double diameter(const PlainMesh<dim> &mesh, const std::vector<unsigned int> &vertices)
    {
      double largest = 0.;
      for (const unsigned int v : vertices)
        for (const unsigned int w : vertices)
          largest = std::max(largest, mesh.vertices[v].distance_square(mesh.vertices[w]));
      return std::sqrt(largest);
    }

    /**
     * By the edges that leave a corner: one for a simplex, one for each corner of a quadrilateral or
     * hexahedron, where vertex c ^ 2^d is the neighbour of vertex c in direction d.
     */
    template <int dim>
    std::vector<double> relative_volumes(const PlainMesh<dim>            &mesh,
                                         const std::vector<unsigned int> &vertices)
    {
      const bool          simplex = (vertices.size() == dim + 1);
      const double        longest = diameter(mesh, vertices);
      std::vector<double> volumes(simplex ? 1 : vertices.size());
      for (unsigned int c = 0; c < volumes.size(); ++c)
        {
          Tensor<2, dim> edges;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int neighbour = simplex ? d + 1 : c ^ (1u << d);
              edges[d] = (mesh.vertices[vertices[neighbour]] - mesh.vertices[vertices[c]]) *
                         (neighbour > c ? 1. : -1.);
            }
          volumes[c] = relative_volume(edges, longest);
        }
      return volumes;
    }

    template <int dim>
    void turn_inverted_cells(PlainMesh<dim> &mesh, const std::string &name)
    {
      unsigned int turned = 0;
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        {
          auto      &vertices          = mesh.cells[c].vertices;
          const auto volumes           = relative_volumes(mesh, vertices);
          const auto [lowest, highest] = std::minmax_element(volumes.begin(), volumes.end());
          if (*lowest > least_volume)
            continue;

          const std::string cell = name + ": cell " + std::to_string(c + 1) + " " + place_of(mesh, vertices);
          AssertThrow(*highest < -least_volume || *highest > least_volume,
                      ExcInput(cell + " has no volume; remesh there or remove the cell"));
          AssertThrow(*highest < -least_volume,
                      ExcInput(cell + " is inverted or flat at some of its corners; remesh there"));
          if (vertices.size() == dim + 1)
            std::swap(vertices[dim - 1], vertices[dim]);
          else
            std::swap_ranges(vertices.begin(),
                             vertices.begin() + vertices.size() / 2,
                             vertices.begin() + vertices.size() / 2);
          ++turned;
        }
      if (turned > 0)
        mesh.notes.push_back(std::to_string(turned) + " inverted cells turned round");
    }

    /** The faces that belong to one cell only, sorted. */
    template <int dim>
    std::vector<Key> boundary_faces(const PlainMesh<dim> &mesh, const std::string &name)
    {
      const ReferenceCell reference = reference_cell(mesh);
      std::vector<Key>    faces;
      faces.reserve(mesh.cells.size() * reference.n_faces());
      for (const auto &cell : mesh.cells)
        for (const unsigned int f : reference.face_indices())
          {
            std::vector<unsigned int> vertices(reference.face_reference_cell(f).n_vertices());
            for (unsigned int v = 0; v < vertices.size(); ++v)
              vertices[v] = cell.vertices[reference.face_to_cell_vertices(f, v, 1)];
            faces.push_back(key_of(vertices));
          }
      std::sort(faces.begin(), faces.end());

      std::vector<Key> single;
      for (auto face = faces.begin(), next = face; face != faces.end(); face = next)
        {
          next = std::find_if(face, faces.end(), [&](const Key &other) { return other != *face; });
          const unsigned int n_vertices =
            std::find(face->begin(), face->end(), numbers::invalid_unsigned_int) - face->begin();
          AssertThrow(next - face <= 2,
                      ExcInput(name + ": more than two cells share the face " +
                               place_of(mesh, {face->begin(), face->begin() + n_vertices}) +
                               ", so cells overlap; remove the doubled ones"));
          if (next - face == 1)
            single.push_back(*face);
        }
      return single;
    }

    template <int dim>
    void keep_boundary_faces(PlainMesh<dim> &mesh, const std::string &name)
    {
      const std::vector<Key>           boundary = boundary_faces(mesh, name);
      std::map<Key, CellData<dim - 1>> kept;
      unsigned int                     dropped = 0;
      for (auto &face : mesh.faces)
        {
          const Key key = key_of(face.vertices);
          if (!std::binary_search(boundary.begin(), boundary.end(), key))
            {
              ++dropped;
              continue;
            }
          const auto [entry, is_new] = kept.emplace(key, face);
          const auto other           = entry->second.boundary_id;
          AssertThrow(is_new || other == face.boundary_id,
                      ExcInput(name + ": the boundary face " + place_of(mesh, face.vertices) +
                               " is in two physical groups, " + group_text(mesh.surfaces, other) + " and " +
                               group_text(mesh.surfaces, face.boundary_id) +
                               "; put each surface into one group"));
        }

      mesh.faces.clear();
      for (const auto &face : kept)
        mesh.faces.push_back(face.second);
      if (dropped > 0)
        mesh.notes.push_back(std::to_string(dropped) +
                             " faces of physical surfaces ignored: not on the boundary");

      std::map<types::boundary_id, std::string> surfaces;
      if (kept.size() < boundary.size())
        surfaces[0] = "";
      for (const auto &face : mesh.faces)
        surfaces[face.boundary_id] = mesh.surfaces[face.boundary_id];
      mesh.surfaces = surfaces;
    }

    template <int dim>
    void forget_empty_regions(PlainMesh<dim> &mesh)
    {
      std::map<types::material_id, std::string> regions;
      for (const auto &cell : mesh.cells)
        regions.emplace(cell.material_id, mesh.regions[cell.material_id]);
      mesh.regions = regions;
    }
  } // namespace

  template <int dim>
  void tidy(PlainMesh<dim> &mesh, const std::string &name)
  {
    check_coordinates(mesh, name);
    note_coinciding_vertices(mesh);
    drop_duplicate_cells(mesh, name);
    turn_inverted_cells(mesh, name);
    keep_boundary_faces(mesh, name);
    forget_empty_regions(mesh);
    if (reference_cell(mesh).is_hyper_cube())
      GridTools::consistently_order_cells(mesh.cells);
  }

  template void tidy(PlainMesh<2> &, const std::string &);
  template void tidy(PlainMesh<3> &, const std::string &);
} // namespace Cautery
