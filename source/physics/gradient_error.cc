// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/gradient_error.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <cmath>
#include <limits>

namespace Cautery
{
  namespace
  {
    template <int dim>
    Quadrature<dim> centre(const Mesh<dim> &mesh)
    {
      if (mesh.simplices())
        return QGaussSimplex<dim>(1);
      return QGauss<dim>(1);
    }

    /// Derivatives of order @p rank of all components in a cell, at some places.
    template <int dim, int rank>
    class CellDerivatives
    {
    public:
      CellDerivatives(const Field<dim>      &nodes,
                      const Field<dim>      &field,
                      const Vector          &x,
                      const Quadrature<dim> &places)
        : nodes(nodes)
        , n_components(field.n_components())
        , ghosted(field.ghosted(x))
        , at(nodes.mapping(), nodes.element(), places, rank == 1 ? update_gradients : update_hessians)
        , dofs(nodes.element().n_dofs_per_cell())
        , of_nodes(dofs.size() * n_components)
        , derivatives(places.size() * n_components)
      {
      }

      void reinit(const typename DoFHandler<dim>::active_cell_iterator &cell)
      {
        at.reinit(cell);
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            // a vector with ghosts keeps its entries in the order of the relevant unknowns
            const auto node = nodes.relevant().index_within_set(dofs[i]);
            for (unsigned int c = 0; c < n_components; ++c)
              of_nodes[i * n_components + c] = ghosted.begin()[node * n_components + c];
          }
        for (const unsigned int q : at.quadrature_point_indices())
          for (unsigned int c = 0; c < n_components; ++c)
            {
              Tensor<rank, dim> &sum = derivatives[q * n_components + c];
              sum                    = 0.;
              for (unsigned int i = 0; i < dofs.size(); ++i)
                if constexpr (rank == 1)
                  sum += of_nodes[i * n_components + c] * at.shape_grad(i, q);
                else
                  sum += of_nodes[i * n_components + c] * at.shape_hessian(i, q);
            }
      }

      const Tensor<rank, dim> &operator()(const unsigned int place, const unsigned int component) const
      {
        return derivatives[place * n_components + component];
      }

    private:
      const Field<dim>                    &nodes;
      const unsigned int                   n_components;
      const Vector                         ghosted;
      FEValues<dim>                        at;
      std::vector<types::global_dof_index> dofs;
      std::vector<double>                  of_nodes;
      std::vector<Tensor<rank, dim>>       derivatives;
    };

    /// The place of a vertex and the tissue of a cell in arrays of all of these.
    template <int dim>
    std::size_t slot(const Field<dim>                                     &nodes,
                     const TissueMap<dim>                                 &tissues,
                     const typename DoFHandler<dim>::active_cell_iterator &cell,
                     const unsigned int                                    v)
    {
      return nodes.relevant().index_within_set(cell->vertex_dof_index(v, 0)) * tissues.size() +
             tissues.index(cell->material_id());
    }

    /**
     * Gradients averaged at vertices by volume, for each tissue that meets there. Right at the vertices of
     * owned cells: all cells around these are owned or ghosts.
     */
    template <int dim>
    class VertexAverages
    {
    public:
      VertexAverages(const Field<dim> &nodes, const TissueMap<dim> &tissues, const unsigned int n_components)
        : nodes(nodes)
        , tissues(tissues)
        , n_components(n_components)
        , volumes(nodes.relevant().n_elements() * tissues.size(), 0.)
        , sums(volumes.size() * n_components)
      {
      }

      void add(CellDerivatives<dim, 1> &gradients, const bool one_place)
      {
        for (const auto &cell : nodes.dof_handler().active_cell_iterators())
          {
            if (cell->is_artificial())
              continue;
            gradients.reinit(cell);
            const double volume = cell->measure();
            for (const unsigned int v : cell->vertex_indices())
              {
                const std::size_t place = slot(nodes, tissues, cell, v);
                volumes[place] += volume;
                for (unsigned int c = 0; c < n_components; ++c)
                  sums[place * n_components + c] += volume * gradients(one_place ? 0 : v, c);
              }
          }
      }

      Tensor<1, dim> operator()(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                const unsigned int                                    vertex,
                                const unsigned int                                    component) const
      {
        const std::size_t place = slot(nodes, tissues, cell, vertex);
        return sums[place * n_components + component] / volumes[place];
      }

    private:
      const Field<dim>           &nodes;
      const TissueMap<dim>       &tissues;
      const unsigned int          n_components;
      std::vector<double>         volumes;
      std::vector<Tensor<1, dim>> sums;
    };

    /**
     * What a straight line through the second derivatives of several cells needs: sums over them, places
     * being relative to one that is near.
     */
    template <int dim>
    struct Moments
    {
      double         n = 0.;
      Tensor<1, dim> place;
      Tensor<2, dim> places; ///< products of places
      Tensor<2, dim> second;
      Tensor<3, dim> products; ///< of second derivatives and places

      void add(const Tensor<2, dim> &value, const Tensor<1, dim> &at)
      {
        n += 1.;
        place += at;
        places += outer_product(at, at);
        second += value;
        products += outer_product(value, at);
      }

