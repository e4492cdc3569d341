// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * Settings from coarse to fine that `cautery accuracy` runs a scene with: a subsection of "Accuracy".
   */
  struct LadderSettings
  {
    /// Which error of the answer ends when the ladder goes on for ever.
    enum class Error
    {
      none, ///< it only compares
      space,
      time,
      solver
    };

    std::string              name;
    std::vector<std::string> entries; ///< "Section/Entry"; empty: the standard ladder of this name
    std::string              rungs;   ///< values separated by "|", of several entries by ";"
    std::string              with;    ///< "Section/Entry = value; ..." for every rung
    std::string              times;   ///< another ladder: every rung of this with every rung of that
    Error                    error = Error::none;
    double                   ratio = 2.; ///< of the discretisation lengths of neighbouring rungs

    void parameters(Parameters &p);
  };

  /**
   * What is asked about the accuracy of a scene: section "Accuracy".
   */
  struct AccuracySettings
  {
    enum class Reference
    {
      richardson, ///< the scene's answer, corrected by what each ladder tends to
      finer_run,
      exact
    };

    std::vector<LadderSettings> ladders;
    std::vector<std::string>    quantities;
    std::vector<double>         tolerances; ///< in a quantity's own unit
    Reference                   reference = Reference::richardson;
    std::string                 finer_run; ///< "Section/Entry = value; ..."
    std::string                 exact;     ///< expressions in t, one for each quantity, separated by ";"
    unsigned int                repeats            = 1;
    double                      temperature_within = 0.; ///< K; 0: the scene's mesh and step count

    void parameters(Parameters &p);
  };
} // namespace Cautery
