// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chain.h"

#include <cautery/physics/elasticity.h>
#include <cautery/physics/heat.h>
#include <cautery/problems/body.h>

#include <array>

namespace Verification
{
  namespace
  {
    using Index = std::array<int, 3>;

    constexpr Index                 n_cells = {{5, 4, 6}};
    constexpr std::array<double, 3> lengths = {{1., 1.2, 0.9}}; // m: no two spacings are alike

    double spacing(const unsigned int axis) { return lengths[axis] / n_cells[axis]; }

    Scene grid_scene(const std::string &heat)
    {
      return read_scene(VERIFICATION_SCENES "/manufactured.prm",
                        {{"Mesh/Cells", "hexahedra"},
                         {"Mesh/Upper corner", "1, 1.2, 0.9"},
                         {"Mesh/Subdivisions", "5, 4, 6"},
                         {"Numerics/Method", "finite differences"},
                         {"Effects/Heat", heat},
                         {"Effects/Perfusion", "on"},
                         {"Effects/Deformation", "inertia"},
                         {"Effects/Coupling", "two-way"}});
    }

    /// Values at the points (i, j, k) of the grid, as the thesis writes them.
    class GridValues
    {
    public:
      GridValues(const Field<3> &field, const Cautery::Vector &x)
      {
        const auto                          &fe = field.element();
        std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
        for (const auto &cell : field.dof_handler().active_cell_iterators())
          {
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              {
                const auto [component, node]                   = fe.system_to_component_index(i);
                values[{index(cell->vertex(node)), component}] = x(dofs[i]);
              }
          }
      }

      double operator()(const Index &point, const unsigned int component = 0) const
      {
        return values.at({point, component});
      }

    private:
      static Index index(const Point<3> &place)
      {
        Index result;
        for (unsigned int d = 0; d < 3; ++d)
          result[d] = std::lround(place[d] / spacing(d));
        return result;
      }

      std::map<std::pair<Index, unsigned int>, double> values;
    };

    Index moved(Index point, const unsigned int axis, const int by)
    {
      point[axis] += by;
      return point;
    }

    // Eqs. 4-29 and 4-30

    double second(const GridValues &u, const Index &p, const unsigned int axis, const unsigned int c)
    {
      return (u(moved(p, axis, 1), c) + u(moved(p, axis, -1), c) - 2. * u(p, c)) / std::pow(spacing(axis), 2);
    }

    double first(const GridValues &u, const Index &p, const unsigned int axis, const unsigned int c = 0)
    {
      return (u(moved(p, axis, 1), c) - u(moved(p, axis, -1), c)) / (2. * spacing(axis));
    }

    double mixed(
      const GridValues &u, const Index &p, const unsigned int a, const unsigned int b, const unsigned int c)
    {
      const auto corner = [&](const int i, const int j) { return u(moved(moved(p, a, i), b, j), c); };
      return (corner(1, 1) - corner(1, -1) - corner(-1, 1) + corner(-1, -1)) / (4. * spacing(a) * spacing(b));
    }

    /// The largest difference at inner points, relative to the largest value.
    template <typename Found, typename Exact>
    double difference(const Found &found, const Exact &exact)
    {
      double apart = 0., largest = 0.;
      for (int i = 1; i < n_cells[0]; ++i)
        for (int j = 1; j < n_cells[1]; ++j)
          for (int k = 1; k < n_cells[2]; ++k)
            {
              const double value = exact(Index{{i, j, k}});
              largest            = std::max(largest, std::abs(value));
              apart              = std::max(apart, std::abs(found(Index{{i, j, k}}) - value));
            }
      return apart / largest;
    }

    Cautery::Vector rough(const Field<3> &field)
    {
      Cautery::Vector result = field.vector();
      for (unsigned int i = 0; i < result.size(); ++i)
        result(i) = std::sin(1.7 * i * i) + 0.3 * std::cos(0.9 * i);
      return result;
    }

    /// What a problem composes.
    struct Grid
    {
      explicit Grid(const std::string &heat_model)
        : scene(grid_scene(heat_model))
        , body(scene, MPI_COMM_SELF)
        , displacement(body.nodes, 3)
        , heat(scene, body.nodes, body.tissues, body.boundaries, body.locator)
        , elasticity(scene, displacement, body.nodes, body.tissues, body.boundaries, body.locator)
        , feedback(body.nodes, displacement, body.tissues, false)
        , temperature(rough(body.nodes))
        , T(body.nodes, temperature)
        , shift(rough(displacement))
        , u(displacement, shift)
      {
      }

      GridValues
      product(const Cautery::SparseMatrix &matrix, const Field<3> &rows, const Cautery::Vector &x) const
      {
        Cautery::Vector result = rows.vector();
        matrix.vmult(result, x);
        return {rows, result};
      }

