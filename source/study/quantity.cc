// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/study/quantity.h>

#include <deal.II/base/utilities.h>

#include <boost/tokenizer.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>

namespace Cautery
{
  double Series::distance(const Series &other) const
  {
    if (values.size() != other.values.size())
      return std::numeric_limits<double>::infinity();
    double largest = 0.;
    for (unsigned int i = 0; i < values.size(); ++i)
      if (values[i] != other.values[i]) // ln(Omega) = -infinity in both is the same
        largest = std::max(largest, std::abs(values[i] - other.values[i]));
    return largest;
  }

  double Series::size() const
  {
    double largest = 0.;
    for (const double value : values)
      largest = std::max(largest, std::abs(value));
    return largest;
  }

  namespace
  {
    bool is_path(const std::string &text)
    {
      try
        {
          return text.rfind('/', 0) == 0 && !nlohmann::json::json_pointer(text).empty();
        }
      catch (const nlohmann::json::exception &)
        {
          return false;
        }
    }

    std::optional<double> time_of(const std::string &word)
    {
      double     time  = 0.;
      const auto end   = word.data() + word.size();
      const auto found = std::from_chars(word.data(), end, time);
      return found.ec == std::errc() && found.ptr == end ? std::make_optional(time) : std::nullopt;
    }
  } // namespace

  Quantity::Quantity(const std::string &text) : name(text)
  {
    if (is_path(text))
      {
        column = text;
        return;
      }
    auto words = Utilities::split_string_list(text, ' ');
    if (words.size() >= 4 && words[words.size() - 2] == "at")
      {
        time = time_of(words.back());
        if (time)
          words.resize(words.size() - 2);
        else
          words.clear();
      }
    AssertThrow(words.size() >= 2 && text.front() != '/',
                ExcInput("Accuracy/Quantities: `" + text +
                         "` is neither `PROBE COLUMN`, as `P1 temperature_K`, nor a path in summary.json, as "
                         "`/ablation/volume_m3`"));
    column = words.back();
    words.pop_back();
    probe = join(words, " ");
  }

  bool Quantity::is_temperature() const
  {
    return column.size() > 2 && column.compare(column.size() - 2, 2, "_K") == 0;
  }

  std::string Quantity::unit() const
  {
    const std::string last = column.substr(column.rfind('_') + 1);
    for (const char *known : {"K", "m", "m2", "m3", "Pa", "N", "J", "s"})
      if (last == known)
        return " " + last;
    return "";
  }

  Series Quantity::read(const std::string &directory) const
  {
    return probe.empty() ? read_summary(directory + "/summary.json") : read_probe(directory + "/probes.csv");
  }

  Series Quantity::read_summary(const std::string &file_name) const
  {
    std::ifstream file(file_name);
    const auto    summary  = nlohmann::json::parse(file);
    const auto    pointer  = nlohmann::json::json_pointer(column);
    const bool    is_there = summary.contains(pointer) && summary.at(pointer).is_number();
    return is_there ? Series{{summary.at("end_time_s").get<double>()}, {summary.at(pointer).get<double>()}} :
                      Series();
  }

  Series Quantity::read_probe(const std::string &file_name) const
  {
    using Fields = boost::tokenizer<boost::escaped_list_separator<char>>;
    std::ifstream file(file_name);
    std::string   line;
    std::getline(file, line);
    const Fields                   names(line);
    const std::vector<std::string> columns(names.begin(), names.end());
    const auto                     found = std::find(columns.begin(), columns.end(), column);
    Series                         series;
    if (found == columns.end())
      return series;
    while (std::getline(file, line))
      {
        const Fields                   values(line);
        const std::vector<std::string> row(values.begin(), values.end());
        const double                   at = std::stod(row[0]);
        if (row[1] == probe && (!time || std::abs(at - *time) <= 1e-9 * std::abs(*time)))
          {
            series.times.push_back(at);
            series.values.push_back(std::stod(row[found - columns.begin()]));
          }
      }
    return series;
  }

  std::vector<Quantity> quantities_of(const Scene &scene)
  {
    constexpr unsigned int   most_probes = 3;
    std::vector<std::string> texts       = scene.accuracy.quantities;
    if (texts.empty())
      {
        if (scene.effects.has_heat())
          {
            for (unsigned int i = 0; i < scene.output.probe_names.size() && i < most_probes; ++i)
              texts.push_back(scene.output.probe_names[i] + " temperature_K");
            texts.push_back("/extremes/temperature_max_K");
          }
        if (scene.effects.has_deformation())
          texts.push_back("/extremes/displacement_max_m");
        if (scene.effects.has_damage())
          {
            texts.push_back("/ablation/volume_m3");
            texts.push_back("/ablation/radius_m");
          }
      }
    std::vector<Quantity> quantities;
    for (const auto &text : texts)
      quantities.emplace_back(text);
    return quantities;
  }
} // namespace Cautery
