// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/fibres.h>
#include <cautery/laws/thermal_stretch.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/**
 * @file
 * The innermost loops of total Lagrangian explicit dynamics (thesis 7.3.2): forces of cells, and the step of
 * nodes. They are compiled once for each of some instruction sets, and work on plain arrays only.
 *
 * A node is a record of four numbers, u_x, u_y, u_z (m) and T - T_0 (K; the difference, because single
 * precision holds 310 K to 0.03 mK only), so that one load fetches all of it. Forces are records of the
 * same kind: three internal forces (N) and the heat that flows out of the node's share of the cells (W).
 */

namespace Cautery
{
  /// Numbers in a node's record.
  constexpr unsigned int node_record = 4;

  enum class InstructionSet
  {
    x86_64,    ///< runs everywhere
    x86_64_v3, ///< AVX2 and FMA
    x86_64_v4  ///< AVX-512
  };

  /** The best one that this processor has. */
  InstructionSet best_instruction_set();
  /** All that it has, the best last. */
  std::vector<InstructionSet> instruction_sets();
  std::string                 name(const InstructionSet instruction_set);

  /**
   * What the loop over cells computes. Each choice is a loop of its own: what is off costs nothing.
   */
  struct SweepChoice
  {
    enum class Law
    {
      none, ///< conduction only
      small_strain,
      neo_hookean
    };

    enum class Conduction
    {
      none,
      reference, ///< Fourier's law in the reference body: the flux is k grad T (but for its sign)
      deformed   ///< in the deformed body: k J C^-1 grad T
    };

    Law         law               = Law::neo_hookean;
    StretchForm stretch           = StretchForm::none;
    std::size_t n_fibres          = 0; ///< families, with neo_hookean only
    Conduction  conduction        = Conduction::none;
    bool        hexahedra         = false; ///< else tetrahedra
    bool        averaged_pressure = false; ///< of the nodes, see NodePressures; tetrahedra, neo_hookean only
  };

  /**
   * Parameters that all cells of a sweep share.
   */
  struct SweepMaterial
  {
    double        lambda       = 0.;      ///< Pa
    double        mu           = 0.;      ///< Pa
    const Fibres *fibres       = nullptr; ///< n_fibres families
    std::size_t   n_fibres     = 0;
    double        expansion    = 0.; ///< alpha, 1/K
    double        conductivity = 0.; ///< k, W/(m K)
  };

  /**
   * Cells of degree 1 with n corners in groups of lanes. For each group and each corner stand the lanes'
   * nodes times node_record. For each group stand, lanes side by side, these rows of numbers:
   * - for each point of integration the gradients of the shape functions of corners 1 to n - 1 (1/m; those of
   *   corner 0 balance them) and the volume that the point stands for (m3);
   * - of hexahedra with one point, for each of the four hourglass modes its vector gamma at corners 1 to 7,
   * and at the end the volume times the sum of the squares of all gradients (m);
   * - the unit vectors of the fibre families.
   * Lanes that are left over hold zeros.
   *
   * A hexahedron with one point resists its hourglass modes with forces hourglass (lambda + 2 mu) V |grad
   * N|^2 gamma (gamma.u), and heat with k in the place of lambda + 2 mu (Flanagan and Belytschko 1981;
   * constant in the total Lagrangian form: Joldes, Wittek and Miller 2008). Affine motion it does not see,
   * rotations of the deformed cell neither.
   */
  template <typename Number>
  struct CellSweep
  {
    const std::uint32_t *offsets   = nullptr;
    const Number        *constants = nullptr; ///< on a boundary of 64 bytes
    std::size_t          n_groups  = 0;
    const Number        *values    = nullptr; ///< of nodes, on a boundary of 64 bytes
    Number              *forces    = nullptr; ///< of nodes, on a boundary of 64 bytes; the sweep adds to them
    int                  n_points  = 1;       ///< 1, or for hexahedra also 8
    double               hourglass = 0.;      ///< dimensionless, hexahedra with one point
    SweepMaterial        material;
    Number              *volume_changes = nullptr; ///< of nodes, the sweep of volumes adds to them
    const Number        *pressures      = nullptr; ///< of nodes, for averaged pressure
  };

