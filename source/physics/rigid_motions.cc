// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/rigid_motions.h>

#include <algorithm>

namespace Cautery
{
  template <int dim>
  std::vector<Vector> rigid_motions(const Field<dim> &displacement)
  {
    constexpr unsigned int               n_rotations = dim == 3 ? 3 : 1;
    std::vector<Vector>                  modes(dim + n_rotations, displacement.vector());
    const auto                          &fe = displacement.element();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : displacement.dof_handler().active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (displacement.owned().is_element(dofs[i]))
            {
              const unsigned int c = fe.system_to_component_index(i).first;
              const auto         place =
                displacement.mapping().transform_unit_to_real_cell(cell, fe.unit_support_point(i));
              modes[c](dofs[i]) = 1.;
              // rotation r turns axis a = r+1 towards axis b = r+2 (in the plane: 0 towards 1)
              for (unsigned int r = 0; r < n_rotations; ++r)
                {
                  const unsigned int a = dim == 3 ? (r + 1) % 3 : 0;
                  const unsigned int b = dim == 3 ? (r + 2) % 3 : 1;
                  if (c == a)
                    modes[dim + r](dofs[i]) = -place[b];
                  if (c == b)
                    modes[dim + r](dofs[i]) = place[a];
                }
            }
      }
    for (auto &mode : modes)
      mode.compress(VectorOperation::insert);
    return modes;
  }

  template <int dim>
  unsigned int n_free_rigid_motions(const Field<dim> &displacement, const Elimination &constraints)
  {
    // Turns about a far origin are shifts nearly: they are made orthogonal first.
    std::vector<Vector> motions = rigid_motions(displacement);
    for (auto motion = motions.begin(); motion != motions.end(); ++motion)
      {
        for (auto earlier = motions.begin(); earlier != motion; ++earlier)
          motion->add(-(*motion * *earlier), *earlier);
        *motion /= motion->l2_norm();
      }
    // What the constraints take away from each. As many of these as are independent are held.
    for (auto &motion : motions)
      {
        Vector allowed = motion;
        constraints.distribute(allowed);
        motion -= allowed;
      }
    for (auto held = motions.begin(); held != motions.end(); ++held)
      {
        const auto shorter = [](const Vector &a, const Vector &b) { return a.l2_norm() < b.l2_norm(); };
        std::iter_swap(held, std::max_element(held, motions.end(), shorter));
        const double length = held->l2_norm();
        if (length < 1e-9) // of 1; round-off leaves 1e-15
          return motions.end() - held;
        *held /= length;
        for (auto later = held + 1; later != motions.end(); ++later)
          later->add(-(*later * *held), *held);
      }
    return 0;
  }

  template std::vector<Vector> rigid_motions(const Field<2> &);
  template std::vector<Vector> rigid_motions(const Field<3> &);
  template unsigned int        n_free_rigid_motions(const Field<2> &, const Elimination &);
  template unsigned int        n_free_rigid_motions(const Field<3> &, const Elimination &);
} // namespace Cautery
