// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/field.h>

#include <deal.II/base/qprojector.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <cmath>

namespace Cautery
{
  namespace
  {
    template <int dim>
    std::unique_ptr<FiniteElement<dim>> scalar_element(const Mesh<dim> &mesh, const unsigned int degree)
    {
      if (mesh.simplices())
        return std::make_unique<FE_SimplexP<dim>>(degree);
      return std::make_unique<FE_Q<dim>>(degree);
    }

    template <int dim>
    Quadrature<dim> cell_rule(const Mesh<dim> &mesh, const unsigned int degree, const Numerics::Method method)
    {
      if (method == Numerics::Method::finite_differences)
        return QTrapezoid<dim>();
      // n points integrate polynomials of degree 2n-1, so n = degree+1 does for products; QGaussSimplex ends
      // at n = 4
      if (mesh.simplices())
        return QGaussSimplex<dim>(degree + 1);
      return QGauss<dim>(degree + 1);
    }

    template <int dim>
    Quadrature<dim - 1>
    face_rule(const Mesh<dim> &mesh, const unsigned int degree, const Numerics::Method method)
    {
      if (method == Numerics::Method::finite_differences)
        return QTrapezoid<dim - 1>();
      if (mesh.simplices() && dim == 3)
        return QGaussSimplex<dim - 1>(degree + 1);
      return QGauss<dim - 1>(degree + 1);
    }
  } // namespace

  template <int dim>
  Field<dim>::Field(const Mesh<dim> &mesh, const unsigned int degree, const Numerics::Method method)
    : body(mesh), numerical_method(method), dofs(mesh.triangulation())
  {
    Assert(method == Numerics::Method::finite_elements || (degree == 1 && !mesh.simplices()),
           ExcInternalError());
    dofs.distribute_dofs(*scalar_element(mesh, degree));
    DoFRenumbering::Cuthill_McKee(dofs, true);
    finish(degree);
  }

  template <int dim>
  Field<dim>::Field(const Field<dim> &scalar, const unsigned int n_components)
    : body(scalar.mesh()), numerical_method(scalar.method()), dofs(body.triangulation())
  {
    dofs.distribute_dofs(FESystem<dim>(scalar.element(), n_components));
    follow(scalar.dof_handler());
    finish(scalar.element().degree);
  }

  template <int dim>
  void Field<dim>::finish(const unsigned int degree)
  {
    DoFTools::extract_locally_relevant_dofs(dofs, locally_relevant);
    inside = cell_rule(body, degree, numerical_method);
    faces  = face_rule(body, degree, numerical_method);
    find_face_shapes();
    hanging_constraints.reinit(locally_relevant);
    if (body.triangulation().has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(dofs, hanging_constraints);
    hanging_constraints.close();
    hanging_elimination.reinit(hanging_constraints, owned(), communicator());
  }

  template <int dim>
  void Field<dim>::follow(const DoFHandler<dim> &nodes)
  {
    const FiniteElement<dim>            &fe   = dofs.get_fe();
    const IndexSet                      &mine = dofs.locally_owned_dofs();
    std::vector<types::global_dof_index> numbers(mine.n_elements(), numbers::invalid_dof_index);
    std::vector<types::global_dof_index> of_cell(fe.n_dofs_per_cell());
    std::vector<types::global_dof_index> of_nodes(nodes.get_fe().n_dofs_per_cell());

    auto node_cell = nodes.begin_active();
    for (const auto &cell : dofs.active_cell_iterators())
      {
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(of_cell);
            node_cell->get_dof_indices(of_nodes);
            for (unsigned int i = 0; i < of_cell.size(); ++i)
              if (mine.is_element(of_cell[i]))
                {
                  const auto [component, node]               = fe.system_to_component_index(i);
                  numbers[mine.index_within_set(of_cell[i])] = fe.n_components() * of_nodes[node] + component;
                }
          }
        ++node_cell;
      }
    dofs.renumber_dofs(numbers);
  }