      const Scene              scene;
      const Body<3>            body;
      const Field<3>           displacement;
      const Heat<3>            heat;
      const Elasticity<3>      elasticity;
      ThermoelasticFeedback<3> feedback;
      const Cautery::Vector    temperature;
      const GridValues         T;
      const Cautery::Vector    shift;
      const GridValues         u;
      const double             volume = spacing(0) * spacing(1) * spacing(2); ///< of a point, m3
    };

    // of scenes/manufactured.prm
    constexpr double k = 0.7, tau = 0.3, w = 0.5, E = 2.6, nu = 0.3, alpha = 0.1, T_0 = 2.;
    constexpr double mu = E / (2. * (1. + nu)), lambda = E * nu / ((1. + nu) * (1. - 2. * nu));
    constexpr double beta = E * alpha / (1. - 2. * nu);

    void check_heat(Checks &checks, const Grid &grid, const std::string &model, const double delay)
    {

      const auto laplace = [&](const Index &p) {
        return second(grid.T, p, 0, 0) + second(grid.T, p, 1, 0) + second(grid.T, p, 2, 0);
      };
      checks.below(model + ": conduction and blood, Eq. 4-29",
                   difference(grid.product(grid.heat.stiffness().full, grid.body.nodes, grid.temperature),
                              [&](const Index &p) { return grid.volume * (w * grid.T(p) - k * laplace(p)); }),
                   1e-12);
      checks.below(model + ": capacity of one point alone",
                   difference(grid.product(grid.heat.damping()->full, grid.body.nodes, grid.temperature),
                              [&](const Index &p) { return grid.volume * (1. + delay * w) * grid.T(p); }),
                   1e-12);
      if (delay > 0.)
        checks.below(model + ": relaxation of one point alone",
                     difference(grid.product(grid.heat.inertia()->full, grid.body.nodes, grid.temperature),
                                [&](const Index &p) { return grid.volume * delay * grid.T(p); }),
                     1e-12);
    }

    void check_momentum(Checks &checks, const Grid &grid)
    {

      const GridValues force = grid.product(grid.elasticity.stiffness().full, grid.displacement, grid.shift);
      const GridValues mass  = grid.product(grid.elasticity.inertia()->full, grid.displacement, grid.shift);
      Cautery::Vector  thermal = grid.displacement.vector();
      grid.elasticity.expansion()->add_force(grid.temperature, thermal);
      const GridValues expansion(grid.displacement, thermal);
      for (unsigned int c = 0; c < 3; ++c)
        {
          const std::string along = std::string("momentum along ") + "xyz"[c];
          const auto        exact = [&](const Index &p) {
            double sum = 0.;
            for (unsigned int d = 0; d < 3; ++d)
              sum += mu * second(grid.u, p, d, c) +
                     (lambda + mu) * (d == c ? second(grid.u, p, c, c) : mixed(grid.u, p, c, d, d));
            return -grid.volume * sum;
          };
          checks.below(along + ": stress, Eq. 4-30",
                       difference([&](const Index &p) { return force(p, c); }, exact),
                       1e-12);
          checks.below(along + ": expansion, Eq. 4-30",
                       difference([&](const Index &p) { return expansion(p, c); },
                                  [&](const Index &p) { return -grid.volume * beta * first(grid.T, p, c); }),
                       1e-12);
          checks.below(along + ": mass of one point alone",
                       difference([&](const Index &p) { return mass(p, c); },
                                  [&](const Index &p) { return grid.volume * grid.u(p, c); }),
                       1e-12);
        }
      checks.below("feedback: central differences of the divergence",
                   difference(grid.product(grid.feedback.matrix(), grid.body.nodes, grid.shift),
                              [&](const Index &p) {
                                double divergence = 0.;
                                for (unsigned int c = 0; c < 3; ++c)
                                  divergence += first(grid.u, p, c, c);
                                return grid.volume * beta * T_0 * divergence;
                              }),
                   1e-12);
    }
  } // namespace

  /// Finite differences are the trapezoidal rule: the matrices against the thesis's stencils, point by point.
  void stencils(Checks &checks)
  {
    const Grid fourier("Fourier");
    check_heat(checks, fourier, "Fourier", 0.);
    check_momentum(checks, fourier);
    check_heat(checks, Grid("non-Fourier"), "non-Fourier", tau);
    checks.below("entries per row of heat: seven points",
                 static_cast<double>(fourier.heat.stiffness().full.n_nonzero_elements()) /
                   fourier.heat.stiffness().full.m(),
                 7.);
  }
} // namespace Verification
