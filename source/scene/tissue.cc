// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/tissue.h>

#include <algorithm>
#include <functional>

namespace Cautery
{
  namespace
  {
    struct Preset
    {
      std::string                   name;
      std::function<void(Tissue &)> apply;
    };

    /// The members' defaults are the first preset.
    const std::vector<Preset> presets = {{"thesis type I", [](Tissue &) {}}, // Tables 2 and 3
                                         {"thesis type II",                  // Table 3
                                          [](Tissue &tissue) {
                                            tissue.elastic.youngs_modulus = 120e6;
                                            tissue.elastic.poissons_ratio = 0.49;
                                          }},
                                         {"porcine liver", // Table 9
                                          [](Tissue &tissue) {
                                            tissue.thermal.conductivity            = 0.465;
                                            tissue.thermal.specific_heat           = 3628.;
                                            tissue.thermal.density                 = 1050.;
                                            tissue.thermal.relaxation_time         = 12.;
                                            tissue.perfusion.rate                  = 0.; // ex vivo
                                            tissue.expansion.reference_temperature = 293.;
                                          }}};
  } // namespace

  std::vector<std::string> tissue_presets()
  {
    std::vector<std::string> names;
    for (const auto &preset : presets)
      names.push_back(preset.name);
    return names;
  }

  Tissue make_tissue(const std::string &name)
  {
    const auto preset =
      std::find_if(presets.begin(), presets.end(), [&name](const Preset &p) { return p.name == name; });
    AssertThrow(
      preset != presets.end(),
      ExcInput("there is no tissue preset `" + name + "`; choose one of: " + join(tissue_presets())));
    Tissue tissue;
    preset->apply(tissue);
    return tissue;
  }

  void Tissue::parameters(Parameters &p)
  {
    p.entry(
      "Regions", regions, "Regions of the mesh, by number or name, that consist of it; `all` for every one");
    thermal.parameters(p);
    perfusion.parameters(p);
    metabolism.parameters(p);
    elastic.parameters(p);
    p.entry("Elastic law",
            elastic_law,
            Choices<ElasticLawChoice>{{"linear", ElasticLawChoice::linear},
                                      {"neo-Hookean", ElasticLawChoice::neo_hookean}},
            "Law");
    p.entry("Fibre families", fibre_names, "Names");
    for (unsigned int f = 0; f < fibres.size(); ++f)
      p.section(fibre_names[f], [&]() { fibres[f].parameters(p); });
    expansion.parameters(p);
    p.section("Arrhenius damage", [&]() { arrhenius.parameters(p); });
    p.section("CEM43 damage", [&]() { cem43.parameters(p); });
    p.section("Critical thermal load", [&]() { critical_thermal_load.parameters(p); });
  }
} // namespace Cautery
