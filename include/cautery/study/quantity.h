// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/scene.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Cautery
{
  /**
   * A number of a run's answer, at one time or at all its output times.
   */
  struct Series
  {
    std::vector<double> times; ///< s
    std::vector<double> values;

    /** The largest difference; not comparable (other times): infinity. */
    double distance(const Series &other) const;
    /** The largest magnitude. */
    double size() const;
  };

  /**
   * What a study asks a run for: a column of probes.csv, or a number of summary.json.
   */
  class Quantity
  {
  public:
    /** "PROBE COLUMN", "PROBE COLUMN at TIME" or "/path/in/summary". Errors: ExcInput for another text. */
    explicit Quantity(const std::string &text);

    const std::string &text() const { return name; }
    /** What its name ends in, if that is a unit, with a blank before it. */
    std::string unit() const;
    /** Ends in a unit, as all outputs do: is that kelvin? */
    bool is_temperature() const;

    /** From the files that a run left in @p directory; empty where they do not have it. */
    Series read(const std::string &directory) const;

  private:
    Series read_probe(const std::string &file_name) const;
    Series read_summary(const std::string &file_name) const;

    std::string           name;
    std::string           probe;  ///< empty: a number of the summary
    std::string           column; ///< or its path
    std::optional<double> time;
  };

  /** Those that the scene asks for, or temperatures of its first probes, extremes, and the ablation zone. */
  std::vector<Quantity> quantities_of(const Scene &scene);
} // namespace Cautery
