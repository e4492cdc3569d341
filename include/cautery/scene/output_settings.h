// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * Named places whose values are written to probes.csv.
   */
  struct Probe
  {
    std::string name;
    Point<3>    place; ///< m
  };

  /**
   * When a run writes its checkpoint, besides when a signal asks for it: subsection "Checkpoints" of
   * "Output".
   */
  struct CheckpointSettings
  {
    unsigned int steps   = 0;  ///< between two; 0: not by their number
    double       minutes = 0.; ///< of wall time between two; 0: not by the clock

    bool on() const { return steps > 0 || minutes > 0.; }
    /** After so many steps an integrator whose memory cannot be stored starts anew; 0: never. */
    unsigned int steps_to_new_start() const { return steps > 0 ? steps : minutes > 0. ? 200 : 0; }

    void parameters(Parameters &p);
  };

  /**
   * What a run writes: section "Output".
   */
  struct OutputSettings
  {
    enum class Stress
    {
      cauchy,
      second_piola_kirchhoff
    };

    std::string              directory;       ///< empty: "output/" and the scene's name
    std::vector<double>      times;           ///< s, besides the interval's
    double                   interval = 0.;   ///< s; 0: only `times` and the end
    bool                     fields   = true; ///< solution.pvd
    std::vector<std::string> probe_names;
    std::vector<Point<3>>    probe_places; ///< m
    Point<3>                 ablation_centre;
    Stress                   stress     = Stress::cauchy; ///< in large deformation
    bool                     reactions  = false;          ///< reactions.csv
    bool                     every_step = false;          ///< a line per step in the log
    CheckpointSettings       checkpoints;

    /** All output times in (0, end], rising, with the end (s). */
    std::vector<double> output_times(const double end) const;
    std::vector<Probe>  probes() const;

    void parameters(Parameters &p);
  };
} // namespace Cautery