      /** Adds @p other, whose places are relative to one that is @p shift away. */
      void add(const Moments &other, const Tensor<1, dim> &shift)
      {
        n += other.n;
        place += other.place + other.n * shift;
        places += other.places + outer_product(other.place, shift) + outer_product(shift, other.place) +
                  other.n * outer_product(shift, shift);
        second += other.second;
        products += other.products + outer_product(other.second, shift);
      }

      /** The third derivatives: the slope by least squares, zero along directions without neighbours. */
      Tensor<3, dim> slope() const
      {
        Tensor<2, dim> spread = places / n - outer_product(place, place) / (n * n);
        const double   tiny   = 1e-10 * trace(spread) + std::numeric_limits<double>::min();
        for (unsigned int d = 0; d < dim; ++d)
          spread[d][d] += tiny;
        return (products / n - outer_product(second, place) / (n * n)) * invert(spread);
      }
    };

    /// Of one component, at the vertices, for each tissue.
    template <int dim>
    class VertexMoments
    {
    public:
      VertexMoments(const Field<dim> &nodes, const TissueMap<dim> &tissues)
        : nodes(nodes), tissues(tissues), moments(nodes.relevant().n_elements() * tissues.size())
      {
      }

      void add(CellDerivatives<dim, 2> &second, const unsigned int component)
      {
        for (const auto &cell : nodes.dof_handler().active_cell_iterators())
          {
            if (cell->is_artificial())
              continue;
            second.reinit(cell);
            for (const unsigned int v : cell->vertex_indices())
              moments[slot(nodes, tissues, cell, v)].add(second(0, component),
                                                         cell->center() - cell->vertex(v));
          }
      }

      /** Of the cells that share a vertex with @p cell, counted for each that they share. */
      Moments<dim> around(const typename DoFHandler<dim>::active_cell_iterator &cell) const
      {
        Moments<dim> sum;
        for (const unsigned int v : cell->vertex_indices())
          sum.add(moments[slot(nodes, tissues, cell, v)], cell->vertex(v) - cell->center());
        return sum;
      }

    private:
      const Field<dim>         &nodes;
      const TissueMap<dim>     &tissues;
      std::vector<Moments<dim>> moments;
    };

    /// What quadratic interpolation leaves of a cubic, which is known by its third derivatives.
    template <int dim>
    class CubicRemainder
    {
    public:
      explicit CubicRemainder(const Field<dim> &nodes)
        : at(nodes.mapping(),
             nodes.element(),
             nodes.cell_quadrature(),
             update_gradients | update_quadrature_points | update_JxW_values)
        , node_places(nodes.mapping(),
                      nodes.element(),
                      Quadrature<dim>(nodes.element().get_unit_support_points()),
                      update_quadrature_points)
      {
      }

      void reinit(const typename DoFHandler<dim>::active_cell_iterator &cell)
      {
        at.reinit(cell);
        node_places.reinit(cell);
        centre = cell->center();
      }

      /** The integral of the remainder's squared gradient. */
      double square(const Tensor<3, dim> &third) const
      {
        double sum = 0.;
        for (const unsigned int q : at.quadrature_point_indices())
          {
            Tensor<1, dim> slope = cubic_gradient(third, at.quadrature_point(q) - centre);
            for (const unsigned int i : at.dof_indices())
              slope -= cubic(third, node_places.quadrature_point(i) - centre) * at.shape_grad(i, q);
            sum += slope.norm_square() * at.JxW(q);
          }
        return sum;
      }

      const FEValues<dim> &values() const { return at; }

    private:
      static double cubic(const Tensor<3, dim> &third, const Tensor<1, dim> &x)
      {
        return contract3(x, third, outer_product(x, x)) / 6.;
      }

      static Tensor<1, dim> cubic_gradient(const Tensor<3, dim> &third, const Tensor<1, dim> &x)
      {
        // third derivatives that are found so need not be symmetric
        Tensor<1, dim> result;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            for (unsigned int k = 0; k < dim; ++k)
              result[i] += (third[i][j][k] + third[j][i][k] + third[j][k][i]) * x[j] * x[k] / 6.;
        return result;
      }

      FEValues<dim> at;
      FEValues<dim> node_places;
      Point<dim>    centre;
    };

