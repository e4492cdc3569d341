// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/blood.h>
#include <cautery/laws/damage.h>
#include <cautery/laws/fibre_family.h>
#include <cautery/laws/linear_elastic.h>
#include <cautery/laws/thermal_expansion.h>
#include <cautery/laws/tissue_properties.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * All laws of the tissue in some regions of the mesh: a subsection of "Tissues".
   */
  struct Tissue
  {
    enum class ElasticLawChoice
    {
      linear,
      neo_hookean
    };
    std::string              name;
    ElasticLawChoice         elastic_law = ElasticLawChoice::neo_hookean;
    std::vector<std::string> fibre_names;
    std::vector<FibreFamily> fibres;
    std::vector<std::string> regions = {"all"}; ///< physical groups, by number or name
    ThermalProperties        thermal;
    Perfusion                perfusion;
    Metabolism               metabolism;
    LinearElastic            elastic;
    ThermalExpansion         expansion;
    Arrhenius                arrhenius;
    Cem43                    cem43;
    CriticalThermalLoad      critical_thermal_load;

    /** Does any property change with temperature? */
    bool thermally_constant() const { return thermal.constant(); }
    bool elastically_constant() const { return elastic.youngs_modulus.is_constant() && expansion.linear(); }

    void parameters(Parameters &p);
  };

  /** The names of the ready tissues. */
  std::vector<std::string> tissue_presets();

  /** A tissue with the preset's values; ExcInput for an unknown name. */
  Tissue make_tissue(const std::string &preset);
} // namespace Cautery
