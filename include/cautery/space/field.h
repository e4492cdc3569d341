// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>
#include <cautery/scene/numerics.h>
#include <cautery/space/elimination.h>
#include <cautery/space/mesh.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe.h>
#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <vector>

namespace Cautery
{
  /**
   * A field on a mesh: Lagrange elements of degree 1 or 2 on simplices or hypercubes, with one component (a
   * temperature) or dim components (a displacement).
   *
   * Finite differences are elements of degree 1 on the cells of a grid, integrated by the trapezoidal rule:
   * that gives exactly the stencils of thesis Eqs. 4-29 and 4-30 times the volume that belongs to a node, and
   * beyond the thesis what they are at surfaces and between tissues. So they need no code of their own.
   *
   * The unknowns of a vector field follow the nodes of the scalar field: component c of node n is unknown dim
   * n + c, on the same process. So nodal values of both belong together without any map, and multigrid finds
   * its blocks.
   */
  template <int dim>
  class Field
  {
  public:
    /** The scalar field, whose nodes are numbered by reverse Cuthill-McKee. */
    Field(const Mesh<dim>       &mesh,
          const unsigned int     degree,
          const Numerics::Method method = Numerics::Method::finite_elements);

    /** The vector field on the nodes of @p scalar. */
    explicit Field(const Field<dim> &scalar, const unsigned int n_components);

    const Mesh<dim>          &mesh() const { return body; }
    const Mapping<dim>       &mapping() const { return body.mapping(); }
    MPI_Comm                  communicator() const { return body.communicator(); }
    const FiniteElement<dim> &element() const { return dofs.get_fe(); }
    const DoFHandler<dim>    &dof_handler() const { return dofs; }
    const IndexSet           &owned() const { return dofs.locally_owned_dofs(); }
    const IndexSet           &relevant() const { return locally_relevant; }
    unsigned int              n_components() const { return element().n_components(); }
    types::global_dof_index   n_unknowns() const { return dofs.n_dofs(); }

    Numerics::Method method() const { return numerical_method; }

    /**
     * Nodes on faces and edges of larger cells follow the nodes of these, so that the field is continuous.
     * Empty but on an adapted mesh.
     */
    const AffineConstraints<double> &hanging_nodes() const { return hanging_constraints; }
    /** The same, to apply to vectors. */
    const Elimination &hanging() const { return hanging_elimination; }

    /** Finite elements: exact for the products of two shape functions on affine cells. Finite differences:
     * the corners. */
    const Quadrature<dim>     &cell_quadrature() const { return inside; }
    const Quadrature<dim - 1> &face_quadrature() const { return faces; }

    /** Local numbers of the shape functions that do not vanish on face @p face of a cell. */
    const std::vector<unsigned int> &on_face(const unsigned int face) const { return face_shapes[face]; }

    /** The field's view of a cell of the mesh. */
    typename DoFHandler<dim>::active_cell_iterator
    cell(const typename Triangulation<dim>::active_cell_iterator &of_mesh) const
    {
      return {&of_mesh->get_triangulation(), of_mesh->level(), of_mesh->index(), &dofs};
    }

    /** Zero, without ghost entries. */
    Vector vector() const { return Vector(owned(), communicator()); }

    /** A copy that also has the entries of the neighbouring processes, to read from. */
    Vector ghosted(const Vector &values) const;

    /**
     * An empty matrix with rows of this field and columns of @p columns, coupling all unknowns of a cell (by
     * finite differences: of its edges, and for two vector fields of its faces); rows and columns that
     * @p constraints removes keep their diagonal only (nullptr: none).
     */
    void initialize_matrix(SparseMatrix                    &matrix,
                           const Field<dim>                &columns,
                           const AffineConstraints<double> *constraints) const;

  private:
    void           finish(const unsigned int degree);
    Table<2, bool> couplings(const Field<dim> &columns) const;
    void           follow(const DoFHandler<dim> &nodes);
    void           find_face_shapes();

    const Mesh<dim>                       &body;
    const Numerics::Method                 numerical_method;
    DoFHandler<dim>                        dofs;
    IndexSet                               locally_relevant;
    AffineConstraints<double>              hanging_constraints;
    Elimination                            hanging_elimination;
    Quadrature<dim>                        inside;
    Quadrature<dim - 1>                    faces;
    std::vector<std::vector<unsigned int>> face_shapes;
  };

  /** A place in three coordinates, as scenes know them. */
  template <int dim>
  Point<3> in_space(const Point<dim> &place)
  {
    Point<3> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = place[d];
    return result;
  }
} // namespace Cautery
