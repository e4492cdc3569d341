// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/effects.h>

namespace Cautery
{
  namespace
  {
    const Choices<Effects::Heat> heat_choices = {{"off", Effects::Heat::off},
                                                 {"Fourier", Effects::Heat::fourier},
                                                 {"non-Fourier", Effects::Heat::non_fourier}};

    const Choices<Effects::Jumps> jump_choices = {{"consistent", Effects::Jumps::consistent},
                                                  {"neglected", Effects::Jumps::neglected}};

    const Choices<Effects::Conduction> conduction_choices = {
      {"reference body", Effects::Conduction::reference_body},
      {"deformed body", Effects::Conduction::deformed_body}};

    const Choices<Effects::Metabolism> metabolism_choices = {{"off", Effects::Metabolism::off},
                                                             {"constant", Effects::Metabolism::constant},
                                                             {"Q10", Effects::Metabolism::q10}};

    const Choices<Effects::Deformation> deformation_choices = {
      {"off", Effects::Deformation::off},
      {"equilibrium", Effects::Deformation::equilibrium},
      {"inertia", Effects::Deformation::inertia},
      {"large equilibrium", Effects::Deformation::large_equilibrium},
      {"explicit dynamics", Effects::Deformation::explicit_dynamics}};

    const Choices<Effects::Coupling> coupling_choices = {{"off", Effects::Coupling::off},
                                                         {"expansion", Effects::Coupling::expansion},
                                                         {"two-way", Effects::Coupling::two_way}};

    const Choices<Effects::Damage> damage_choices = {
      {"off", Effects::Damage::off},
      {"critical thermal load", Effects::Damage::critical_thermal_load},
      {"Arrhenius", Effects::Damage::arrhenius},
      {"thermal strain energy", Effects::Damage::thermal_strain_energy},
      {"thermo-mechanical strain energy", Effects::Damage::thermo_mechanical_strain_energy},
      {"CEM43", Effects::Damage::cem43}};

    /// Every effect once: name, the chosen text (empty: off).
    using Listing = std::vector<std::pair<std::string, std::string>>;

    template <typename Enum>
    std::string chosen(const Enum value, const Choices<Enum> &choices)
    {
      for (const auto &choice : choices)
        if (choice.second == value)
          return choice.first == "off" ? "" : choice.first;
      return "";
    }

    std::string chosen(const bool on) { return on ? "on" : ""; }

    Listing list(const Effects &e)
    {
      return {{"heat", chosen(e.heat, heat_choices)},
              {"conduction in the deformed body",
               chosen(e.has_heat() && e.conduction == Effects::Conduction::deformed_body)},
              {"heat sources", chosen(e.has_heat() && e.heat_sources)},
              {"perfusion", chosen(e.perfusion)},
              {"perfusion stops in dead tissue", chosen(e.perfusion_stops_in_dead_tissue)},
              {"metabolism", chosen(e.metabolism, metabolism_choices)},
              {"deformation", chosen(e.deformation, deformation_choices)},
              {"coupling", chosen(e.coupling, coupling_choices)},
              {"gravity", chosen(e.gravity)},
              {"temperature-dependent properties", chosen(e.temperature_dependent_properties)},
              {"damage", chosen(e.damage, damage_choices)}};
    }

    void forbid(const bool contradiction, const std::string &message)
    {
      AssertThrow(!contradiction, ExcInput("Effects: " + message));
    }
  } // namespace

  void Effects::parameters(Parameters &p)
  {
    p.entry("Heat", heat, heat_choices, "Heat conduction: instantaneous flux, or a flux that lags behind");
    p.entry("Heat source jumps",
            source_jumps,
            jump_choices,
            "Non-Fourier: a switched source makes the rate of temperature jump, or this is neglected as in "
            "the thesis");
    p.entry("Conduction in",
            conduction,
            conduction_choices,
            "The body through whose length and section heat is conducted; deformed: with explicit heat and "
            "dynamics");
    p.entry("Heat sources", heat_sources, "The section `Heat sources` counts");
    p.entry("Perfusion", perfusion, "Blood carries heat away");
    p.entry("Perfusion stops in dead tissue",
            perfusion_stops_in_dead_tissue,
            "Perfusion ends where damage reaches 1");
    p.entry("Metabolism", metabolism, metabolism_choices, "Metabolic heat");
    p.entry(
      "Deformation",
      deformation,
      deformation_choices,
      "Small: linear elastic, in equilibrium or with inertia; large: with each tissue's elastic law, in "
      "equilibrium or by explicit dynamics");
    p.entry("Coupling",
            coupling,
            coupling_choices,
            "Heat expands the tissue; two-way: and volume change consumes heat");
    p.entry("Gravity", gravity, "Body force");
    p.entry("Temperature-dependent properties",
            temperature_dependent_properties,
            "Tables and expressions in T are allowed for the tissues' properties");
    p.entry("Damage", damage, damage_choices, "The law of thermal damage");
  }

  void Effects::check() const
  {
    forbid(!has_heat() && !has_deformation(),
           "neither Heat nor Deformation is on: there is nothing to simulate; turn one on");
    forbid(perfusion && !has_heat(), "Perfusion needs Heat; turn Perfusion off or Heat on");
    forbid(metabolism != Metabolism::off && !has_heat(),
           "Metabolism needs Heat; turn Metabolism off or Heat on");
    forbid(coupling != Coupling::off && (!has_heat() || !has_deformation()),
           "Coupling needs both Heat and Deformation; turn it off or turn them on");
    forbid(has_damage() && !has_heat(), "Damage needs Heat; turn Damage off or Heat on");
    forbid(damage_needs_strain_energy() && !has_deformation(),
           "this Damage law needs strain energy; turn Deformation on or choose Arrhenius");
    forbid(perfusion_stops_in_dead_tissue && (!has_damage() || !perfusion),
           "`Perfusion stops in dead tissue` needs Perfusion and Damage; turn it off or turn them on");
    forbid(gravity && !has_deformation(), "Gravity needs Deformation; turn Gravity off or Deformation on");
  }

  std::vector<std::string> Effects::on() const
  {
    std::vector<std::string> texts;
    for (const auto &[name, choice] : list(*this))
      if (!choice.empty())
        texts.push_back(choice == "on" ? name : name + ": " + choice);
    return texts;
  }

  std::vector<std::string> Effects::off() const
  {
    std::vector<std::string> texts;
    for (const auto &[name, choice] : list(*this))
      if (choice.empty())
        texts.push_back(name);
    return texts;
  }
} // namespace Cautery
