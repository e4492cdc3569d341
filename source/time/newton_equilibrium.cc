// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/rigid_motions.h>
#include <cautery/time/line_search.h>
#include <cautery/time/newton_equilibrium.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Cautery
{
  namespace
  {
    /// The first linear systems are solved to this, relative.
    constexpr double loosest = 1e-2;
    /// A factorisation of more unknowns fills the memory: the load is halved instead.
    constexpr types::global_dof_index most_to_factorise = 50000;
  } // namespace

  template <int dim>
  NewtonEquilibrium<dim>::NewtonEquilibrium(LargeElasticity<dim>       &body,
                                            const NewtonSettings       &settings,
                                            const LinearSolverSettings &solver_settings,
                                            Cost                       &cost)
    : body(body)
    , settings(settings)
    , solver_settings(solver_settings)
    , cost(cost)
    , solver(solver_settings, dim, [&body]() { return rigid_motions(body.field()); })
  {
    for (auto *vector : {&residual, &direction, &right_hand_side})
      *vector = body.field().vector();
  }

  template <int dim>
  void NewtonEquilibrium<dim>::solve(State &state)
  {
    if (!last)
      reached = body.unloaded(state);
    const Loading target  = body.loading(state);
    Loading       present = reached;
    Vector        x       = state.displacement;
    double        done    = 0.; // of the way from `reached` to `target`
    double        step    = 1.;
    while (done < 1.)
      {
        const double  share   = std::min(1., done + step);
        const Loading next    = Loading::between(reached, target, share);
        Vector        trial   = x;
        const Failure failure = iterate(present, next, trial);
        if (failure.empty())
          {
            x       = trial;
            present = next;
            done    = share;
            if (history.size() <= 6)
              step *= 2.;
            ++n_steps;
            continue;
          }
        step /= 2.;
        if (step < settings.smallest_step && done > 0.)
          keep_borne(state, present, x, done);
        AssertThrow(step >= settings.smallest_step,
                    ExcRun("no equilibrium found at t = " + to_short_text(state.time) + " s beyond " +
                           to_text(100. * done) + " % of the load's change: " + failure +
                           "; the body may give way under this load: load it less, load it in more output "
                           "times, refine the mesh there, or lower Numerics/Newton/Smallest load step"));
      }
    state.displacement = x;
    reached            = target;
    if (!last)
      last.emplace();
    last->time        = state.time;
    last->temperature = state.temperature;
  }

  /// A body's first load has no time before it; where it heats the body, there is no temperature for a part.
  template <int dim>
  void NewtonEquilibrium<dim>::keep_borne(const State   &asked,
                                          const Loading &load,
                                          const Vector  &x,
                                          const double   share)
  {
    if (!last && load.temperature.size() > 0)
      return;
    borne                     = BorneLoad{asked, body.unbalanced_forces(x, load)};
    borne->state.displacement = x;
    if (!last)
      return;
    borne->state.time = last->time + share * (asked.time - last->time);
    if (asked.temperature.size() > 0)
      borne->state.temperature.sadd(share, 1. - share, last->temperature);
  }

  /// Newton's method from @p x, in equilibrium with @p from, to equilibrium with @p target.
  template <int dim>
  std::string NewtonEquilibrium<dim>::iterate(const Loading &from, const Loading &target, Vector &x)
  {
    history.clear();
    Vector moves = target.prescribed;
    moves -= from.prescribed;
    bool must_move = moves.linfty_norm() > 0.;
    if (const auto inverted = find_residual(x, target))
      return inverted->message();
    start_norm = residual.l2_norm();
    for (unsigned int iteration = 0; iteration <= settings.max_iterations; ++iteration)
      {
        history.push_back(relative_residual(target));
        if (!must_move && history.back() <= settings.tolerance)
          {
            typical = acting_forces(target);
            return {};
          }
        if (iteration == settings.max_iterations)
          break;
        ++n_newton;
        Failure failure = must_move ? advance(target, moves, x) : descend(target, x);
        if (!failure.empty())
          return failure;
        must_move = false;
      }
    return "after " + std::to_string(settings.max_iterations) + " iterations of Newton's method forces of " +
           to_short_text(history.back()) + " of those that act are still left over";
  }

  /// An iteration that makes the prescribed @p moves, the rest of the body following as linear as it can.
  template <int dim>
  std::string NewtonEquilibrium<dim>::advance(const Loading &target, const Vector &moves, Vector &x)
  {
    Failure failure = find_direction(target, moves, x);
    if (!failure.empty())
      return failure;
    x += moves;
    x += direction;
    const auto inverted = find_residual(x, target);
    return inverted ? inverted->message() : Failure();
  }

  /// An iteration down to less energy.
  template <int dim>
  std::string NewtonEquilibrium<dim>::descend(const Loading &target, Vector &x)
  {
    const Failure failure = find_direction(target, Vector(), x);
    return failure.empty() ? search(target, x) : failure;
  }

  template <int dim>
  std::string
  NewtonEquilibrium<dim>::find_direction(const Loading &target, const Vector &moves, const Vector &x)
  {
    const double left = history.back();
    // not more accurate than the end asks for
    const double reduction =
      left > 0. ? std::max(std::min(loosest, left), std::min(loosest, 0.1 * settings.tolerance / left)) :
                  loosest;
    const SparseMatrix *tangent = nullptr;
    {
      const auto scope = cost.measure("deformation: tangent");
      tangent          = &body.find_tangent(x, target, moves, right_hand_side);
    }
    right_hand_side.sadd(-1., -1., residual);
    const auto scope = cost.measure("deformation: solve");
    Failure    failure;
    try
      {
        solver.set_matrix(*tangent);
        n_linear += solver.solve(direction, right_hand_side, reduction);
      }
    catch (const ExcRun &exception)
      {
        failure = message_of(exception);
      }
    if (!failure.empty() && solver_settings.method == LinearSolverSettings::Method::automatic &&
        tangent->m() <= most_to_factorise)
      failure = factorise_and_solve(*tangent);
    body.supports().elimination().distribute(direction);
    return failure;
  }

  /// For tangents that are not positive definite, or so badly conditioned that conjugate gradients fail.
  template <int dim>
  std::string NewtonEquilibrium<dim>::factorise_and_solve(const SparseMatrix &tangent)
  {
    LinearSolverSettings direct = solver_settings;
    direct.method               = LinearSolverSettings::Method::direct;
    try
      {
        LinearSolver factorisation(direct, dim, []() { return std::vector<Vector>(); });
        factorisation.set_matrix(tangent);
        factorisation.solve(direction, right_hand_side, loosest);
        return {};
      }
    catch (const ExcRun &exception)
      {
        return message_of(exception);
      }
  }

  /**
   * Goes from @p x along the direction, all of it if that is not too far: until the slope of the energy, the
   * product of residual and direction, is at most half as steep uphill as it was downhill at the start.
   */
  template <int dim>
  std::string NewtonEquilibrium<dim>::search(const Loading &target, Vector &x)
  {
    const double start = residual * direction;
    if (!(start < 0.))
      return "the tangent is not positive definite, as where a body buckles";
    const Vector                from = x;
    std::optional<InvertedCell> inverted;
    double                      length = 1.;
    for (unsigned int attempt = 0; attempt < LineSearch::most_attempts; ++attempt)
      {
        x = from;
        x.add(length, direction);
        inverted           = find_residual(x, target);
        const double slope = inverted ? std::numeric_limits<double>::infinity() : residual * direction;
        if (slope <= -LineSearch::flattened * start)
          return {};
        // between the secant's zero and a tenth of the way; half of it where nothing is known but "too far"
        const double secant = std::isfinite(slope) ? start / (start - slope) : 0.5;
        length *= std::max(0.1, secant);
      }
    return inverted ? inverted->message() : "Newton's direction does not lead down to less energy";
  }

  template <int dim>
  std::optional<InvertedCell> NewtonEquilibrium<dim>::find_residual(const Vector &x, const Loading &target)
  {
    const auto scope = cost.measure("deformation: residual");
    return body.find_residual(x, target, residual);
  }

  template <int dim>
  double NewtonEquilibrium<dim>::acting_forces(const Loading &target) const
  {
    return std::max({typical, start_norm, body.inner_forces(), target.force.l2_norm()});
  }

  template <int dim>
  double NewtonEquilibrium<dim>::relative_residual(const Loading &target) const
  {
    const double acting = acting_forces(target);
    return acting > 0. ? residual.l2_norm() / acting : 0.;
  }

  template <int dim>
  void NewtonEquilibrium<dim>::archive(Archive &archive, const State &state)
  {
    bool started = last.has_value();
    archive.shared("started", started);
    archive.shared("typical force", typical);
    archive.shared("load steps", n_steps);
    archive.shared("iterations", n_newton);
    archive.shared("linear iterations", n_linear);
    if (!started)
      return;
    if (archive.restores())
      {
        last.emplace();
        last->temperature = state.temperature; // of the right size
      }
    last->archive(archive);
    if (archive.restores())
      reached = body.loading(*last);
  }

  template <int dim>
  std::map<std::string, double> NewtonEquilibrium<dim>::statistics() const
  {
    return {
      {"load_steps", n_steps}, {"newton_iterations", n_newton}, {"linear_iterations_deformation", n_linear}};
  }

  template class NewtonEquilibrium<2>;
  template class NewtonEquilibrium<3>;
} // namespace Cautery
