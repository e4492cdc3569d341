// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/prescribed.h>

#include <deal.II/base/mpi.h>

#include <set>

namespace Cautery
{
  template <int dim>
  Prescribed<dim>::Prescribed(const Field<dim>       &field,
                              const BoundaryMap<dim> &boundaries,
                              const Chooser          &chooser)
    : field(field)
  {
    const FiniteElement<dim>            &fe = field.element();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      {
        if (cell->is_artificial() || !cell->at_boundary())
          continue;
        cell->get_dof_indices(dofs);
        for (const unsigned int face : cell->face_indices())
          {
            if (!cell->face(face)->at_boundary() || cell->face(face)->boundary_id() == no_surface)
              continue;
            const unsigned int boundary = boundaries.index(cell->face(face)->boundary_id());
            for (const unsigned int i : field.on_face(face))
              {
                const auto        component = fe.system_to_component_index(i).first;
                const Expression *expression =
                  chooser(boundaries[cell->face(face)->boundary_id()], component);
                if (expression == nullptr || field.hanging_nodes().is_constrained(dofs[i]))
                  continue;
                const auto place =
                  field.mapping().transform_unit_to_real_cell(cell, fe.unit_support_point(i));
                const auto [known, is_new] =
                  values.insert({dofs[i], {boundary, expression, in_space<dim>(place)}});
                if (!is_new && boundary < known->second.boundary)
                  known->second = {boundary, expression, in_space<dim>(place)};
              }
          }
      }
  }

  template <int dim>
  unsigned int Prescribed<dim>::add_within(const Point<3>         &centre,
                                           const double            radius,
                                           const VectorExpression &displacement)
  {
    const FiniteElement<dim>            &fe = field.element();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::set<types::global_dof_index>    own;
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const Point<3> place =
              in_space<dim>(field.mapping().transform_unit_to_real_cell(cell, fe.unit_support_point(i)));
            if (place.distance(centre) > radius || field.hanging_nodes().is_constrained(dofs[i]))
              continue;
            const auto component = fe.system_to_component_index(i).first;
            values.insert({dofs[i], {numbers::invalid_unsigned_int, &displacement[component], place}});
            if (component == 0 && field.owned().is_element(dofs[i]))
              own.insert(dofs[i]);
          }
      }
    return Utilities::MPI::sum(static_cast<unsigned int>(own.size()), field.communicator());
  }

  template <int dim>
  void Prescribed<dim>::constrain(AffineConstraints<double> &constraints) const
  {
    for (const auto &[dof, value] : values)
      constraints.add_line(dof);
  }

  template <int dim>
  void Prescribed<dim>::set(const double time, Vector &x) const
  {
    for (const auto &[dof, value] : values)
      if (field.owned().is_element(dof))
        x(dof) = value.expression->value(value.place, time);
    x.compress(VectorOperation::insert);
    field.hanging().distribute(x);
  }

  template <int dim>
  bool Prescribed<dim>::homogeneous() const
  {
    bool zero = true;
    for (const auto &[dof, value] : values)
      zero = zero && value.expression->is_constant() && value.expression->value(Point<3>(), 0.) == 0.;
    return Utilities::MPI::min(zero ? 1 : 0, field.communicator()) == 1;
  }

  template <int dim>
  bool Prescribed<dim>::depends_on_time() const
  {
    bool changes = false;
    for (const auto &[dof, value] : values)
      changes = changes || value.expression->depends_on_time();
    return Utilities::MPI::max(changes ? 1 : 0, field.communicator()) == 1;
  }

  template <int dim>
  double Prescribed<dim>::sum(const Vector &x) const
  {
    double local = 0.;
    for (const auto &[dof, value] : values)
      if (field.owned().is_element(dof))
        local += x(dof);
    return Utilities::MPI::sum(local, field.communicator());
  }

  template class Prescribed<2>;
  template class Prescribed<3>;
} // namespace Cautery
