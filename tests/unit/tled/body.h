// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/elastic_law.h>
#include <cautery/physics/tled_cells.h>

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
    int         n_points = 1;
  };
  std::vector<Case> cases();

  /** A point of integration of some cell. */
  struct CellPoint
  {
    std::vector<std::uint32_t>   nodes;
    std::vector<Vector3<double>> gradients; ///< of the nodes' shape functions
    std::vector<double>          shapes;    ///< their values
    double                       volume;
  };

  /** The unit cube in 3 x 3 x 3 hexahedra, or six tetrahedra for each, its inner nodes moved at random. */
  struct Body
  {
    SweepChoice            choice;
    int                    n_points;
    double                 lambda = Test::lambda; ///< Pa
    std::vector<Point<3>>  nodes;
    TetrahedraMesh         tetrahedra; ///< one of the two has cells
    HexahedraMesh          hexahedra;
    std::vector<CellPoint> points;
    ElasticLaw::Directions directions; ///< of the fibres, the same in all cells
    ElasticLaw             law;        ///< the same physics, for single points (see cell_law)

    SweepMaterial material() const
    {
      return {lambda, mu, law.fibres.data(), law.fibres.size(), expansion, conductivity};
    }

    /** Without the pressure that is averaged. */
    ElasticLaw cell_law() const
    {
      ElasticLaw result = law;
      if (choice.averaged_pressure)
        result.ground = NeoHookean{0., mu};
      return result;
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
  /** 1 + alpha (T - T_0), or its exponential, or 1. */
  double thermal_stretch(const Body &body, const double heating);
  /** k I in the reference body, k J C^-1 in the deformed one, W/(m K). */
  Tensor<2, 3> conductivity_tensor(const Body &body, const Tensor<2, 3> &f);
  /** P = F S from Eq. 7-14 with the right J. */
  Tensor<2, 3> textbook_first_stress(const Body &body, const Tensor<2, 3> &f, const double heating);

  /** Forces from the kernel; @p hourglass is for hexahedra with one point. */
  template <typename Number>
  Records lane_forces(const Body          &body,
                      const Records       &values,
                      const InstructionSet instruction_set,
                      const double         hourglass = 0.);
  /** Does the kernel find every cell sound? */
  template <typename Number>
  bool is_healthy(const Body &body, const Records &values, const InstructionSet instruction_set);
} // namespace Cautery::Test
