// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/version.h>
#include <cautery/output/run_record.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace Cautery
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /// Relative error of the books of heat beyond which a run is not to be trusted.
    constexpr double open_books = 0.02;

    Json extremes_json(const RunRecord &record)
    {
      Json json;
      if (record.effects.has_heat())
        {
          json["temperature_max_K"] = record.extremes.temperature_max;
          json["temperature_min_K"] = record.extremes.temperature_min;
        }
      if (record.effects.has_deformation())
        json["displacement_max_m"] = record.extremes.displacement_max;
      if (record.effects.has_damage())
        {
          json["damage_max"] =
            std::exp(record.extremes.ln_damage_max); // null where it overflows: see the logarithm
          json["ln_damage_max"] = record.extremes.ln_damage_max;
        }
      return json;
    }

    Json ablation_json(const RunRecord::Ablation &ablation)
    {
      Json json;
      json["volume_m3"] = ablation.volume;
      json["radius_m"]  = ablation.radius;
      json["centre_m"]  = {ablation.centre[0], ablation.centre[1], ablation.centre[2]};
      for (const auto &[id, region] : ablation.regions)
        json["regions"][id] = {
          {"name", region.name}, {"volume_m3", region.volume}, {"fraction", region.fraction}};
      return json;
    }

    Json balance_json(const HeatTotals &balance)
    {
      return {{"sources_J", balance.sources},
              {"metabolism_J", balance.metabolism},
              {"stored_J", balance.stored},
              {"lost_to_blood_J", balance.blood},
              {"lost_through_boundary_J", balance.boundary},
              {"consumed_by_expansion_J", balance.expansion},
              {"error_J", balance.error()},
              {"relative_error", balance.relative_error()}};
    }
  } // namespace

  void RunRecord::write(const std::string &file_name) const
  {
    Json json;
    json["title"]      = title;
    json["version"]    = version;
    json["status"]     = status;
    json["message"]    = message;
    json["end_time_s"] = end_time;
    json["effects"]    = {{"on", effects.on()}, {"off", effects.off()}};
    json["unknowns"]   = unknowns;
    json["time_steps"] = time_steps;
    json["statistics"] = statistics;
    json["extremes"]   = extremes_json(*this);
    if (ablation)
      json["ablation"] = ablation_json(*ablation);
    if (balance)
      json["balance"] = balance_json(*balance);
    json["cost"] = {{"wall_s", wall_seconds},
                    {"seconds_per_step", seconds_per_step},
                    {"seconds_by_part", seconds_by_part},
                    {"seconds_by_effect", seconds_by_effect},
                    {"peak_memory_bytes", peak_memory},
                    {"processes", processes}};

    const std::string part = file_name + ".part";
    {
      std::ofstream file(part);
      file << json.dump(2) << '\n';
      AssertThrow(file, ExcRun("cannot write " + file_name + ": is the disk full?"));
    }
    std::filesystem::rename(part, file_name);
  }

  std::string RunRecord::text() const
  {
    const std::string  depth = dimension == 2 ? " per metre of depth" : "";
    std::ostringstream out;
    out << std::setprecision(6);
    if (effects.has_heat())
      out << "Temperature    " << extremes.temperature_min << " to " << extremes.temperature_max << " K\n";
    if (effects.has_deformation())
      out << "Displacement   up to " << 1e3 * extremes.displacement_max << " mm\n";
    if (ablation)
      {
        out << "Dead tissue    " << 1e6 * ablation->volume << " cm3" << depth << ", up to "
            << 1e3 * ablation->radius << " mm from the centre\n";
        for (const auto &[id, region] : ablation->regions)
          out << "               " << (region.name.empty() ? "region " + id : region.name) << ": "
              << 1e6 * region.volume << " cm3, " << std::setprecision(3) << 100. * region.fraction << " %\n"
              << std::setprecision(6);
      }
    if (balance)
      {
        out << "Heat           " << balance->sources << " J put in" << depth << ", balance closed to "
            << std::setprecision(2) << balance->relative_error() << " of what moved\n";
        if (balance->relative_error() > open_books)
          out << "               WARNING: heat is lost or made. Does a power, flux or temperature jump by "
                 "itself? Then take `Switch on at`, smaller steps or tolerances.\n";
      }
    out << std::setprecision(3) << "Time           " << wall_seconds << " s for " << time_steps
        << " steps on " << processes << (processes == 1 ? " process" : " processes") << ", "
        << std::setprecision(0) << std::fixed << 1e-6 * peak_memory << " MB at most\n"
        << std::defaultfloat << std::setprecision(3);
    std::vector<std::pair<double, std::string>> parts;
    for (const auto &[part, seconds] : seconds_by_part)
      parts.emplace_back(seconds, part);
    std::sort(parts.rbegin(), parts.rend());
    for (const auto &[seconds, part] : parts)
      out << "               " << std::setw(10) << seconds << " s  " << part << '\n';
    return out.str();
  }
} // namespace Cautery
