// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/problems/problem.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

namespace Verification
{
  using namespace Cautery;

  /// A scene, run to its end without any output.
  class Run
  {
  public:
    explicit Run(Scene given)
      : scene(std::move(given))
      , body(scene, MPI_COMM_WORLD)
      , problem(make_problem(scene, body, cost))
      , state(problem->start())
    {
      while (state.time < scene.time.end)
        problem->step(state, scene.time.end);
      problem->complete(state);
    }

    const State   &end() const { return state; }
    GradientErrors gradient_errors() const
    {
      return Cautery::gradient_errors(body.nodes, body.tissues, problem->displacement(), state);
    }
    const Field<3> &temperature() const { return body.nodes; }
    const Field<3> &displacement() const { return *problem->displacement(); }

  private:
    const Scene                 scene;
    Cost                        cost;
    const Body<3>               body;
    std::unique_ptr<Problem<3>> problem;
    State                       state;
  };

  /// Of one quantity over the body: the difference and that of the gradients.
  struct Errors
  {
    double l2 = 0.;
    double h1 = 0.;
  };

  /**
   * The errors of @p values against @p exact (one Expression per component) at @p time. Slopes of the exact
   * solution are central differences, whose own error (1e-10) lies far below any that is measured.
   */
  inline Errors errors(const Field<3>                &field,
                       const Cautery::Vector         &values,
                       const std::vector<Expression> &exact,
                       const double                   time)
  {
    const unsigned int  degree = field.element().degree;
    const Quadrature<3> rule   = field.mesh().simplices() ? Quadrature<3>(QGaussSimplex<3>(degree + 2)) :
                                                            Quadrature<3>(QGauss<3>(degree + 2));
    FEValues<3>         at(field.mapping(),
                   field.element(),
                   rule,
                   update_values | update_gradients | update_quadrature_points | update_JxW_values);
    std::vector<dealii::Vector<double>>    found(rule.size(), dealii::Vector<double>(exact.size()));
    std::vector<std::vector<Tensor<1, 3>>> slopes(rule.size(), std::vector<Tensor<1, 3>>(exact.size()));
    const Cautery::Vector                  ghosted = field.ghosted(values);
    constexpr double                       h       = 1e-5;
    Errors                                 squares;
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        at.reinit(cell);
        at.get_function_values(ghosted, found);
        at.get_function_gradients(ghosted, slopes);
        for (const unsigned int q : at.quadrature_point_indices())
          for (unsigned int c = 0; c < exact.size(); ++c)
            {
              const Point<3> place      = at.quadrature_point(q);
              const double   difference = found[q](c) - exact[c].value(place, time);
              squares.l2 += difference * difference * at.JxW(q);
              for (unsigned int d = 0; d < 3; ++d)
                {
                  Point<3> left = place, right = place;
                  left[d] -= h;
                  right[d] += h;
                  const double slope = (exact[c].value(right, time) - exact[c].value(left, time)) / (2. * h);
                  squares.h1 += std::pow(slopes[q][c][d] - slope, 2) * at.JxW(q);
                }
            }
      }
    return {std::sqrt(Utilities::MPI::sum(squares.l2, field.communicator())),
            std::sqrt(Utilities::MPI::sum(squares.h1, field.communicator()))};
  }
} // namespace Verification
