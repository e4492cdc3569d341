// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/time_error.h>
#include <cautery/space/state.h>

#include <map>
#include <string>

namespace Cautery
{
  /**
   * Advances a State in time.
   */
  class Integrator
  {
  public:
    virtual ~Integrator() = default;

    /**
     * One step, never beyond @p stop (s), on which the last step before it lands exactly.
     * Errors: ExcRun with the reason; @p state is then that of the last good step.
     */
    virtual void step(State &state, const double stop) = 0;

    /**
     * What it remembers from step to step. @p state, and all balances, are those of the archive already.
     * Collective where it brings back.
     */
    virtual void archive(Archive &archive, const State &state) = 0;

    /** Is that all that its next steps depend on? */
    virtual bool can_be_archived() const { return true; }

    /** Forgets what cannot be archived. */
    virtual void start_anew() {}

    /** Counts that a user may want to know: "linear iterations", ... */
    virtual std::map<std::string, double> statistics() const = 0;

    /** What the steps so far err by, by the name of the balance. Nothing where no estimate exists. */
    virtual std::map<std::string, TimeError> time_errors() const { return {}; }
  };
} // namespace Cautery
