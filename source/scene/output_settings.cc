// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/names.h>
#include <cautery/scene/output_settings.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  std::vector<double> OutputSettings::output_times(const double end) const
  {
    std::vector<double> all = times;
    if (interval > 0.)
      for (unsigned int i = 1; i * interval < end * (1. - 1e-12); ++i)
        all.push_back(i * interval);
    all.push_back(end);
    std::sort(all.begin(), all.end());
    // 0.1 * 30 and 3 are the same time
    const auto same = [end](const double a, const double b) { return std::abs(a - b) < 1e-12 * end; };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return all;
  }

  std::vector<Probe> OutputSettings::probes() const
  {
    std::vector<Probe> result;
    for (unsigned int i = 0; i < probe_names.size(); ++i)
      result.push_back({probe_names[i], probe_places[i]});
    return result;
  }

  void CheckpointSettings::parameters(Parameters &p)
  {
    p.entry("Steps",
            steps,
            "Steps of the time loop between two checkpoints, from which `--resume` goes on; 0: not by their "
            "number. "
            "IDA starts anew at each of them");
    p.entry(
      "Minutes",
      minutes,
      "min",
      "Wall time between two checkpoints; 0: not by the clock. Where Steps is 0, IDA starts anew every 200 "
      "steps, and the checkpoint is of the last of these",
      Bounds::non_negative());
  }

  void OutputSettings::parameters(Parameters &p)
  {
    p.entry(
      "Directory", directory, "Where the run writes; empty: `output/` and the name of the scene's file");
    p.entry(
      "Interval", interval, "s", "Time between outputs; 0: only `Times` and the end", Bounds::non_negative());
    p.entry("Times", times, "s", "Further output times", Bounds::positive());
    p.entry("Fields", fields, "Write solution.pvd with its .vtu files at the output times");
    p.entry(
      "Stress",
      stress,
      Choices<Stress>{{"Cauchy", Stress::cauchy}, {"second Piola-Kirchhoff", Stress::second_piola_kirchhoff}},
      "Which stress is written, in large deformation: force per deformed area, or S of the undeformed body");
    p.entry("Reactions",
            reactions,
            "Write reactions.csv: the force (N) that each support and tool exerts on the body at the output "
            "times, but for the inertia of the nodes that it holds. A node where several meet counts for "
            "one: first "
            "prescribed displacements, then tools, then rollers, each in the order of their names");
    p.entry("Probe names", probe_names, "Names of the probes");
    p.entry("Probe places", probe_places, "m", "Places of the probes, x, y, z; separated by semicolons");
    p.entry("Ablation centre", ablation_centre, "m", "Point from which the ablation radius is measured");
    p.entry("Every step", every_step, "Write a line for every step to the log");
    p.section("Checkpoints", [&]() { checkpoints.parameters(p); });
    if (!p.reading())
      return;
    if (probe_names.size() != probe_places.size())
      p.reject("Probe names",
               join(probe_names),
               "there are " + std::to_string(probe_names.size()) + " names for " +
                 std::to_string(probe_places.size()) + " places; give each probe one of both");
    if (const auto fault = fault_of_names(probe_names); !fault.empty())
      p.reject("Probe names", join(probe_names), fault);
  }
} // namespace Cautery
