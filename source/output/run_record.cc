// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/files.h>
#include <cautery/base/version.h>
#include <cautery/output/run_record.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
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

    Json balance_json(const RunRecord &record)
    {
      const HeatTotals &balance = *record.balance;
      Json              json    = {{"sources_J", balance.sources},
                                   {"metabolism_J", balance.metabolism},
                                   {"stored_J", balance.stored},
                                   {"lost_to_blood_J", balance.blood},
                                   {"lost_through_boundary_J", balance.boundary},
                                   {"consumed_by_expansion_J", balance.expansion}};
      if (record.adaption)
        json["made_by_adaption_J"] = balance.adaption;
      json["error_J"]        = balance.error();
      json["relative_error"] = balance.relative_error();
      return json;
    }

    std::string unit(const std::string &balance) { return balance == "heat" ? "K" : "m"; }

    Json errors_json(const RunRecord &record)
    {
      Json json = Json::object();
      for (const auto &[name, error] : record.time_errors)
        json["time"][name] = {{"steps", error.steps},
                              {"largest_of_a_step_" + unit(name), error.largest},
                              {"sum_over_steps_" + unit(name), error.sum}};
      for (const auto &[name, error] : record.space_errors)
        json["space"][name + "_gradient"] = {{"relative", error.last}, {"largest_relative", error.largest}};
      if (record.balance)
        json["heat_balance"] = {{"relative", record.balance->relative_error()}};
      return json;
    }

    void write_errors(const RunRecord &record, std::ostream &out)
    {
      std::string label = "Errors         ";
      const auto  begin = [&]() -> std::ostream  &{
        out << label << std::setprecision(3);
        label = std::string(label.size(), ' ');
        return out;
      };
      for (const auto &[name, error] : record.time_errors)
        begin() << name << " in time: about " << error.largest << ' ' << unit(name) << " in the worst step, "
                << error.sum << ' ' << unit(name) << " summed over all\n";
      for (const auto &[name, error] : record.space_errors)
        begin() << name << " in space: about " << 100. * error.last << " % of its gradient\n";
      if (record.balance)
        begin() << "balance of heat: closed to " << record.balance->relative_error() << " of what moved\n";
      out << std::setprecision(6);
    }
  } // namespace

  namespace
  {
    /// Whose unknown that is.
    std::string effect_of_unknown(const std::string &name)
    {
      return name.rfind("temperature", 0) == 0 ? "heat" : "deformation";
    }

    /// The parts of an effect, dearest first; none where there is one only.
    std::vector<std::pair<double, std::string>> works(const RunRecord &record, const std::string &effect)
    {
      std::vector<std::pair<double, std::string>> found;
      for (const auto &[part, seconds] : record.seconds_by_part)
        if (const auto colon = part.find(": "); part.substr(0, colon) == effect)
          found.emplace_back(seconds, part.substr(colon + 2));
      std::sort(found.rbegin(), found.rend());
      if (found.size() == 1)
        found.clear();
      return found;
    }

    Json cost_json(const RunRecord &record)
    {
      Json json = {{"wall_s", record.wall_seconds},
                   {"processor_s", record.processor_seconds},
                   {"seconds_per_step", record.seconds_per_step},
                   {"seconds_by_part", record.seconds_by_part},
                   {"seconds_by_effect", record.seconds_by_effect},
                   {"peak_memory_bytes", record.peak_memory},
                   {"processes", record.processes}};
      for (const auto &share : record.ledger())
        json["ledger"][share.effect] = {{"seconds", share.seconds},
                                        {"share", share.share},
                                        {"bytes", share.bytes},
                                        {"unknowns", share.unknowns}};
      return json;
    }

    /// The ledger, and under each effect its parts where there are several.
    std::string cost_text(const RunRecord &record)
    {
      std::ostringstream out;
      out << "Cost                    seconds  share  memory MB  unknowns\n";
      for (const auto &share : record.ledger())
        {
          char line[120];
          std::snprintf(line,
                        sizeof(line),
                        "  %-20s %9.3f %5.1f%% %10.1f %9llu\n",
                        share.effect.c_str(),
                        share.seconds,
                        100. * share.share,
                        1e-6 * share.bytes,
                        static_cast<unsigned long long>(share.unknowns));
          out << line;
          for (const auto &[seconds, work] : works(record, share.effect))
            {
              std::snprintf(line, sizeof(line), "    %-26s %7.3f\n", work.c_str(), seconds);
              out << line;
            }
        }
      return out.str();
    }

    Json forecast_json(const RunRecord &record)
    {
      Json json = {{"after_steps", record.forecast->after_steps},
                   {"wall_s", record.forecast->seconds},
                   {"peak_memory_bytes", record.forecast->bytes}};
      if (record.status == "done") // else it was foretold of more than has been
        {
          json["wall_over_actual"]   = record.forecast->seconds / record.wall_seconds;
          json["memory_over_actual"] = record.forecast->bytes / record.peak_memory;
        }
      return json;
    }
  } // namespace

  std::vector<RunRecord::Share> RunRecord::ledger() const
  {
    std::map<std::string, Share> shares;
    double                       rest = wall_seconds;
    for (const auto &[effect, seconds] : seconds_by_effect)
      {
        shares[effect].seconds = seconds;
        rest -= seconds;
      }
    for (const auto &[effect, bytes] : bytes_by_effect)
      shares[effect].bytes = bytes;
    for (const auto &[name, number] : unknowns)
      shares[effect_of_unknown(name)].unknowns += number;

    std::vector<Share> sorted;
    for (auto &[effect, share] : shares)
      {
        share.effect = effect;
        sorted.push_back(share);
      }
    std::sort(
      sorted.begin(), sorted.end(), [](const Share &a, const Share &b) { return a.seconds > b.seconds; });
    sorted.push_back({"rest", rest, 0., 0., 0});
    for (auto &share : sorted)
      share.share = share.seconds / wall_seconds;
    return sorted;
  }

  void RunRecord::write(const std::string &file_name) const
  {
    Json json;
    json["title"]      = title;
    json["version"]    = version;
    json["status"]     = status;
    json["message"]    = message;
    json["end_time_s"] = end_time;
    if (resumed_from)
      json["resumed_from_s"] = *resumed_from;
    json["effects"]    = {{"on", effects.on()}, {"off", effects.off()}};
    json["unknowns"]   = unknowns;
    json["time_steps"] = time_steps;
    json["statistics"] = statistics;
    json["extremes"]   = extremes_json(*this);
    if (ablation)
      json["ablation"] = ablation_json(*ablation);
    if (adaption)
      json["adaption"] = {{"times", adaption->times},
                          {"largest_number_of_cells", adaption->most_cells},
                          {"last_number_of_cells", adaption->last_cells}};
    if (balance)
      json["balance"] = balance_json(*this);
    json["errors"] = errors_json(*this);
    json["cost"]   = cost_json(*this);
    if (forecast)
      json["forecast"] = forecast_json(*this);

    // names in a mesh or a scene may be of another encoding than UTF-8: no reason to lose a run's summary
    replace_file(file_name, json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
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
        out << "Heat           " << balance->sources << " J put in" << depth << '\n';
        if (balance->relative_error() > open_books)
          out << "               WARNING: heat is lost or made. Does a power, flux or temperature jump by "
                 "itself? Then take `Switch on at`, smaller steps or tolerances.\n";
      }
    if (adaption)
      out << "Mesh           adapted to the first step and " << adaption->times << " times later, "
          << adaption->most_cells << " cells at most, " << adaption->last_cells << " at the end\n";
    write_errors(*this, out);
    out << std::setprecision(3) << "Time           " << wall_seconds << " s for " << steps_here
        << " steps on " << processes << (processes == 1 ? " process" : " processes") << ", "
        << std::setprecision(0) << std::fixed << 1e-6 * peak_memory << " MB at most\n"
        << std::defaultfloat << std::setprecision(3);
    return out.str() + cost_text(*this);
  }
} // namespace Cautery
