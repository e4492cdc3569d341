// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/elastic_law.h>
#include <cautery/physics/tled_tetrahedra.h>

#include <deal.II/base/symmetric_tensor.h>

#include <string>
#include <vector>

namespace Cautery::Test
{
  constexpr double lambda = 2347.3, mu = 1006., expansion = 3e-4, conductivity = 0.613;

  /// Node records.
  using Records = std::vector<double>;

  /** What the kernel is told to compute. */
  struct Case
  {
    std::string name;
    SweepChoice choice;
  };
  std::vector<Case> cases();

  /** The unit cube in 3 x 3 x 3 x 6 tetrahedra, its inner nodes moved at random, with other fibres in each
   * cell. */
  struct Body
  {
    SweepChoice    choice;
    TetrahedraMesh mesh;
    ElasticLaw     law; ///< the same physics, for single points

    SweepMaterial material() const
    {
      return {lambda, mu, law.fibres.data(), law.fibres.size(), expansion, conductivity};
    }
  };
  Body make_body(const Case &item);
  bool is_inside(const Body &body, const unsigned int node);

  /** Random displacements up to @p size, m, and temperatures up to 30 K. */
  Records random_values(const Body &body, const double size);
  /** x = F X + shift, m, everywhere @p heating, K. */
  Records
  affine_values(const Body &body, const Tensor<2, 3> &f, const Vector3<double> &shift, const double heating);
  Tensor<2, 3> rotation();

  /** Forces cell by cell from the laws in plain double precision. */
  Records scalar_forces(const Body &body, const Records &values);
  /** The strain energy of the body, J. */
  double energy(const Body &body, const Records &values);
  /** P = F S from Eq. 7-14 with the right J, for the first cell's fibres, which must be everybody's. */
  Tensor<2, 3> textbook_first_stress(const Body &body, const Tensor<2, 3> &f, const double heating);

  /** Forces from the kernel. */
  template <typename Number>
  Records lane_forces(const Body &body, const Records &values, const InstructionSet instruction_set);
  /** Does the kernel find every cell sound? */
  template <typename Number>
  bool is_healthy(const Body &body, const Records &values, const InstructionSet instruction_set);
} // namespace Cautery::Test
