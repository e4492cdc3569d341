// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/balance_solver.h>
#include <cautery/time/coupled_backward_euler.h>

#include <deal.II/lac/solver_gmres.h>

namespace Cautery
{
  template <int dim>
  CoupledBackwardEuler<dim>::CoupledBackwardEuler(const TimeSettings                  &settings,
                                                  const Numerics                      &numerics,
                                                  Balance                             &heat_balance,
                                                  Balance                             &deformation_balance,
                                                  const ThermalExpansionOperator<dim> &expansion,
                                                  const ThermoelasticFeedback<dim>    &feedback,
                                                  Cost                                &cost)
    : settings(settings)
    , numerics(numerics)
    , heat(heat_balance, numerics, cost)
    , deformation(deformation_balance, numerics, cost)
    , expansion(expansion)
    , feedback(feedback)
    , cost(cost)
    , heat_solver(solver_of(heat_balance))
    , deformation_solver(solver_of(deformation_balance))
  {
  }

  namespace
  {
    /// The coupled matrix on free unknowns: prescribed rates are zero here.
    template <int dim>
    struct CoupledMatrix
    {
      BackwardEulerBalance                &heat;
      BackwardEulerBalance                &deformation;
      const SparseMatrix                  &cooling;
      const ThermalExpansionOperator<dim> &expansion;
      const double                         length;

      void vmult(BlockVector &result, const BlockVector &rates) const
      {
        Vector temperature = rates.block(0), displacement = rates.block(1);
        heat.balance().elimination().distribute(temperature);
        deformation.balance().elimination().distribute(displacement);

        Vector product = rates.block(0);
        cooling.vmult(product, displacement);
        heat.balance().elimination().condense(product);
        heat.system_matrix().vmult(result.block(0), rates.block(0));
        result.block(0) += product;

        product.reinit(rates.block(1));
        expansion.force_of_change(temperature, product);
        deformation.balance().elimination().condense(product);
        deformation.system_matrix().vmult(result.block(1), rates.block(1));
        result.block(1).add(-length, product);
      }
    };

    /// First the heat alone, then the deformation under the expansion that follows.
    template <int dim>
    struct OneAfterTheOther
    {
      LinearSolver                        &heat_solver;
      LinearSolver                        &deformation_solver;
      BackwardEulerBalance                &heat;
      BackwardEulerBalance                &deformation;
      const ThermalExpansionOperator<dim> &expansion;
      const double                         length;

      void vmult(BlockVector &rates, const BlockVector &residual) const
      {
        heat_solver.solve(rates.block(0), residual.block(0));
        Vector temperature = rates.block(0);
        heat.balance().elimination().distribute(temperature);
        Vector force = residual.block(1);
        expansion.force_of_change(temperature, force);
        deformation.balance().elimination().condense(force);
        force.sadd(length, 1., residual.block(1));
        deformation_solver.solve(rates.block(1), force);
      }
    };
  } // namespace

  template <int dim>
  void CoupledBackwardEuler<dim>::prepare(const double new_length, const State &state)
  {
    if (heat.prepare(new_length))
      set_heat_solver();
    if (deformation.prepare(new_length))
      set_deformation_solver(new_length, state);
  }

  template <int dim>
  void CoupledBackwardEuler<dim>::set_heat_solver()
  {
    cost.build("heat: set-up", [&]() { heat_solver.set_matrix(heat.system_matrix()); });
  }

  template <int dim>
  void CoupledBackwardEuler<dim>::set_deformation_solver(const double new_length, const State &state)
  {
    cost.build("deformation: set-up", [&]() { deformation_solver.set_matrix(deformation.system_matrix()); });
    const auto scope = cost.measure("coupling: set-up");
    cooling.copy_from(feedback.matrix());
    if (feedback.relaxes())
      cooling.add(1. / new_length, feedback.relaxed_matrix());
    length = new_length;
    for (auto *vector : {&rates, &right_hand_side})
      {
        vector->reinit(2);
        vector->block(0).reinit(state.temperature);
        vector->block(1).reinit(state.displacement);
        vector->collect_sizes();
      }
  }

