// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/elastic_law.h>
#include <cautery/scene/tissue.h>

namespace Cautery
{
  /**
   * A tissue's elasticity in large deformation as the points of a body ask for it.
   */
  class TissueElasticity
  {
  public:
    /** @p expands: heat stretches the tissue. Errors: ExcInput for laws that do not fit. */
    TissueElasticity(const Tissue &tissue, const bool expands);

    /** Linear elasticity, for comparison: its strain is the small one. */
    bool is_linear() const;

    /** At @p temperature (K), on which Young's modulus may depend. */
    ElasticLaw law(const double temperature) const;

    /** The unit vectors of the fibres at @p place (m) of the undeformed body. */
    ElasticLaw::Directions directions(const Point<3> &place) const;

    /** int alpha dT up to @p temperature (K). */
    double thermal_strain(const double temperature) const { return tissue.expansion.strain(temperature); }
    double reference_temperature() const { return tissue.expansion.reference_temperature; }

  private:
    const Tissue &tissue;
    const bool    expands;
  };

  /** H with rows and columns of zeros in the third direction where @p dim is 2: plane strain. */
  template <int dim>
  Matrix3<double> in_space(const Tensor<2, dim> &gradient)
  {
    Matrix3<double> result = {};
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        result(i, j) = gradient[i][j];
    return result;
  }
} // namespace Cautery