  /**
   * Averaged nodal pressure, against the locking of tetrahedra that hardly change their volume (Bonet and
   * Burton 1998, Commun. Numer. Meth. Engng 14, 437-449): lambda/2 (ln J)^2 is not the cells' but the nodes',
   * with J the mean over the cells around.
   *
   * A node stands for V = sum V_e / 4 over the cells around it, V s^3 when it is hot and free of stress, with
   * s its thermal stretch. The sweep of volumes gives it volume_change = sum (v_e - V_e s_e^3) / 4, v_e being
   * the cell's volume in the deformed body, so that J = 1 + volume_change / (V s^3). The strain energy
   * sum V s^3 lambda/2 (ln J)^2 then has its slope in the cells' mean of p = lambda ln(J) / J, which turns
   * into forces as any pressure. In homogeneous deformation and heat all is as without averaging.
   *
   * The step: p from volume_change, and volume_change = 0.
   */
  template <typename Number>
  struct NodePressures
  {
    std::size_t   n_nodes = 0;
    const Number *values  = nullptr; ///< node records
    const Number *volumes = nullptr; ///< V, m3, see lumped_volumes; may be 0 at nodes of other materials
    Number       *volume_changes = nullptr; ///< m3
    Number       *pressures      = nullptr; ///< Pa; all arrays on a boundary of 64 bytes
    StretchForm   stretch        = StretchForm::none;
    SweepMaterial material;
  };

  /**
   * The step of nodes by central differences (thesis Eqs. 7-50 and 7-51), in increments:
   * rate = keep rate + gain (load - force - exchange value), value = value + duration rate, force = 0,
   * for each of the four numbers by itself. With mass m, damping c, and duration dt:
   * keep = (m/dt - c/2) / (m/dt + c/2), gain = 1 / (m/dt + c/2); m = 0 is Fourier's heat. Where a value is
   * prescribed, keep = 1, gain = 0, and the rate is the caller's.
   */
  template <typename Number>
  struct NodeStep
  {
    std::size_t   n_nodes  = 0;
    Number       *values   = nullptr;
    Number       *rates    = nullptr; ///< m/s and K/s
    Number       *forces   = nullptr;
    const Number *loads    = nullptr; ///< N and W
    const Number *keep     = nullptr;
    const Number *gain     = nullptr; ///< s/kg and K/J
    const Number *exchange = nullptr; ///< N/m and W/K, from perfusion and convection; may be missing
    double        duration = 0.;      ///< s
    bool          motion   = true;    ///< else displacement, its rate and its force are left alone
    bool          heat     = true;    ///< else temperature, its rate and its flow are left alone
  };

  /** A step of @p n_nodes nodes over @p duration (s), without exchange; the records must live as long as it.
   */
  template <typename Records>
  NodeStep<typename Records::value_type> node_step(const std::size_t n_nodes,
                                                   Records          &values,
                                                   Records          &rates,
                                                   Records          &forces,
                                                   const Records    &loads,
                                                   const Records    &keep,
                                                   const Records    &gain,
                                                   const double      duration)
  {
    NodeStep<typename Records::value_type> step;
    step.n_nodes  = n_nodes;
    step.values   = values.data();
    step.rates    = rates.data();
    step.forces   = forces.data();
    step.loads    = loads.data();
    step.keep     = keep.data();
    step.gain     = gain.data();
    step.duration = duration;
    return step;
  }

  /**
   * The loops in one instruction set. Pick once, call often.
   */
  template <typename Number>
  struct TledKernel
  {
    /// Adds what it computes of all groups. False if a cell is inverted (J <= 0) or its J is no number, which
    /// small_strain and none see with deformed conduction only.
    using Sweep    = bool (*)(const CellSweep<Number> &);
    using Step     = void (*)(const NodeStep<Number> &);
    using Pressure = void (*)(const NodePressures<Number> &);

    unsigned int lanes                         = 1;
    Step         step                          = nullptr;
    Pressure     pressure                      = nullptr;
    Sweep (*find)(const SweepChoice &)         = nullptr; ///< forces; null for what SweepChoice rules out
    Sweep (*find_volumes)(const SweepChoice &) = nullptr; ///< volume_changes, for averaged_pressure
  };

  template <typename Number>
  TledKernel<Number> tled_kernel(const InstructionSet instruction_set);
} // namespace Cautery
