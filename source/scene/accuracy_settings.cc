// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/accuracy_settings.h>

namespace Cautery
{
  void LadderSettings::parameters(Parameters &p)
  {
    p.entry("Entries",
            entries,
            "Entries of the scene that change from rung to rung, `Section/Entry`; empty: the standard ladder "
            "of this name");
    p.entry(
      "Rungs", rungs, "Their values, from coarse to fine, separated by `|`; those of several entries by `;`");
    p.entry("With", with, "Entries that are the same on all rungs, `Section/Entry = value; ...`");
    p.entry("Times", times, "Another ladder: each rung of this one is run with each rung of that one");
    p.entry(
      "Error",
      error,
      Choices<Error>{
        {"none", Error::none}, {"space", Error::space}, {"time", Error::time}, {"solver", Error::solver}},
      "What vanishes as the ladder goes on, for Richardson's extrapolation; none: it only compares");
    p.entry("Ratio",
            ratio,
            "",
            "Of the lengths (cell, step) of neighbouring rungs, for observed orders",
            Bounds{1., 1e6, true, false});
    if (p.reading() && entries.empty() != rungs.empty())
      p.reject(entries.empty() ? "Rungs" : "Entries",
               entries.empty() ? rungs : join(entries),
               "Entries and Rungs go together; give both, or none of a standard ladder");
  }

  void AccuracySettings::parameters(Parameters &p)
  {
    p.entry(
      "Quantities",
      quantities,
      "What is judged: `PROBE COLUMN` of probes.csv, at all output times or `PROBE COLUMN at TIME`; or a "
      "number of summary.json by its path, as `/ablation/volume_m3`; empty: temperatures of probes, "
      "extremes and the ablation zone");
    p.entry(
      "Tolerances",
      tolerances,
      "",
      "For which the cheapest setting is sought, in the unit of each quantity; empty: 1, 0.1 and 0.01 K, "
      "of other quantities 10, 1 and 0.1 %",
      Bounds::positive());
    p.entry("Reference",
            reference,
            Choices<Reference>{{"Richardson", Reference::richardson},
                               {"finer run", Reference::finer_run},
                               {"exact", Reference::exact}},
            "What counts for true: the scene's answer with the corrections that each ladder extrapolates to, "
            "a run with finer settings, or exact values");
    p.entry("Finer run", finer_run, "Its settings, `Section/Entry = value; ...`");
    p.entry(
      "Exact values", exact, "Expressions in t (s), one for each quantity in its order, separated by `;`");
    p.entry(
      "Repeats", repeats, "Runs of each setting, whose median time counts", Bounds{1., 1000., false, false});
    p.entry("Temperature within",
            temperature_within,
            "K",
            "0: mesh and step are the scene's. Else a run looks for a mesh and steps itself, with which the "
            "temperature of the probes (without probes the highest) errs by no more than this; `cautery "
            "accuracy` leaves it aside",
            Bounds::non_negative());
    if (!p.reading())
      return;
    if (reference == Reference::finer_run && finer_run.empty())
      p.reject("Finer run", "", "give its settings, or choose another Reference");
    if (reference == Reference::exact && exact.empty())
      p.reject("Exact values", "", "give one for each quantity, or choose another Reference");
  }
} // namespace Cautery
