// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/rollers.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Cautery
{
  namespace
  {
    /// Normals that differ by more belong to two sides of an edge: cos 50 degrees.
    constexpr double edge_cosine = 0.64;

    template <int dim>
    using Normals = std::vector<Tensor<1, dim>>;

    /// The normals times the areas of the faces around each node, named by its first unknown.
    template <int dim>
    std::map<types::global_dof_index, Normals<dim>> face_normals(const Field<dim>       &displacement,
                                                                 const BoundaryMap<dim> &boundaries)
    {
      std::map<types::global_dof_index, Normals<dim>> result;
      const auto                                     &fe     = displacement.element();
      const Quadrature<dim - 1>                       centre = displacement.mesh().simplices() ?
                                                                 Quadrature<dim - 1>(QGaussSimplex<dim - 1>(1)) :
                                                                 Quadrature<dim - 1>(QGauss<dim - 1>(1));
      FEFaceValues<dim> values(displacement.mapping(), fe, centre, update_normal_vectors | update_JxW_values);
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : displacement.dof_handler().active_cell_iterators())
        {
          if (cell->is_artificial() || !cell->at_boundary())
            continue;
          cell->get_dof_indices(dofs);
          for (const unsigned int face : cell->face_indices())
            {
              if (!cell->face(face)->at_boundary() || cell->face(face)->boundary_id() == no_surface ||
                  boundaries[cell->face(face)->boundary_id()].mechanical != Boundary::Mechanical::roller)
                continue;
              values.reinit(cell, face);
              for (const unsigned int i : displacement.on_face(face))
                if (fe.system_to_component_index(i).first == 0)
                  result[dofs[i]].push_back(values.normal_vector(0) * values.JxW(0));
            }
        }
      return result;
    }

    /// One mean normal, of unit length, for each side of the edges that meet here.
    template <int dim>
    Normals<dim> sides(Normals<dim> faces)
    {
      // the order of cells depends on the number of processes
      std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
        return std::lexicographical_compare(a.begin_raw(), a.end_raw(), b.begin_raw(), b.end_raw());
      });
      Normals<dim> sums;
      for (const auto &face : faces)
        {
          const auto side = std::find_if(sums.begin(), sums.end(), [&face](const auto &sum) {
            return sum * face > edge_cosine * sum.norm() * face.norm();
          });
          if (side == sums.end())
            sums.push_back(face);
          else
            *side += face;
        }
      for (auto &sum : sums)
        sum /= sum.norm();
      return sums;
    }

    /**
     * n . u = 0 for all @p normals, solved for as many components by elimination with the largest pivots;
     * normals that follow from the others say nothing new.
     */
    template <int dim>
    void add_lines(const types::global_dof_index node,
                   Normals<dim>                  normals,
                   AffineConstraints<double>    &constraints)
    {
      constexpr double          dependent = 0.1;
      std::vector<unsigned int> pivots;
      for (unsigned int row = 0; row < normals.size() && row < dim; ++row)
        {
          unsigned int best = row, pivot = 0;
          for (unsigned int r = row; r < normals.size(); ++r)
            for (unsigned int c = 0; c < dim; ++c)
              if (std::abs(normals[r][c]) > std::abs(normals[best][pivot]))
                {
                  best  = r;
                  pivot = c;
                }
          if (std::abs(normals[best][pivot]) < dependent)
            break;
          std::swap(normals[row], normals[best]);
          normals[row] /= normals[row][pivot];
          for (unsigned int r = 0; r < normals.size(); ++r)
            if (r != row)
              normals[r] -= normals[r][pivot] * normals[row];
          pivots.push_back(pivot);
        }
      for (unsigned int row = 0; row < pivots.size(); ++row)
        {
          constraints.add_line(node + pivots[row]);
          for (unsigned int c = 0; c < dim; ++c)
            if (std::find(pivots.begin(), pivots.end(), c) == pivots.end() && normals[row][c] != 0.)
              constraints.add_entry(node + pivots[row], node + c, -normals[row][c]);
        }
    }
  } // namespace

  template <int dim>
  void constrain_rollers(const Field<dim>          &displacement,
                         const BoundaryMap<dim>    &boundaries,
                         AffineConstraints<double> &constraints)
  {
    for (const auto &[node, faces] : face_normals(displacement, boundaries))
      if (!constraints.is_constrained(node))
        add_lines<dim>(node, sides<dim>(faces), constraints);
  }

  template void constrain_rollers(const Field<2> &, const BoundaryMap<2> &, AffineConstraints<double> &);
  template void constrain_rollers(const Field<3> &, const BoundaryMap<3> &, AffineConstraints<double> &);
} // namespace Cautery
