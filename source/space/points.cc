// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/cell_number.h>
#include <cautery/space/points.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace Cautery
{
  namespace
  {
    /// In reference coordinates: what rounding does to a place that was meant to lie on a face.
    constexpr double tolerance = 1e-9;

    template <int dim>
    std::optional<Point<dim>> unit_place(const Mesh<dim>                                         &mesh,
                                         const typename Triangulation<dim>::active_cell_iterator &cell,
                                         const Point<dim>                                        &place)
    {
      try
        {
          const Point<dim> unit = mesh.mapping().transform_real_to_unit_cell(cell, place);
          if (cell->reference_cell().contains_point(unit, tolerance))
            return unit;
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
        } // far outside a distorted quadrilateral or hexahedron the map has no inverse
      return {};
    }

    template <int dim>
    std::string text(const Point<dim> &place)
    {
      std::vector<std::string> coordinates;
      for (unsigned int d = 0; d < dim; ++d)
        coordinates.push_back(to_text(place[d]));
      return "(" + join(coordinates) + ") m";
    }
  } // namespace

  template <int dim>
  PointLocator<dim>::PointLocator(const Mesh<dim> &mesh) : mesh(mesh)
  {
    std::vector<std::pair<BoundingBox<dim>, Cell>> own;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          BoundingBox<dim> box = cell->bounding_box();
          box.extend(tolerance * cell->diameter());
          own.emplace_back(box, cell);
        }
    boxes = pack_rtree(own);
  }

  template <int dim>
  std::optional<typename PointLocator<dim>::Location>
  PointLocator<dim>::find_among_own(const Point<dim> &place) const
  {
    namespace bgi = boost::geometry::index;
    std::optional<Location> found;
    for (auto box = boxes.qbegin(bgi::intersects(place)); box != boxes.qend(); ++box)
      {
        const Cell &cell = box->second;
        if (const auto unit = unit_place(mesh, cell, place))
          if (!found || cell_order<dim>(cell) < cell_order<dim>(found->cell))
            found = Location{cell, *unit};
      }
    return found;
  }

  template <int dim>
  std::vector<typename PointLocator<dim>::Result>
  PointLocator<dim>::find(const std::vector<Point<dim>> &places) const
  {
    constexpr CellNumber    none = std::numeric_limits<CellNumber>::max();
    std::vector<Result>     results(places.size());
    std::vector<CellNumber> own_numbers(places.size(), none), lowest_numbers(places.size());
    for (unsigned int p = 0; p < places.size(); ++p)
      {
        results[p].location = find_among_own(places[p]);
        if (results[p].location)
          own_numbers[p] = cell_order<dim>(results[p].location->cell);
      }
    Utilities::MPI::min(own_numbers, mesh.communicator(), lowest_numbers);
    for (unsigned int p = 0; p < places.size(); ++p)
      {
        results[p].outside = (lowest_numbers[p] == none);
        if (own_numbers[p] != lowest_numbers[p])
          results[p].location.reset();
      }
    return results;
  }

  template <int dim>
  std::vector<std::optional<typename PointLocator<dim>::Location>>
  PointLocator<dim>::find_inside(const std::vector<Point<dim>>  &places,
                                 const std::vector<std::string> &names) const
  {
    const auto                           results = find(places);
    std::vector<std::optional<Location>> locations;
    for (unsigned int p = 0; p < places.size(); ++p)
      {
        if (results[p].outside) // then on all processes, and the search for the vertex may be collective
          {
            const Point<dim> vertex = nearest_vertex(places[p]);
            AssertThrow(false,
                        ExcInput(names[p] + ": " + text(places[p]) + " lies outside the mesh " + mesh.name() +
                                 "; its nearest node is " + text(vertex) + ", " +
                                 to_text(vertex.distance(places[p])) + " m away"));
          }
        locations.push_back(results[p].location);
      }
    return locations;
  }

  template <int dim>
  Point<dim> PointLocator<dim>::nearest_vertex(const Point<dim> &place) const
  {
    Point<dim> nearest;
    double     distance = std::numeric_limits<double>::infinity();
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          if (cell->vertex(v).distance(place) < distance)
            {
              nearest  = cell->vertex(v);
              distance = nearest.distance(place);
            }
    const auto all = Utilities::MPI::all_gather(mesh.communicator(), std::make_pair(distance, nearest));
    return std::min_element(
             all.begin(), all.end(), [](const auto &a, const auto &b) { return a.first < b.first; })
      ->second;
  }

  template class PointLocator<2>;
  template class PointLocator<3>;
} // namespace Cautery
