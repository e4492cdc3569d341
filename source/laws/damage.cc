// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/laws/damage.h>

namespace Cautery
{
  namespace
  {
    struct Preset
    {
      std::string name;
      double      frequency_factor;  // 1/s
      double      activation_energy; // J/mol
    };

    /// Thesis Table 1 (page 14) and Table 4.
    const std::vector<Preset> presets = {{"thesis", 1.98e106, 667000.},
                                         {"retina", 1.0e44, 2.9e5},
                                         {"skin", 3.1e98, 6.3e5},
                                         {"liver", 1.0e70, 4.0e5}};
  } // namespace

  void Arrhenius::parameters(Parameters &p)
  {
    Choices<unsigned int> names = {{"none", numbers::invalid_unsigned_int}};
    for (unsigned int i = 0; i < presets.size(); ++i)
      names.emplace_back(presets[i].name, i);

    unsigned int preset = numbers::invalid_unsigned_int;
    p.entry("Constants",
            preset,
            names,
            "Constants of the literature, in place of `Frequency factor` and `Activation energy`");
    p.entry("Frequency factor", frequency_factor, "1/s", "A", Bounds::positive());
    p.entry("Activation energy", activation_energy, "J/mol", "Delta E", Bounds::positive());
    p.entry("Molar volume",
            molar_volume,
            "m3/mol",
            "V_mol, which turns strain energy into energy per mole",
            Bounds::non_negative());
    if (p.reading() && preset != numbers::invalid_unsigned_int)
      {
        frequency_factor  = presets[preset].frequency_factor;
        activation_energy = presets[preset].activation_energy;
      }
  }
} // namespace Cautery
