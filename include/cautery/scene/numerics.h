// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>
#include <cautery/scene/explicit_settings.h>
#include <cautery/scene/newton_settings.h>
#include <cautery/scene/relaxation_settings.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * How linear systems are solved. All matrices are symmetric and positive definite.
   */
  struct LinearSolverSettings
  {
    enum class Method
    {
      automatic,
      direct,
      cg_ssor,
      cg_amg,
      gauss_seidel
    };

    Method method    = Method::automatic;
    double tolerance = 1e-10; ///< on the residual's norm, relative to the largest right-hand side so far
    unsigned int max_iterations = 2000;
    unsigned int guesses =
      16; ///< earlier solutions that the initial guess is combined from; 0: start from zero

    void parameters(Parameters &p);
  };

  /**
   * Space discretisation and solvers: section "Numerics".
   */
  struct Numerics
  {
    enum class Method
    {
      finite_elements,
      finite_differences ///< thesis 4.3
    };
    enum class CapacityMatrix
    {
      consistent,
      lumped
    };
    enum class LargeEquilibrium
    {
      newton,
      relaxation
    };
    enum class DisplacementAt
    {
      automatic,
      every_step,
      output_times
    };

    Method                   method              = Method::finite_elements;
    unsigned int             degree              = 1;
    CapacityMatrix           capacity_matrix     = CapacityMatrix::consistent;
    bool                     temperature_limiter = false;
    bool                     mean_dilatation     = false;
    DisplacementAt           displacement_at     = DisplacementAt::automatic;
    double                   iteration_tolerance = 1e-8; ///< of the nonlinear iteration in a step, K
    unsigned int             max_iterations      = 50;
    std::vector<std::string> kept_nodes; ///< "inside", "probes" or regions; empty: all, nothing is condensed
    LinearSolverSettings     heat_solver;
    LinearSolverSettings     deformation_solver;
    LargeEquilibrium         large_equilibrium = LargeEquilibrium::newton;
    NewtonSettings           newton;
    RelaxationSettings       relaxation;
    ExplicitSettings         explicit_steps;

    void parameters(Parameters &p);
  };

  /**
   * The course of time: section "Time".
   */
  struct TimeSettings
  {
    enum class Integrator
    {
      backward_euler,
      ida,
      explicit_steps ///< of its own stable length within each step
    };

    double       end                = 120.; ///< s
    double       step               = 1.;   ///< s
    Integrator   integrator         = Integrator::backward_euler;
    double       relative_tolerance = 1e-5; ///< IDA
    double       absolute_tolerance = 1e-4; ///< IDA, K
    unsigned int max_steps          = 1000000;

    void parameters(Parameters &p);
  };
} // namespace Cautery
