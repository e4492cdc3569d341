// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/cell_derivatives.h>
#include <cautery/physics/gradient_sums.h>

#include <limits>

namespace Cautery
{
  namespace
  {
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
              moments[vertex_slot(nodes, tissues, cell, v)].add(second(0, component),
                                                                cell->center() - cell->vertex(v));
          }
      }

      /** Of the cells that share a vertex with @p cell, counted for each that they share. */
      Moments<dim> around(const typename DoFHandler<dim>::active_cell_iterator &cell) const
      {
        Moments<dim> sum;
        for (const unsigned int v : cell->vertex_indices())
          sum.add(moments[vertex_slot(nodes, tissues, cell, v)], cell->vertex(v) - cell->center());
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
  } // namespace

  template <int dim>
  void add_quadratic_errors(const Field<dim>     &nodes,
                            const TissueMap<dim> &tissues,
                            const Field<dim>     &field,
                            const Vector         &x,
                            GradientSums         &sums)
  {
    CellDerivatives<dim, 2> second(nodes, field, x, cell_centre(nodes.mesh()));
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

  template void add_quadratic_errors(
    const Field<2> &, const TissueMap<2> &, const Field<2> &, const Vector &, GradientSums &);
  template void add_quadratic_errors(
    const Field<3> &, const TissueMap<3> &, const Field<3> &, const Vector &, GradientSums &);
} // namespace Cautery
