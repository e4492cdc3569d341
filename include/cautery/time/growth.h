// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/tled_nodes.h>

namespace Cautery
{
  /**
   * Throws ExcRun where the @p values (records of nodes) grow without bounds or are no numbers: a
   * displacement of more than @p far (m), or a temperature more than 1e5 K away from the reference. For laws
   * that know no inverted cell, and for heat. @p time (s) is for the message. Collective.
   */
  template <typename Number>
  void check_growth(const TledNodes<Number>                   &nodes,
                    const typename TledNodes<Number>::Records &values,
                    const double                               far,
                    const double                               time);
} // namespace Cautery
