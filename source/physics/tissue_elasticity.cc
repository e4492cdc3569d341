// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/tissue_elasticity.h>

namespace Cautery
{
  TissueElasticity::TissueElasticity(const Tissue &tissue, const bool expands)
    : tissue(tissue), expands(expands)
  {
    AssertThrow(
      tissue.fibres.empty() || !is_linear(),
      ExcInput("Tissues/" + tissue.name +
               "/Elastic law = linear has no fibres; take out Fibre families, or choose neo-Hookean"));
    law(reference_temperature()).check();
  }

  bool TissueElasticity::is_linear() const { return tissue.elastic_law == Tissue::ElasticLawChoice::linear; }

  ElasticLaw TissueElasticity::law(const double temperature) const
  {
    const Lame lame = tissue.elastic.lame(temperature);
    ElasticLaw result;
    if (is_linear())
      result.ground = SmallStrain{lame.lambda, lame.mu};
    else
      result.ground = NeoHookean{lame.lambda, lame.mu};
    for (const FibreFamily &family : tissue.fibres)
      result.fibres.push_back(family.law);
    if (expands)
      result.stretch =
        tissue.expansion.form == ThermalExpansion::Form::exact ? StretchForm::exact : StretchForm::linearised;
    return result;
  }

  ElasticLaw::Directions TissueElasticity::directions(const Point<3> &place) const
  {
    ElasticLaw::Directions result;
    for (const FibreFamily &family : tissue.fibres)
      result.push_back(family.unit_direction(place));
    return result;
  }
} // namespace Cautery
