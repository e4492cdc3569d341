// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace Cautery
{
  namespace
  {
    /** Each corner of a small box is a number whose bit d says whether it is at the upper end in direction d.
     */
    using Corners = std::vector<unsigned int>;

    template <int dim>
    std::array<unsigned int, dim> subdivisions(const MeshSettings &settings)
    {
      const auto &numbers = settings.subdivisions;
      AssertThrow(numbers.size() == 1 || numbers.size() == dim || numbers.size() == 3,
                  ExcInput("Mesh/Subdivisions: a box needs 1 or " + std::to_string(dim) + " numbers, not " +
                           std::to_string(numbers.size())));
      std::array<unsigned int, dim> counts;
      Tensor<1, dim>                edges;
      double                        n_vertices = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double number = (numbers.size() == 1 ? numbers[0] : numbers[d]);
          AssertThrow(number >= 1. && number <= 1e6 && number == std::floor(number),
                      ExcInput("Mesh/Subdivisions = " + to_text(number) + ": give a whole number from 1 on"));
          AssertThrow(settings.lower[d] < settings.upper[d],
                      ExcInput("Mesh/Upper corner: the box reaches from " + to_text(settings.lower[d]) +
                               " to " + to_text(settings.upper[d]) + " m in direction " + "xyz"[d] +
                               "; the second must be larger"));
          counts[d] = static_cast<unsigned int>(number);
          edges[d]  = (settings.upper[d] - settings.lower[d]) / number;
          n_vertices *= number + 1.;
        }
      AssertThrow(n_vertices < 1e8,
                  ExcInput("Mesh/Subdivisions: the box would have " + to_text(n_vertices) +
                           " vertices; fewer than 100 million are possible"));
      Tensor<2, dim> scaled; // so that nothing overflows
      for (unsigned int d = 0; d < dim; ++d)
        scaled[d][d] = edges[d] / *std::max_element(edges.begin_raw(), edges.end_raw());
      AssertThrow(relative_volume(scaled, scaled.norm()) > least_volume,
                  ExcInput("Mesh/Subdivisions: cells of " + to_text(edges[0]) + " by " + to_text(edges[1]) +
                           (dim == 3 ? " by " + to_text(edges[dim - 1]) : std::string()) +
                           " m are drawn out too far to have a volume; subdivide the long sides more"));
      return counts;
    }

    /** The simplices walk from the first corner to the last, one edge in each direction, in all orders. */
    template <int dim>
    std::vector<Corners> kuhn_simplices()
    {
      std::array<unsigned int, dim> axes;
      std::iota(axes.begin(), axes.end(), 0);
      std::vector<Corners> simplices;
      do
        {
          Corners simplex = {0};
          for (const unsigned int axis : axes)
            simplex.push_back(simplex.back() | (1u << axis));
          unsigned int inversions = 0;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = i + 1; j < dim; ++j)
              inversions += (axes[i] > axes[j]);
          if (inversions % 2 == 1)
            std::swap(simplex[dim - 1], simplex[dim]); // an odd order of the axes is left-handed
          simplices.push_back(simplex);
        }
      while (std::next_permutation(axes.begin(), axes.end()));
      return simplices;
    }

    template <int dim>
    std::vector<Corners> pieces(const MeshSettings::Cells cells)
    {
      if (cells == MeshSettings::Cells::tetrahedra)
        return kuhn_simplices<dim>();
      Corners all(GeometryInfo<dim>::vertices_per_cell);
      std::iota(all.begin(), all.end(), 0);
      return {all};
    }

    /** Calls @p visit with every index below @p ends, the first direction fastest. */
    template <int dim, typename Visit>
    void for_each_index(const std::array<unsigned int, dim> &ends, const Visit &visit)
    {
      std::array<unsigned int, dim> index{};
      while (index[dim - 1] < ends[dim - 1])
        {
          visit(index);
          ++index[0];
          for (unsigned int d = 0; d + 1 < dim && index[d] == ends[d]; ++d)
            {
              index[d] = 0;
              ++index[d + 1];
            }
        }
    }

    /** The surface of the box that all @p vertices lie on, 0 for none. Vertices have the exact end
     * coordinates. */
    template <int dim>
    types::boundary_id surface_of(const PlainMesh<dim>            &mesh,
                                  const std::vector<unsigned int> &vertices,
                                  const MeshSettings              &settings)
    {
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int side = 0; side < 2; ++side)
          {
            const double end = (side == 0 ? settings.lower[d] : settings.upper[d]);
            if (std::all_of(vertices.begin(), vertices.end(), [&](const unsigned int v) {
                  return mesh.vertices[v][d] == end;
                }))
              return 2 * d + side + 1;
          }
      return 0;
    }

    template <int dim>
    void add_faces(PlainMesh<dim> &mesh, const MeshSettings &settings)
    {
      const ReferenceCell reference = reference_cell(mesh);
      for (const auto &cell : mesh.cells)
        for (const unsigned int f : reference.face_indices())
          {
            CellData<dim - 1> face(reference.face_reference_cell(f).n_vertices());
            for (unsigned int v = 0; v < face.vertices.size(); ++v)
              face.vertices[v] = cell.vertices[reference.face_to_cell_vertices(f, v, 1)];
            face.boundary_id = surface_of(mesh, face.vertices, settings);
            if (face.boundary_id != 0)
              mesh.faces.push_back(face);
          }
    }
  } // namespace

  template <int dim>
  PlainMesh<dim> make_box(const MeshSettings &settings)
  {
    const auto     counts = subdivisions<dim>(settings);
    PlainMesh<dim> mesh;
    mesh.regions[1] = "box";
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int side = 0; side < 2; ++side)
        mesh.surfaces[2 * d + side + 1] = std::string(1, "xyz"[d]) + (side == 0 ? " min" : " max");

    std::array<unsigned int, dim> n_vertices, strides;
    for (unsigned int d = 0; d < dim; ++d)
      {
        n_vertices[d] = counts[d] + 1;
        strides[d]    = (d == 0 ? 1 : strides[d - 1] * n_vertices[d - 1]);
      }

    for_each_index<dim>(n_vertices, [&](const auto &index) {
      Point<dim> place;
      for (unsigned int d = 0; d < dim; ++d)
        place[d] = (index[d] == counts[d] ?
                      settings.upper[d] :
                      settings.lower[d] + index[d] * (settings.upper[d] - settings.lower[d]) / counts[d]);
      mesh.vertices.push_back(place);
    });

    const auto cut = pieces<dim>(settings.cells);
    for_each_index<dim>(counts, [&](const auto &index) {
      for (const auto &piece : cut)
        {
          CellData<dim> cell(piece.size());
          cell.material_id = 1;
          for (unsigned int v = 0; v < piece.size(); ++v)
            {
              cell.vertices[v] = 0;
              for (unsigned int d = 0; d < dim; ++d)
                cell.vertices[v] += strides[d] * (index[d] + ((piece[v] >> d) & 1));
            }
          mesh.cells.push_back(cell);
        }
    });
    add_faces(mesh, settings);
    return mesh;
  }

  template PlainMesh<2> make_box(const MeshSettings &);
  template PlainMesh<3> make_box(const MeshSettings &);
} // namespace Cautery
