// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/explicit_problem.h>
#include <cautery/problems/mechanical_problem.h>
#include <cautery/problems/thermal_problem.h>
#include <cautery/problems/thermomechanical_problem.h>

namespace Cautery
{
  namespace
  {
    std::unique_ptr<Problem<3>> make_explicit_problem(const Scene &scene, const Body<3> &body, Cost &cost)
    {
      if (scene.numerics.explicit_steps.precision == ExplicitSettings::Precision::single_precision)
        return std::make_unique<ExplicitProblem<float>>(scene, body, cost);
      return std::make_unique<ExplicitProblem<double>>(scene, body, cost);
    }
  } // namespace

  template <int dim>
  std::unique_ptr<Problem<dim>> make_problem(const Scene &scene, const Body<dim> &body, Cost &cost)
  {
    if constexpr (dim == 3)
      if (scene.has_explicit_loop())
        return make_explicit_problem(scene, body, cost);
    if (!scene.effects.has_deformation())
      return std::make_unique<ThermalProblem<dim>>(scene, body, cost);
    if (!scene.effects.has_heat())
      return std::make_unique<MechanicalProblem<dim>>(scene, body, cost);
    return std::make_unique<ThermomechanicalProblem<dim>>(scene, body, cost);
  }

  template std::unique_ptr<Problem<2>> make_problem(const Scene &, const Body<2> &, Cost &);
  template std::unique_ptr<Problem<3>> make_problem(const Scene &, const Body<3> &, Cost &);
} // namespace Cautery
