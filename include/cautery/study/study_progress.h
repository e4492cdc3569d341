// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/study/outcome.h>

#include <deal.II/base/timer.h>

namespace Cautery
{
  /**
   * Says on one process how far a study of many runs has come: a line for each run.
   */
  class StudyProgress
  {
  public:
    /** @p n_runs 0: it is not known how many there will be. */
    StudyProgress(const unsigned int n_runs, const bool speaks) : n_runs(n_runs), speaks(speaks) {}

    void say(const std::string &what, const Outcome &outcome);

  private:
    const unsigned int n_runs;
    const bool         speaks;
    unsigned int       done = 0;
    Timer              timer;
  };
} // namespace Cautery
