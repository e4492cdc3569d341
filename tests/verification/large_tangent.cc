// SPDX-License-Identifier: LGPL-2.1-or-later
#include "large.h"

#include <cautery/time/newton_equilibrium.h>

namespace Verification
{
  namespace
  {
    Scene scene_of(const Element &element, const std::vector<Override> &overrides)
    {
      return read_scene(VERIFICATION_SCENES "/large.prm", joined({bent_cube(element), overrides}));
    }

    /// What problems compose, with its parts in the open.
    struct Parts
    {
      explicit Parts(const Scene &given)
        : scene(given)
        , body(scene, MPI_COMM_WORLD)
        , displacement(body.nodes, 3)
        , elasticity(scene, displacement, body.nodes, body.tissues, body.boundaries, body.locator)
      {
        state.displacement = displacement.vector();
        state.temperature  = body.nodes.vector();
        for (unsigned int i = 0; i < state.temperature.locally_owned_size(); ++i)
          state.temperature.begin()[i] = 310. + 20. * std::sin(i);
      }

      const Scene        scene;
      const Body<3>      body;
      const Field<3>     displacement;
      LargeElasticity<3> elasticity;
      State              state;
    };

    Cautery::Vector waves(const Parts &parts, const double size, const double frequency)
    {
      auto result = parts.displacement.vector();
      for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
        result.begin()[i] = size * std::sin(frequency * i);
      parts.elasticity.supports().elimination().distribute(result);
      return result;
    }

    /// The tangent against central differences of the residual, and against its transpose.
    void check_tangent(Checks &checks, const std::string &what, const Scene &scene)
    {
      Parts                 parts(scene);
      const Loading         loading = parts.elasticity.loading(parts.state);
      const Cautery::Vector x = waves(parts, 0.02, 1.7), y = waves(parts, 1., 2.9), z = waves(parts, 1., 0.6);
      Cautery::Vector       none, product = parts.displacement.vector(), ahead = product, behind = product;
      const double          step          = 3e-6;
      const Cautery::SparseMatrix &matrix = parts.elasticity.find_tangent(x, loading, none, product);
      matrix.vmult(product, y);
      parts.elasticity.supports().elimination().condense(product);

      Cautery::Vector place = x;
      place.add(step, y);
      const bool sound = !parts.elasticity.find_residual(place, loading, ahead);
      place.add(-2. * step, y);
      checks.holds(what + "no cell is inverted",
                   sound && !parts.elasticity.find_residual(place, loading, behind));
      ahead -= behind;
      ahead.sadd(0.5 / step, -1., product);
      checks.below(what + "tangent against differences of the residual, relative",
                   ahead.l2_norm() / product.l2_norm(),
                   1e-7);

      const double forth = product * z;
      matrix.vmult(product, z);
      checks.near(what + "the tangent is symmetric", product * y / forth, 1., 1e-11);
    }

    /// What prescribed moves do to the residual.
    void check_moves(Checks &checks, const Scene &scene)
    {
      Parts                 parts(scene);
      const Loading         loading = parts.elasticity.loading(parts.state);
      const Cautery::Vector x       = waves(parts, 0.02, 1.7);
      Cautery::Vector moves = parts.displacement.vector(), forces = moves, ahead = moves, behind = moves;
      for (unsigned int i = 0; i < moves.locally_owned_size(); ++i)
        moves.begin()[i] = std::sin(i);
      parts.elasticity.find_tangent(x, loading, moves, forces);
      Cautery::Vector place = x;
      place.add(1e-5, moves);
      parts.elasticity.find_residual(place, loading, ahead);
      place.add(-2e-5, moves);
      parts.elasticity.find_residual(place, loading, behind);
      ahead -= behind;
      ahead.sadd(0.5e5, -1., forces);
      checks.below("moves of held nodes against differences of the residual, relative",
                   ahead.l2_norm() / forces.l2_norm(),
                   1e-7);
    }
  } // namespace

  void tangent(Checks &checks)
  {
    for (const auto &element : elements)
      for (const auto &law : laws)
        for (const auto &heat : heats)
          if (law.name != "with fibres") // whose tangent jumps where they go slack
            check_tangent(checks,
                          element.name + ", " + law.name + heat.name + ": ",
                          scene_of(element, joined({law.overrides, heat.overrides})));
    check_moves(checks, scene_of(elements.front(), laws.back().overrides));
  }

  void order(Checks &checks)
  {
    for (const auto &element : elements)
      for (const auto &law : laws)
        {
          if (law.name == "linear")
            continue; // one iteration
          Parts                parts(scene_of(element,
                               joined({law.overrides,
                                                      {{"Boundaries/x1/Mechanical", "traction"},
                                                       {"Boundaries/x1/Traction", "300*t; 200*t; 0"}}})));
          Cost                 cost;
          NewtonEquilibrium<3> newton(
            parts.elasticity, {1e-14, 30, 1.}, parts.scene.numerics.deformation_solver, cost);
          parts.state.time = 1.;
          newton.solve(parts.state);
          parts.state.time = 1.5;
          newton.solve(parts.state);
          const auto &r = newton.residuals();
          std::cout << "    relative residuals:" << std::setprecision(2);
          for (const double residual : r)
            std::cout << ' ' << residual;
          std::cout << '\n';
          // the last three that rounding does not touch
          unsigned int k = r.size() - 1;
          while (k > 2 && r[k] < 1e-13)
            --k;
          const double found = std::log(r[k] / r[k - 1]) / std::log(r[k - 1] / r[k - 2]);
          checks.below(
            element.name + ", " + law.name + ": 1.8 less the order of Newton's method", 1.8 - found, 0.);
        }
  }
} // namespace Verification