  template <int dim>
  void CoupledBackwardEuler<dim>::assemble_right_hand_sides(const Step &step, const State &state)
  {
    heat.update_right_hand_side(step, state);
    deformation.update_right_hand_side(step, state);
    right_hand_side.block(0) = heat.right_hand_side();
    right_hand_side.block(1) = deformation.right_hand_side();

    // what the prescribed rates, and the last rate of displacement, do to the other balance
    Vector product = state.temperature;
    if (feedback.relaxes())
      {
        feedback.relaxed_matrix().vmult(product, state.displacement_rate);
        right_hand_side.block(0).add(1. / step.length(), product);
      }
    if (deformation.prescribed_rates().size() > 0)
      {
        cooling.vmult(product, deformation.prescribed_rates());
        right_hand_side.block(0) -= product;
      }
    heat.balance().elimination().condense(right_hand_side.block(0));
    if (heat.prescribed_rates().size() > 0)
      {
        product.reinit(state.displacement);
        expansion.force_of_change(heat.prescribed_rates(), product);
        right_hand_side.block(1).add(step.length(), product);
        deformation.balance().elimination().condense(right_hand_side.block(1));
      }
  }

  template <int dim>
  void CoupledBackwardEuler<dim>::solve(const Step &step)
  {
    const auto                  scope = cost.measure("coupling: solve");
    const CoupledMatrix<dim>    matrix{heat, deformation, cooling, expansion, length};
    const OneAfterTheOther<dim> preconditioner{
      heat_solver, deformation_solver, heat, deformation, expansion, length};

    largest_right_hand_side = std::max(largest_right_hand_side, right_hand_side.l2_norm());
    SolverControl             control(numerics.heat_solver.max_iterations,
                          numerics.heat_solver.tolerance * largest_right_hand_side);
    SolverFGMRES<BlockVector> solver(control);
    try
      {
        solver.solve(matrix, rates, right_hand_side, preconditioner);
      }
    catch (const SolverControl::NoConvergence &)
      {
        AssertThrow(false,
                    ExcRun("heat and deformation together did not converge in the step to t = " +
                           to_short_text(step.to) +
                           " s; take a smaller Time/Step, or Effects/Coupling = expansion"));
      }
    n_iterations += control.last_step();
  }

  template <int dim>
  void CoupledBackwardEuler<dim>::step(State &state, const double stop)
  {
    const Step step = next_step(state.time, settings.step, stop);
    heat.repeat_until_settled(step, state, [&]() -> Vector & {
      prepare(step.length(), state);
      assemble_right_hand_sides(step, state);
      solve(step);
      return rates.block(0);
    });
    heat.apply(step, rates.block(0), state);
    deformation.apply(step, rates.block(1), state);
    state.time = step.to;
    ++state.step;
  }

  template <int dim>
  void CoupledBackwardEuler<dim>::archive(Archive &archive, const State &state)
  {
    archive.shared("length of the step", length);
    const bool restores = archive.restores() && length > 0.;
    archive.section("heat", [&]() {
      heat.archive(archive, state, [&]() {
        if (restores)
          set_heat_solver();
        heat_solver.archive(archive);
      });
    });
    archive.section("deformation", [&]() {
      deformation.archive(archive, state, [&]() {
        if (restores)
          set_deformation_solver(length, state);
        deformation_solver.archive(archive);
      });
    });
    archive.shared("largest right-hand side", largest_right_hand_side);
    archive.shared("iterations", n_iterations);
    if (length == 0.)
      return;
    archive.nodal("rate of temperature", rates.block(0));
    archive.nodal("rate of displacement", rates.block(1));
  }

  template <int dim>
  std::map<std::string, double> CoupledBackwardEuler<dim>::statistics() const
  {
    return {{"linear_iterations_coupled", static_cast<double>(n_iterations)}};
  }

  template <int dim>
  std::map<std::string, TimeError> CoupledBackwardEuler<dim>::time_errors() const
  {
    std::map<std::string, TimeError> result;
    heat.add_time_error(result);
    deformation.add_time_error(result);
    return result;
  }

  template class CoupledBackwardEuler<2>;
  template class CoupledBackwardEuler<3>;
} // namespace Cautery
