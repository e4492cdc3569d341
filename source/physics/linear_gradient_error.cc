// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/cell_derivatives.h>
#include <cautery/physics/gradient_sums.h>

#include <deal.II/lac/full_matrix.h>

namespace Cautery
{
  namespace
  {
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
                const std::size_t place = vertex_slot(nodes, tissues, cell, v);
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
        const std::size_t place = vertex_slot(nodes, tissues, cell, vertex);
        return sums[place * n_components + component] / volumes[place];
      }

    private:
      const Field<dim>           &nodes;
      const TissueMap<dim>       &tissues;
      const unsigned int          n_components;
      std::vector<double>         volumes;
      std::vector<Tensor<1, dim>> sums;
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
  } // namespace

  template <int dim>
  void add_linear_errors(const Field<dim>     &nodes,
                         const TissueMap<dim> &tissues,
                         const Field<dim>     &field,
                         const Vector         &x,
                         GradientSums         &sums)
  {
    const auto &fe        = nodes.element();
    const bool  one_place = nodes.mesh().simplices(); // the gradient is constant there
    const auto places = one_place ? cell_centre(nodes.mesh()) : Quadrature<dim>(fe.get_unit_support_points());
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

  template void
  add_linear_errors(const Field<2> &, const TissueMap<2> &, const Field<2> &, const Vector &, GradientSums &);
  template void
  add_linear_errors(const Field<3> &, const TissueMap<3> &, const Field<3> &, const Vector &, GradientSums &);
} // namespace Cautery
