// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/inverted_cell.h>
#include <cautery/physics/tissue_elasticity.h>
#include <cautery/physics/tled_cells.h>
#include <cautery/physics/tled_nodes.h>
#include <cautery/scene/scene.h>
#include <cautery/space/assignment.h>

#include <list>

namespace Cautery
{
  /**
   * The cells of a body, tissue by tissue, as the explicit kernel reads them: forces and heat flow from the
   * records of nodes (displacement in m, temperature above `reference_temperature` in K).
   */
  template <typename Number>
  class TledBody
  {
  public:
    using Records = typename TledNodes<Number>::Records;

    /** Fibres without resistance to compression: as their law says, or as if they were taut at any stretch.
     */
    enum class SlackFibres
    {
      as_they_are,
      as_if_taut
    };

    /** What a sweep over the cells finds. */
    enum class Part
    {
      motion,
      heat,
      both
    };

    /** Arguments must live as long as it. Errors: ExcInput for what the explicit kernel does not know. */
    TledBody(const Scene             &scene,
             const Field<3>          &nodes,
             const TissueMap<3>      &tissues,
             const TledNodes<Number> &records);

    /**
     * Adds forces (N) and heat flow (W) of the cells of this process to @p forces, also for nodes of other
     * processes. False where one of its cells is turned inside out.
     */
    bool add_forces(const Part        part,
                    const Records    &values,
                    Records          &forces,
                    const SlackFibres slack = SlackFibres::as_they_are);

    /** The cell of all processes with the least J for these @p values, if that is at most @p most; slow, for
     * the message. Collective. */
    std::optional<InvertedCell> inverted(const Records &values, const double most = 0.) const;

    /** Lumped masses of the process's nodes (kg), as far as its own cells carry them. */
    std::vector<double> masses() const;

    /** The cells' resistance to their corners' motion, in the mean of all directions, N/m: masses like these
     * make all cells vibrate about equally fast. */
    std::vector<double> stiffnesses() const;

    /** Whether fibres of some tissue bear tension only. */
    bool fibres_buckle() const;

    double reference_temperature() const { return zero_temperature; } ///< K

    const TledKernel<Number> &kernel() const { return loops; }

  private:
    template <int corners>
    struct Pack
    {
      Pack(CellMesh<corners> mesh, const unsigned int lanes, const int n_points);

      CellMesh<corners>          mesh;
      TledCells<corners, Number> cells;
    };

    /** Averaged nodal pressure of one tissue. */
    struct Pressures
    {
      typename TledKernel<Number>::Sweep     find_volumes;
      NodePressures<Number>                  step;
      typename NodeExchange<Number>::Numbers volumes, volume_changes, pressures; ///< see NodePressures
    };

    /** The cells of one tissue, and the loops that its effects need. */
    struct Share
    {
      unsigned int                                      tissue;     ///< its index
      std::unique_ptr<Pack<4>>                          tetrahedra; ///< one of the two
      std::unique_ptr<Pack<8>>                          hexahedra;
      std::vector<Fibres>                               fibres, taut_fibres;
      std::unique_ptr<Pressures>                        averaged;
      CellSweep<Number>                                 cells;
      std::array<typename TledKernel<Number>::Sweep, 3> sweeps; ///< by Part
    };

    void check(const Tissue &tissue) const;
    /** Calls work(cell) for the process's cells of tissue @p t, always in the same order. */
    template <typename Work>
    void for_each_cell(const unsigned int t, const Work &work) const;
    template <int corners>
    CellMesh<corners> cells_of(const unsigned int t) const;
    void              choose_loops(Share &share);
    void              average_pressure(Share &share, const SweepChoice &choice);
    bool              find_pressures(Pressures &averaged, const CellSweep<Number> &cells);
    template <int corners>
    std::optional<InvertedCell>
    inverted(const Pack<corners> &pack, const unsigned int t, const Records &values, const double most) const;

    const Scene             &scene;
    const Field<3>          &nodes;
    const TissueMap<3>      &tissues;
    const TledNodes<Number> &records;
    const TledKernel<Number> loops;
    double                   zero_temperature;
    NodeExchange<Number>     scalars;
    std::list<Share>         shares;
  };
} // namespace Cautery
