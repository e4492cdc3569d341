// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/coupling.h>
#include <cautery/physics/dilatation.h>

#include <deal.II/fe/fe_values.h>

#include <functional>

namespace Cautery
{
  namespace
  {
    /**
     * For every cell the matrix int N_i d(N_k)/dx_c over nodes i (rows) and the displacement's unknowns (k,
     * c) (columns): what a temperature and a divergence have in common.
     */
    template <int dim>
    void for_each_divergence(
      const Field<dim>                                                &nodes,
      const Field<dim>                                                &displacement,
      const bool                                                       mean_dilatation,
      const std::function<void(const typename DoFHandler<dim>::active_cell_iterator &node_cell,
                               const typename DoFHandler<dim>::active_cell_iterator &displacement_cell,
                               const FullMatrix<double>                             &divergence)> &use)
    {
      FEValues<dim>      values(nodes.mapping(),
                           nodes.element(),
                           nodes.cell_quadrature(),
                           update_values | update_gradients | update_JxW_values);
      Dilatation<dim>    dilatation(mean_dilatation);
      const auto        &vector_element = displacement.element();
      FullMatrix<double> divergence(nodes.element().n_dofs_per_cell(), vector_element.n_dofs_per_cell());
      auto               displacement_cell = displacement.dof_handler().begin_active();
      for (const auto &cell : nodes.dof_handler().active_cell_iterators())
        {
          if (cell->is_locally_owned())
            {
              values.reinit(cell);
              dilatation.reinit(values);
              divergence = 0.;
              for (const unsigned int q : values.quadrature_point_indices())
                for (unsigned int j = 0; j < vector_element.n_dofs_per_cell(); ++j)
                  {
                    const auto [component, node] = vector_element.system_to_component_index(j);
                    const double slope = dilatation.gradient(values, node, q)[component] * values.JxW(q);
                    for (const unsigned int i : values.dof_indices())
                      divergence(i, j) += values.shape_value(i, q) * slope;
                  }
              use(cell, displacement_cell, divergence);
            }
          ++displacement_cell;
        }
    }

    double beta(const Tissue &tissue)
    {
      const double reference = tissue.expansion.reference_temperature;
      return tissue.expansion.beta(tissue.elastic.lame(reference), reference);
    }
  } // namespace

  template <int dim>
  ThermalExpansionOperator<dim>::ThermalExpansionOperator(const Field<dim>     &displacement,
                                                          const Field<dim>     &nodes,
                                                          const TissueMap<dim> &tissues,
                                                          const bool            mean_dilatation)
    : common_reference(tissues.tissue(0).expansion.reference_temperature)
    , reference(displacement.vector())
    , excess(nodes.vector())
    , product(displacement.vector())
  {
    displacement.initialize_matrix(matrix, nodes, nullptr);
    std::vector<types::global_dof_index> rows(displacement.element().n_dofs_per_cell());
    std::vector<types::global_dof_index> columns(nodes.element().n_dofs_per_cell());
    FullMatrix<double>                   local(rows.size(), columns.size());
    dealii::Vector<double>               ones(columns.size()), local_reference(rows.size());
    for_each_divergence<dim>(nodes,
                             displacement,
                             mean_dilatation,
                             [&](const auto &node_cell, const auto &cell, const auto &divergence) {
                               const Tissue &tissue = tissues[cell->material_id()];
                               node_cell->get_dof_indices(columns);
                               cell->get_dof_indices(rows);
                               local.copy_transposed(divergence);
                               local *= beta(tissue);
                               ones = tissue.expansion.reference_temperature - common_reference;
                               local.vmult(local_reference, ones);
                               matrix.add(rows, columns, local);
                               reference.add(rows, local_reference);
                             });
    matrix.compress(VectorOperation::add);
    reference.compress(VectorOperation::add);
  }

  template <int dim>
  void ThermalExpansionOperator<dim>::force_of_change(const Vector &temperature_change, Vector &force) const
  {
    matrix.vmult(force, temperature_change);
  }

  template <int dim>
  void ThermalExpansionOperator<dim>::add_force(const Vector &temperature, Vector &force) const
  {
    // differences of temperature first: a body that is not heated must feel exactly nothing
    excess = temperature;
    excess.add(-common_reference);
    matrix.vmult(product, excess);
    force.add(1., product, -1., reference);
  }

  template <int dim>
  ThermoelasticFeedback<dim>::ThermoelasticFeedback(const Field<dim>     &nodes,
                                                    const Field<dim>     &displacement,
                                                    const TissueMap<dim> &tissues,
                                                    const bool            non_fourier,
                                                    const bool            mean_dilatation)
    : non_fourier(non_fourier)
  {
    nodes.initialize_matrix(feedback, displacement, nullptr);
    if (non_fourier)
      relaxed.reinit(feedback);
    std::vector<types::global_dof_index> rows(nodes.element().n_dofs_per_cell());
    std::vector<types::global_dof_index> columns(displacement.element().n_dofs_per_cell());
    for_each_divergence<dim>(nodes,
                             displacement,
                             mean_dilatation,
                             [&](const auto &node_cell, const auto &cell, const auto &divergence) {
                               const Tissue &tissue = tissues[cell->material_id()];
                               node_cell->get_dof_indices(rows);
                               cell->get_dof_indices(columns);
                               FullMatrix<double> local = divergence;
                               local *= beta(tissue) * tissue.expansion.reference_temperature;
                               feedback.add(rows, columns, local);
                               if (non_fourier)
                                 {
                                   local *= tissue.thermal.relaxation_time;
                                   relaxed.add(rows, columns, local);
                                 }
                             });
    feedback.compress(VectorOperation::add);
    if (non_fourier)
      relaxed.compress(VectorOperation::add);
  }

  template class ThermalExpansionOperator<2>;
  template class ThermalExpansionOperator<3>;
  template class ThermoelasticFeedback<2>;
  template class ThermoelasticFeedback<3>;
} // namespace Cautery
