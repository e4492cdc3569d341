// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/expression.h>
#include <cautery/physics/tled_nodes.h>

#include <vector>

namespace Cautery
{
  /**
   * The numbers in the records of a process's own nodes that expressions of the scene prescribe, in explicit
   * steps. Those of expressions that do not depend on time settle, and cost nothing then.
   */
  template <typename Number>
  class HeldRecords
  {
  public:
    using Records = typename TledNodes<Number>::Records;
    struct Held
    {
      std::uint32_t     entry; ///< of the records
      const Expression *value; ///< lives longer
      Point<3>          place;
    };

    HeldRecords() = default;
    explicit HeldRecords(std::vector<Held> all);

    const std::vector<Held> &all() const { return held; }

    /** How many of them stay as they are: the first ones. */
    std::size_t n_settled() const { return settled; }
    /** Tells it again, from an archive. */
    void set_settled(const std::size_t n) { settled = n; }

    /** Sets what NodeStep needs: only set_rates() changes their rates. */
    void keep_rates(Records &keep, Records &gain) const;

    /** Sets @p rates so that after a step of @p duration (s) to the time @p to the @p values, which are told
     * from @p zero on, are those prescribed. */
    void set_rates(
      const double to, const double duration, const double zero, const Records &values, Records &rates);

  private:
    std::vector<Held> held;
    std::size_t       settled = 0;
  };
} // namespace Cautery
