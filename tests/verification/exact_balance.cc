// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chain.h"

namespace Verification
{
  namespace
  {
    const std::vector<std::pair<std::string, std::vector<Override>>> models = {
      {"Fourier", {}},
      {"Fourier, lumped", {{"Numerics/Capacity matrix", "lumped"}}},
      {"Fourier, degree 2", {{"Numerics/Element degree", "2"}}},
      {"non-Fourier, consistent", {{"Effects/Heat", "non-Fourier"}}},
      {"non-Fourier, neglected",
       {{"Effects/Heat", "non-Fourier"}, {"Effects/Heat source jumps", "neglected"}}},
      {"two-way", {{"Effects/Deformation", "equilibrium"}, {"Effects/Coupling", "two-way"}}},
      {"two-way, non-Fourier",
       {{"Effects/Heat", "non-Fourier"},
        {"Effects/Deformation", "equilibrium"},
        {"Effects/Coupling", "two-way"}}},
      {"temperature-dependent",
       {{"Effects/Temperature-dependent properties", "on"},
        {"Effects/Metabolism", "Q10"},
        {"Tissues/tissue/Conductivity", "0.6 + 0.002*(T - 310)"},
        {"Tissues/tissue/Specific heat", "300: 3800, 312: 4200, 330: 4500"},
        {"Numerics/Iteration tolerance", "1e-12"}}},
      {"blood stops in dead tissue",
       {{"Effects/Damage", "Arrhenius"},
        {"Effects/Perfusion stops in dead tissue", "on"},
        {"Heat sources/needle/Power", "2"}}},
      {"blood stops in dead tissue, non-Fourier",
       {{"Effects/Heat", "non-Fourier"},
        {"Effects/Damage", "Arrhenius"},
        {"Effects/Perfusion stops in dead tissue", "on"},
        {"Effects/Temperature-dependent properties", "on"},
        {"Tissues/tissue/Conductivity", "0.6 + 0.002*(T - 310)"},
        {"Numerics/Iteration tolerance", "1e-12"},
        {"Heat sources/needle/Power", "2"}}},
      {"explicit, Fourier", {{"Time/Integrator", "explicit"}}},
      {"explicit, non-Fourier", {{"Time/Integrator", "explicit"}, {"Effects/Heat", "non-Fourier"}}},
      {"explicit, non-Fourier, neglected, Q10",
       {{"Time/Integrator", "explicit"},
        {"Effects/Heat", "non-Fourier"},
        {"Effects/Heat source jumps", "neglected"},
        {"Effects/Metabolism", "Q10"}}},
      {"blood stops in dead tissue, explicit",
       {{"Time/Integrator", "explicit"},
        {"Effects/Damage", "Arrhenius"},
        {"Effects/Perfusion stops in dead tissue", "on"},
        {"Heat sources/needle/Power", "2"}}},
      {"blood stops in dead tissue, explicit, non-Fourier",
       {{"Time/Integrator", "explicit"},
        {"Effects/Heat", "non-Fourier"},
        {"Effects/Damage", "Arrhenius"},
        {"Effects/Perfusion stops in dead tissue", "on"},
        {"Heat sources/needle/Power", "2"}}},
      {"explicit, with motion",
       {{"Time/Integrator", "explicit"},
        {"Effects/Deformation", "explicit dynamics"},
        {"Effects/Coupling", "expansion"},
        {"Effects/Conduction in", "deformed body"},
        {"Tissues/tissue/Young's modulus", "1000"}}},
    };

    /// Without any equation to solve the books close but for rounding.
    double tolerance(const std::string &label)
    {
      return label.find("explicit") == std::string::npos ? 1e-8 : 1e-11;
    }

    /// Closed, and closed with every account in use: an empty book closes too.
    void check_books(Checks &checks, const std::string &label, const Outcome &outcome)
    {
      checks.below(
        label + ": balance of heat, relative error", outcome.balance("relative_error"), tolerance(label));
      for (const std::string account :
           {"stored_J", "lost_to_blood_J", "lost_through_boundary_J", "metabolism_J"})
        checks.holds(label + ": " + account + " is in use", std::abs(outcome.balance(account)) > 1e-4);
      if (label.find("blood stops") == 0)
        checks.holds(label + ": tissue dies", outcome.summary.at("extremes").at("ln_damage_max") > 0.);
      if (label.find("two-way") == 0)
        checks.holds(label + ": expansion is in use",
                     std::abs(outcome.balance("consumed_by_expansion_J")) > 1e-4);
    }

    /// What was put in is known without the program: 0.08 W for 3.7 s, metabolism 33800 W/m3 in 1 cm3 for 8
    /// s.
    void check_known_accounts(Checks &checks)
    {
      const Outcome outcome = run("balance", {{"Heat sources/glow/Power", "0"}});
      checks.near("heat of the needle, J", outcome.balance("sources_J"), 0.08 * 3.7, 1e-9);
      checks.near("metabolic heat, J", outcome.balance("metabolism_J"), 33800. * 1e-6 * 8., 1e-9);
    }
  } // namespace

  void balance(Checks &checks)
  {
    for (const std::string cells : {"tetrahedra", "hexahedra"})
      for (const auto &[label, overrides] : models)
        {
          auto all = overrides;
          all.push_back({"Mesh/Cells", cells});
          check_books(checks, label + ", " + cells, run("balance", all));
        }
    check_known_accounts(checks);
  }
} // namespace Verification
