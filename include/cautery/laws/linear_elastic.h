// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Cautery
{
  /**
   * Lamé's parameters and what follows from them (thesis Eq. 4-13), in Pa.
   */
  struct Lame
  {
    double lambda = 0.;
    double mu     = 0.;

    double bulk_modulus() const { return lambda + 2. * mu / 3.; }

    /** lambda tr(eps) I + 2 mu eps; in two dimensions plane strain. */
    template <int dim, typename Number>
    SymmetricTensor<2, dim, Number> stress(const SymmetricTensor<2, dim, Number> &strain) const
    {
      SymmetricTensor<2, dim, Number> result = 2. * mu * strain;
      const Number                    volume = lambda * trace(strain);
      for (unsigned int d = 0; d < dim; ++d)
        result[d][d] += volume;
      return result;
    }
  };

  /**
   * Isotropic linear elasticity with Young's modulus that may depend on temperature.
   */
  struct LinearElastic
  {
    TemperatureFunction youngs_modulus = 10.2e6; ///< Pa
    double              poissons_ratio = 0.35;

    Lame lame(const double temperature) const
    {
      const double young = youngs_modulus.value(temperature);
      return {poissons_ratio * young / ((1. + poissons_ratio) * (1. - 2. * poissons_ratio)),
              young / (2. * (1. + poissons_ratio))};
    }

    void parameters(Parameters &p)
    {
      p.entry("Young's modulus",
              youngs_modulus,
              "Pa",
              "Young's modulus: a number, a table `T: E, T: E, ...` or an expression in T",
              Bounds::positive());
      p.entry("Poisson's ratio", poissons_ratio, "", "Poisson's ratio", Bounds::between_open(-1., 0.5));
    }
  };
} // namespace Cautery
