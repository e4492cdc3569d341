// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/study/effect_study.h>
#include <cautery/study/study_progress.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace Cautery
{
  namespace
  {
    /// An effect is called for where without it an answer changes by more than this: kelvin, or a share.
    constexpr double noticeable_temperature = 0.1;
    constexpr double noticeable_share       = 0.01;

    using Changes = std::vector<Override>;

    const Override no_stop        = {"Effects/Perfusion stops in dead tissue", "off"};
    const Override no_coupling    = {"Effects/Coupling", "off"};
    const Override plain_damage   = {"Effects/Damage", "Arrhenius"};
    const Override reference_body = {"Effects/Conduction in", "reference body"};

    /// What cannot stay without deformation.
    Changes without_deformation(const Effects &effects)
    {
      Changes changes = {{"Effects/Deformation", "off"},
                         no_coupling,
                         {"Effects/Gravity", "off"},
                         {"Output/Reactions", "off"},
                         reference_body};
      if (effects.damage_needs_strain_energy())
        changes.push_back(plain_damage);
      return changes;
    }

    /// Constants, of body temperature, instead of what depends on temperature.
    Changes constant_properties(const Scene &scene)
    {
      Changes      changes = {{"Effects/Temperature-dependent properties", "off"}};
      const double start   = scene.initial_temperature.value(Point<3>(), 0.);
      for (const auto &tissue : scene.tissues)
        for (const auto &[name, property] :
             {std::make_pair("Conductivity", &tissue.thermal.conductivity),
              std::make_pair("Specific heat", &tissue.thermal.specific_heat),
              std::make_pair("Young's modulus", &tissue.elastic.youngs_modulus),
              std::make_pair("Thermal expansion coefficient", &tissue.expansion.coefficient)})
          if (!property->is_constant())
            changes.push_back({"Tissues/" + tissue.name + "/" + name, to_text(property->value(start))});
      return changes;
    }

    void add_heat(const Effects &effects, std::vector<Variant> &variants)
    {
      if (effects.heat == Effects::Heat::non_fourier)
        variants.push_back({"lag of the flux (Fourier instead)", {{"Effects/Heat", "Fourier"}}});
      if (effects.heat_sources)
        variants.push_back({"heat sources", {{"Effects/Heat sources", "off"}}});
      if (effects.perfusion)
        variants.push_back({"perfusion", {no_stop, {"Effects/Perfusion", "off"}}});
      if (effects.perfusion_stops_in_dead_tissue)
        variants.push_back({"end of perfusion in dead tissue", {no_stop}});
      if (effects.metabolism != Effects::Metabolism::off)
        variants.push_back({"metabolism", {{"Effects/Metabolism", "off"}}});
      if (effects.conduction == Effects::Conduction::deformed_body)
        variants.push_back({"conduction in the deformed body", {reference_body}});
    }

    void add_deformation(const Effects &effects, std::vector<Variant> &variants)
    {
      if (effects.has_heat())
        variants.push_back({"deformation", without_deformation(effects)});
      if (effects.deformation == Effects::Deformation::inertia)
        variants.push_back({"inertia", {{"Effects/Deformation", "equilibrium"}}});
      // with the capacity of explicit heat, so that nothing else changes
      const auto at_rest = [](const std::string &deformation) {
        return Changes{{"Effects/Deformation", deformation},
                       reference_body,
                       {"Time/Integrator", "backward Euler"},
                       {"Numerics/Capacity matrix", "lumped"}};
      };
      if (effects.deformation == Effects::Deformation::explicit_dynamics)
        variants.push_back({"inertia (large equilibrium instead)", at_rest("large equilibrium")});
      if (effects.has_large_deformation())
        variants.push_back({"large deformation (small instead)",
                            effects.deformation == Effects::Deformation::explicit_dynamics ?
                              at_rest("equilibrium") :
                              Changes{{"Effects/Deformation", "equilibrium"}}});
      if (effects.coupling == Effects::Coupling::two_way)
        variants.push_back({"cooling by expansion", {{"Effects/Coupling", "expansion"}}});
      if (effects.coupling != Effects::Coupling::off)
        variants.push_back({"thermal expansion", {no_coupling}});
      if (effects.gravity)
        variants.push_back({"gravity", {{"Effects/Gravity", "off"}}});
    }

    /// The answers that are compared: the scene's own, and always these where the scene has them.
    std::vector<Quantity> compared_quantities(const Scene &scene)
    {
      Scene extremes               = scene;
      extremes.output.probe_names  = {};
      extremes.accuracy.quantities = {};
      auto quantities              = quantities_of(extremes);
      for (const auto &text : scene.accuracy.quantities)
        quantities.emplace_back(text);
      return quantities;
    }

    bool is_noticeable(const Quantity &quantity, const Series &with, const Series &without)
    {
      const double change = without.distance(with);
      return change > (quantity.is_temperature() ? noticeable_temperature : noticeable_share * with.size());
    }

    /// "+1.2 K", "-30 %", or "gone".
    std::string change_text(const Quantity &quantity, const Series &with, const Series &without)
    {
      std::ostringstream text;
      if (without.values.empty())
        return "gone";
      const double change = without.values.back() - with.values.back();
      text << std::showpos << std::setprecision(3);
      if (quantity.is_temperature())
        text << change << " K";
      else if (with.values.back() != 0.)
        text << 100. * change / std::abs(with.values.back()) << " %";
      else
        text << change;
      return text.str();
    }

    struct Row
    {
      Variant variant;
      Outcome outcome;
    };

    bool is_called_for(const std::vector<Quantity> &quantities, const Outcome &with, const Outcome &without)
    {
      for (unsigned int q = 0; q < quantities.size(); ++q)
        // an answer that is gone with its effect says nothing about the others
        if (!without.answers[q].values.empty() &&
            is_noticeable(quantities[q], with.answers[q], without.answers[q]))
          return true;
      return false;
    }

    std::string
    table(const std::vector<Quantity> &quantities, const Outcome &with, const std::vector<Row> &rows)
    {
      std::ostringstream out;
      out << "| left out |";
      for (const auto &quantity : quantities)
        out << ' ' << quantity.text() << " |";
      out << " seconds | saved | MB saved | called for |\n|---|";
      for (unsigned int q = 0; q < quantities.size() + 4; ++q)
        out << "---|";
      out << "\n| nothing |" << std::setprecision(6);
      for (const auto &answer : with.answers)
        out << ' ' << answer.values.back() << " |";
      out << ' ' << std::setprecision(3) << with.seconds << " | | | |\n";
      for (const auto &[variant, outcome] : rows)
        {
          out << "| " << variant.label << " |";
          if (!outcome.succeeded())
            {
              out << " failed: " << outcome.message << " |\n";
              continue;
            }
          for (unsigned int q = 0; q < quantities.size(); ++q)
            out << ' ' << change_text(quantities[q], with.answers[q], outcome.answers[q]) << " |";
          out << ' ' << outcome.seconds << " | " << std::round(100. * (1. - outcome.seconds / with.seconds))
              << " % | " << std::round(1e-6 * (with.bytes - outcome.bytes)) + 0. << " | "
              << (is_called_for(quantities, with, outcome) ? "yes" : "no") << " |\n";
        }
      return out.str();
    }

    void write_csv(const std::vector<Quantity> &quantities,
                   const Outcome               &with,
                   const std::vector<Row>      &rows,
                   std::ostream                &out)
    {
      out << "left_out,quantity,with,without,seconds_with,seconds_without,peak_memory_bytes_with,"
             "peak_memory_bytes_without\n"
          << std::setprecision(12);
      for (const auto &[variant, outcome] : rows)
        for (unsigned int q = 0; outcome.succeeded() && q < quantities.size(); ++q)
          if (!outcome.answers[q].values.empty())
            out << std::quoted(variant.label, '"', '"') << ',' << std::quoted(quantities[q].text(), '"', '"')
                << ',' << with.answers[q].values.back() << ',' << outcome.answers[q].values.back() << ','
                << with.seconds << ',' << outcome.seconds << ',' << with.bytes << ',' << outcome.bytes
                << '\n';
    }

    void report(const std::vector<Quantity> &quantities,
                const Outcome               &with,
                const std::vector<Row>      &rows,
                const Scene                 &scene,
                const std::string           &directory)
    {
      std::ofstream csv(directory + "/effects.csv");
      write_csv(quantities, with, rows, csv);
      const std::string text = table(quantities, with, rows);
      std::ofstream     markdown(directory + "/effects.md");
      markdown << "# What each effect changes and costs" << (scene.title.empty() ? "" : ": " + scene.title)
               << "\n\nThe scene with one effect left out at a time: how its answers change, what time it "
                  "saves. Called "
                  "for is what changes a temperature by more than "
               << noticeable_temperature << " K, or another answer by more than " << 100. * noticeable_share
               << " %.\n\n"
               << text;
      csv.flush();
      markdown.flush();
      AssertThrow(csv && markdown, ExcRun("cannot write into " + directory + ": is the disk full?"));
      std::cout << '\n' << text << "Results        " << directory << "/effects.md\n";
    }
  } // namespace

  std::vector<Variant> without_effects(const Scene &scene)
  {
    const Effects       &effects = scene.effects;
    std::vector<Variant> variants;
    if (effects.has_heat())
      add_heat(effects, variants);
    if (effects.has_deformation())
      add_deformation(effects, variants);
    if (effects.temperature_dependent_properties)
      variants.push_back({"change of properties with temperature", constant_properties(scene)});
    if (effects.damage_needs_strain_energy())
      variants.push_back({"strain energy in the damage", {plain_damage}});
    if (effects.has_damage())
      variants.push_back({"damage", {{"Effects/Damage", "off"}, no_stop}});
    return variants;
  }

  void study_effects(const Origin      &origin,
                     const Scene       &scene,
                     const std::string &directory,
                     const MPI_Comm     communicator)
  {
    const auto    quantities = compared_quantities(scene);
    const auto    variants   = without_effects(scene);
    const bool    speaks     = Utilities::MPI::this_mpi_process(communicator) == 0;
    Runner        runner(origin, quantities, scene.accuracy.repeats, directory + "/runs", communicator);
    StudyProgress progress(variants.size() + 1, speaks);

    const Outcome with = runner.run("scene", {});
    progress.say("the scene as it is", with);
    AssertThrow(with.succeeded(), ExcRun("the scene as it is fails: " + with.message));
    require_answers(quantities, with, directory);
    std::vector<Row> rows;
    for (unsigned int i = 0; i < variants.size(); ++i)
      {
        rows.push_back({variants[i], Outcome()});
        try
          {
            rows.back().outcome = runner.run("without_" + std::to_string(i), variants[i].changes);
          }
        catch (const ExcInput &exception)
          {
            rows.back().outcome.message = "the scene needs it: " + message_of(exception);
          }
        progress.say("without " + variants[i].label, rows.back().outcome);
      }
    if (speaks)
      report(quantities, with, rows, scene, directory);
  }
} // namespace Cautery