    /// The integral of the product of two vertex functions, in a cell of volume one.
    template <int dim>
    FullMatrix<double> vertex_masses(const Mesh<dim> &mesh, const FiniteElement<dim> &linear)
    {
      const Quadrature<dim> rule =
        mesh.simplices() ? Quadrature<dim>(QGaussSimplex<dim>(2)) : Quadrature<dim>(QGauss<dim>(2));
      FullMatrix<double> result(linear.n_dofs_per_cell(), linear.n_dofs_per_cell());
      double             volume = 0.;
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          volume += rule.weight(q);
          for (unsigned int v = 0; v < result.m(); ++v)
            for (unsigned int w = 0; w < result.n(); ++w)
              result(v, w) +=
                linear.shape_value(v, rule.point(q)) * linear.shape_value(w, rule.point(q)) * rule.weight(q);
        }
      result *= 1. / volume;
      return result;
    }

    /// The mean square of a gradient that is given at the vertices.
    template <int dim>
    double mean_square(const FullMatrix<double> &masses, const std::vector<Tensor<1, dim>> &at_vertices)
    {
      double sum = 0.;
      for (unsigned int v = 0; v < at_vertices.size(); ++v)
        for (unsigned int w = 0; w < at_vertices.size(); ++w)
          sum += masses(v, w) * (at_vertices[v] * at_vertices[w]);
      return sum;
    }

    /// Squares over the body, and the root mean square in a cell.
    struct Sums
    {
      explicit Sums(const unsigned int n_cells) : cells(n_cells) {}

      void add(const unsigned int cell, const double volume, const double error, const double gradient)
      {
        cells(cell) = std::sqrt(error / volume);
        errors += error;
        gradients += gradient;
      }

      dealii::Vector<float> cells;
      double                errors = 0., gradients = 0.;
    };

    template <int dim>
    void add_linear(const Field<dim>     &nodes,
                    const TissueMap<dim> &tissues,
                    const Field<dim>     &field,
                    const Vector         &x,
                    Sums                 &sums)
    {
      const auto &fe        = nodes.element();
      const bool  one_place = nodes.mesh().simplices(); // the gradient is constant there
      const auto  places = one_place ? centre(nodes.mesh()) : Quadrature<dim>(fe.get_unit_support_points());
      CellDerivatives<dim, 1> gradients(nodes, field, x, places);
      VertexAverages<dim>     averages(nodes, tissues, field.n_components());
      averages.add(gradients, one_place);

      const FullMatrix<double>    masses = vertex_masses(nodes.mesh(), fe);
      std::vector<Tensor<1, dim>> found(fe.n_dofs_per_cell()), wrong(found);
      for (const auto &cell : nodes.dof_handler().active_cell_iterators())
        {
          if (!cell->is_locally_owned())
            continue;
          gradients.reinit(cell);
          double error = 0., gradient = 0.;
          for (unsigned int c = 0; c < field.n_components(); ++c)
            {
              for (unsigned int v = 0; v < found.size(); ++v)
                {
                  found[v] = gradients(one_place ? 0 : v, c);
                  wrong[v] = averages(cell, v, c) - found[v];
                }
              error += mean_square(masses, wrong);
              gradient += mean_square(masses, found);
            }
          const double volume = cell->measure();
          sums.add(cell->active_cell_index(), volume, volume * error, volume * gradient);
        }
    }

    template <int dim>
    void add_quadratic(const Field<dim>     &nodes,
                       const TissueMap<dim> &tissues,
                       const Field<dim>     &field,
                       const Vector         &x,
                       Sums                 &sums)
    {
      CellDerivatives<dim, 2> second(nodes, field, x, centre(nodes.mesh()));
      CellDerivatives<dim, 1> gradients(nodes, field, x, nodes.cell_quadrature());
      CubicRemainder<dim>     remainder(nodes);
      std::vector<double>     errors(sums.cells.size(), 0.), norms(errors);
      for (unsigned int c = 0; c < field.n_components(); ++c)
        {
          VertexMoments<dim> moments(nodes, tissues);
          moments.add(second, c);
          for (const auto &cell : nodes.dof_handler().active_cell_iterators())
            {
              if (!cell->is_locally_owned())
                continue;
              remainder.reinit(cell);
              gradients.reinit(cell);
              errors[cell->active_cell_index()] += remainder.square(moments.around(cell).slope());
              for (const unsigned int q : remainder.values().quadrature_point_indices())
                norms[cell->active_cell_index()] += gradients(q, c).norm_square() * remainder.values().JxW(q);
            }
        }
      for (const auto &cell : nodes.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          sums.add(cell->active_cell_index(),
                   cell->measure(),
                   errors[cell->active_cell_index()],
                   norms[cell->active_cell_index()]);
    }
  } // namespace

  template <int dim>
  GradientError gradient_error(const Field<dim>     &nodes,
                               const TissueMap<dim> &tissues,
                               const Field<dim>     &field,
                               const Vector         &x)
  {
    Sums sums(nodes.mesh().triangulation().n_active_cells());
    if (nodes.element().degree == 1)
      add_linear(nodes, tissues, field, x, sums);
    else
      add_quadratic(nodes, tissues, field, x, sums);
    GradientError result;
    result.cells    = std::move(sums.cells);
    result.error    = std::sqrt(Utilities::MPI::sum(sums.errors, nodes.communicator()));
    result.gradient = std::sqrt(Utilities::MPI::sum(sums.gradients, nodes.communicator()));
    return result;
  }

  template GradientError
  gradient_error(const Field<2> &, const TissueMap<2> &, const Field<2> &, const Vector &);
  template GradientError
  gradient_error(const Field<3> &, const TissueMap<3> &, const Field<3> &, const Vector &);
} // namespace Cautery
