// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/output/space_errors.h>

#include <algorithm>

namespace Cautery
{
  template <int dim>
  GradientErrors gradient_errors(const Field<dim>     &nodes,
                                 const TissueMap<dim> &tissues,
                                 const Field<dim>     *displacement,
                                 const State          &state)
  {
    GradientErrors result;
    if (state.temperature.size() > 0)
      result["temperature"] = gradient_error(nodes, tissues, nodes, state.temperature);
    if (displacement != nullptr)
      result["displacement"] = gradient_error(nodes, tissues, *displacement, state.displacement);
    return result;
  }

  std::string error_column(const std::string &field)
  {
    return field + "_error_indicator" + (field == "temperature" ? "_K_per_m" : "");
  }

  void observe(const GradientErrors &now, SpaceErrors &errors)
  {
    for (const auto &[field, error] : now)
      {
        errors[field].last    = error.relative();
        errors[field].largest = std::max(errors[field].largest, error.relative());
      }
  }

  template GradientErrors
  gradient_errors(const Field<2> &, const TissueMap<2> &, const Field<2> *, const State &);
  template GradientErrors
  gradient_errors(const Field<3> &, const TissueMap<3> &, const Field<3> *, const State &);
} // namespace Cautery