  template <int dim>
  void Field<dim>::find_face_shapes()
  {
    // The shape functions of Lagrange elements on a face do not depend on the cell's form: any cell will do,
    // as a pattern.
    const FiniteElement<dim> &fe       = element();
    const ReferenceCell       kind     = body.reference_cell();
    const Quadrature<dim>     on_faces = QProjector<dim>::project_to_all_faces(kind, faces);
    face_shapes.assign(kind.n_faces(), {});
    for (const unsigned int face : kind.face_indices())
      {
        const auto start =
          QProjector<dim>::DataSetDescriptor::face(kind, face, true, false, false, faces.size());
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
          {
            const unsigned int base  = fe.n_components() == 1 ? i : fe.system_to_component_index(i).second;
            double             found = 0.;
            for (unsigned int q = 0; q < faces.size(); ++q)
              found += std::abs(fe.base_element(0).shape_value(base, on_faces.point(start + q)));
            if (found > 1e-10)
              face_shapes[face].push_back(i);
          }
      }
  }

  template <int dim>
  Vector Field<dim>::ghosted(const Vector &values) const
  {
    Vector result(owned(), relevant(), communicator());
    result = values;
    return result;
  }

  /// Which shape functions of a cell (rows) meet which of @p columns in a matrix; empty: all do.
  template <int dim>
  Table<2, bool> Field<dim>::couplings(const Field<dim> &columns) const
  {
    if (numerical_method == Numerics::Method::finite_elements)
      return {};
    // By the trapezoidal rule nodes meet at corners: a value reaches its own, a derivative the next along an
    // edge. Two derivatives along the same direction meet on an edge, along two directions on a face.
    const bool vectors = n_components() > 1 && columns.n_components() > 1;
    const auto nodes   = [](const Field<dim> &field, const unsigned int i) {
      return field.element().unit_support_point(i);
    };
    Table<2, bool> result(element().n_dofs_per_cell(), columns.element().n_dofs_per_cell());
    for (unsigned int i = 0; i < result.size(0); ++i)
      for (unsigned int j = 0; j < result.size(1); ++j)
        {
          const unsigned int edges_between =
            std::lround((nodes(*this, i) - nodes(columns, j)).norm_square()); // in the unit cell
          result(i, j) = edges_between <= (vectors ? 2 : 1);
        }
    return result;
  }

  namespace
  {
    /// AffineConstraints knows no mask for rows and columns of different fields.
    void add_entries(const std::vector<types::global_dof_index> &rows,
                     const std::vector<types::global_dof_index> &columns,
                     const Table<2, bool>                       &mask,
                     DynamicSparsityPattern                     &pattern)
    {
      std::vector<types::global_dof_index> entries;
      for (unsigned int i = 0; i < rows.size(); ++i)
        {
          entries.clear();
          for (unsigned int j = 0; j < columns.size(); ++j)
            if (mask.empty() || mask(i, j))
              entries.push_back(columns[j]);
          pattern.add_entries(rows[i], entries.begin(), entries.end());
        }
    }
  } // namespace

  template <int dim>
  void Field<dim>::initialize_matrix(SparseMatrix                    &matrix,
                                     const Field<dim>                &columns,
                                     const AffineConstraints<double> *constraints) const
  {
    const Table<2, bool>                 mask = couplings(columns);
    DynamicSparsityPattern               pattern(n_unknowns(), columns.n_unknowns(), relevant());
    std::vector<types::global_dof_index> row_dofs(element().n_dofs_per_cell());
    std::vector<types::global_dof_index> column_dofs(columns.element().n_dofs_per_cell());
    auto                                 column_cell = columns.dof_handler().begin_active();
    for (const auto &cell : dofs.active_cell_iterators())
      {
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(row_dofs);
            column_cell->get_dof_indices(column_dofs);
            if (constraints != nullptr)
              constraints->add_entries_local_to_global(row_dofs, pattern, false, mask);
            else
              add_entries(row_dofs, column_dofs, mask, pattern);
          }
        ++column_cell;
      }
    SparsityTools::distribute_sparsity_pattern(pattern, owned(), communicator(), relevant());
    matrix.reinit(owned(), columns.owned(), pattern, communicator());
  }

  template class Field<2>;
  template class Field<3>;
} // namespace Cautery
