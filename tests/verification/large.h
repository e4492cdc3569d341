// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "block_mesh.h"
#include "chain.h"

namespace Verification
{
  struct Element
  {
    std::string  name;
    bool         tetrahedra;
    unsigned int degree;
  };

  /** A name for what is printed, and what it changes in scenes/large.prm. */
  struct Variant
  {
    std::string           name;
    std::vector<Override> overrides;
  };

  extern const std::vector<Element> elements;
  extern const std::vector<Variant> laws;
  extern const std::vector<Variant> heats; ///< thermal stretch: none, linearised, exact

  std::vector<Override> joined(const std::vector<std::vector<Override>> &lists);

  /** The overrides that make bent cells of the unit cube, turned by @p rotation, the mesh of a scene. */
  std::vector<Override> bent_cube(const Element      &element,
                                  const Tensor<2, 3> &rotation = unit_symmetric_tensor<3>());

  /** The largest difference of displacements and stresses, relative to the largest of their kind, at the last
   * time. */
  double difference(const Outcome &one, const Outcome &other);

  // groups: large_*.cc
  void tangent(Checks &checks);
  void order(Checks &checks);
  void homogeneous(Checks &checks);
  void limits(Checks &checks);
  void cook(Checks &checks);
  void relaxation(Checks &checks);
  void motion(Checks &checks);
  void vibration(Checks &checks);
} // namespace Verification
