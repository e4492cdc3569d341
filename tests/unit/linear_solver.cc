// SPDX-License-Identifier: LGPL-2.1-or-later
// All ways of solving agree, on matrices like those of heat and of elasticity, and what has been solved
// before costs nothing. The output is the same on any number of processes.
#include <cautery/solve/linear_solver.h>
#include <cautery/solve/projected_guess.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace Cautery::Test
{
  using Method = LinearSolverSettings::Method;

  const MPI_Comm     communicator = MPI_COMM_WORLD;
  ConditionalOStream out(std::cout, false);

  constexpr unsigned int n = 12; ///< nodes along an edge of a cube

  /**
   * Springs between the nodes of a cube and their neighbours along edges, face and space diagonals, the
   * outside held by springs of its own: acting along their length (elasticity) or on a scalar (heat, with a
   * capacity).
   */
  struct Lattice
  {
    unsigned int n_components;
    double       sideways; ///< stiffness across a spring's length, relative
    double       capacity;

    IndexSet owned() const
    {
      const unsigned int processes = Utilities::MPI::n_mpi_processes(communicator);
      const unsigned int process   = Utilities::MPI::this_mpi_process(communicator);
      const unsigned int nodes     = n * n * n;
      IndexSet           rows(nodes * n_components);
      rows.add_range(nodes * process / processes * n_components,
                     nodes * (process + 1) / processes * n_components);
      return rows;
    }

    double spring(const int (&d)[3], const unsigned int c, const unsigned int e) const
    {
      const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      const double along  = n_components == 1 ? 0. : d[c] * d[e] / square;
      return (1. - sideways) * along + (c == e ? sideways : 0.);
    }

    /// Calls use(column, value), each column perhaps often, for the row of component c of a node.
    template <typename Use>
    void row(const unsigned int node, const unsigned int c, const Use &use) const
    {
      const int place[3] = {int(node % n), int(node / n % n), int(node / (n * n))};
      use(node * n_components + c, capacity);
      for (int k = 0; k < 27; ++k)
        {
          const int d[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
          if (k == 13)
            continue;
          bool inside = true;
          for (int a = 0; a < 3; ++a)
            inside = inside && place[a] + d[a] >= 0 && place[a] + d[a] < int(n);
          const unsigned int neighbour =
            (place[0] + d[0]) + n * (place[1] + d[1]) + n * n * (place[2] + d[2]);
          for (unsigned int e = 0; e < n_components; ++e)
            {
              use(node * n_components + e, spring(d, c, e));
              if (inside)
                use(neighbour * n_components + e, -spring(d, c, e));
            }
        }
    }

    void fill(SparseMatrix &matrix) const
    {
      const IndexSet                    rows = owned();
      TrilinosWrappers::SparsityPattern pattern(rows, communicator, 27 * n_components);
      const auto                        each = [&](const auto &use) {
        for (const auto i : rows)
          row(i / n_components, i % n_components, [&](const types::global_dof_index j, const double value) {
            use(i, j, value);
          });
      };
      each([&](const auto i, const auto j, const double) { pattern.add(i, j); });
      pattern.compress();
      matrix.reinit(pattern);
      each([&](const auto i, const auto j, const double value) { matrix.add(i, j, value); });
      matrix.compress(VectorOperation::add);
    }

    Vector vector(const std::function<double(const double)> &value) const
    {
      Vector result(owned(), communicator);
      for (const auto i : owned())
        result(i) = value(i);
      result.compress(VectorOperation::insert);
      return result;
    }

    /// Translations and rotations.
    std::vector<Vector> modes() const
    {
      std::vector<Vector> result;
      for (unsigned int c = 0; c < n_components; ++c)
        result.push_back(vector([&](const double i) { return unsigned(i) % n_components == c ? 1. : 0.; }));
      for (unsigned int c = 0; n_components == 3 && c < 3; ++c)
        result.push_back(vector([&](const double i) {
          const unsigned int node     = unsigned(i) / 3;
          const double       place[3] = {double(node % n), double(node / n % n), double(node / (n * n))};
          const unsigned int a = (c + 1) % 3, b = (c + 2) % 3, own = unsigned(i) % 3;
          return own == a ? -place[b] : own == b ? place[a] : 0.;
        }));
      return result;
    }
  };

  LinearSolver solver(const Lattice &lattice, const LinearSolverSettings &settings)
  {
    return {settings, lattice.n_components, [&lattice]() { return lattice.modes(); }};
  }

  void methods_agree(const std::string &name, const Lattice &lattice)
  {
    SparseMatrix matrix;
    lattice.fill(matrix);
    const Vector exact = lattice.vector([](const double i) { return std::sin(0.3 * i) + 1e-3 * i; });
    Vector       b     = exact;
    matrix.vmult(b, exact);
    for (const auto method : {Method::direct, Method::cg_ssor, Method::cg_amg, Method::gauss_seidel})
      {
        LinearSolverSettings settings;
        settings.method = method;
        auto solve      = solver(lattice, settings);
        solve.set_matrix(matrix);
        Vector x = exact;
        solve.solve(x, b, 1e-12);
        x -= exact;
        out << name << ", " << solve.description()
            << ": right to 1e-10: " << (x.linfty_norm() < 1e-10 * exact.linfty_norm() ? "yes" : "no")
            << std::endl;
      }
  }

  void what_is_known_is_free(const Lattice &lattice)
  {
    SparseMatrix matrix;
    lattice.fill(matrix);
    auto solve = solver(lattice, {});
    solve.set_matrix(matrix);
    const Vector first  = lattice.vector([](const double i) { return std::cos(0.1 * i); });
    const Vector second = lattice.vector([](const double i) { return std::cos(0.17 * i); });
    Vector       x      = first;
    const bool   worked = solve.solve(x, first, 1e-10) > 0 && solve.solve(x, second, 1e-10) > 0;
    Vector       both   = first;
    both.sadd(2., -3., second);
    const unsigned int iterations = solve.solve(x, both, 1e-8);
    Vector             residual   = both;
    matrix.vmult(residual, x);
    residual -= both;
    out << "two right-hand sides take iterations: " << (worked ? "yes" : "no")
        << ", their combination: " << iterations
        << ", solved to 1e-8: " << (residual.l2_norm() < 1e-8 * both.l2_norm() ? "yes" : "no") << std::endl;

    matrix *= 2.;
    solve.set_matrix(matrix);
    out << "another matrix takes iterations again: " << (solve.solve(x, both, 1e-8) > 0 ? "yes" : "no")
        << std::endl;
  }

  void automatic_goes_over_to_multigrid(const Lattice &lattice)
  {
    SparseMatrix matrix;
    lattice.fill(matrix);
    const Vector         b = lattice.vector([](const double i) { return std::cos(0.1 * i); });
    LinearSolverSettings settings;
    settings.max_iterations = 12;
    auto solve              = solver(lattice, settings);
    solve.set_matrix(matrix);
    out << "automatic begins with " << solve.description();
    Vector x = b;
    solve.solve(x, b, 1e-8);
    Vector residual = b;
    matrix.vmult(residual, x);
    residual -= b;
    out << ", ends with " << solve.description()
        << ", solved to 1e-8: " << (residual.l2_norm() < 1e-8 * b.l2_norm() ? "yes" : "no") << std::endl;
  }

  /**
   * A body in free fall: right-hand sides along one vector but for rounding, so that corrections are nothing
   * but rounding, and their images are not quite theirs.
   */
  void guess_learns_nothing_from_rounding(const Lattice &lattice)
  {
    SparseMatrix matrix;
    lattice.fill(matrix);
    const Vector solution = lattice.vector([](const double i) { return 1. + 1e-3 * std::sin(i); });
    Vector       force    = solution;
    matrix.vmult(force, solution);
    LinearSolverSettings settings;
    settings.method = Method::direct;
    auto exact      = solver(lattice, settings);
    exact.set_matrix(matrix);

    ProjectedGuess guess(16);
    guess.clear(matrix.linfty_norm());
    double worst = 0.;
    for (unsigned int k = 0; k < 200; ++k)
      {
        Vector residual = lattice.vector([k](const double i) { return 1e-16 * std::sin(0.7 * i + k); });
        residual *= force.linfty_norm();
        residual += force;
        Vector x = solution, correction = solution, image = solution;
        guess.apply(x, residual);
        exact.solve(correction, residual, 1e-12);
        matrix.vmult(image, correction);
        image.add(1e-16 * force.linfty_norm(),
                  lattice.vector([k](const double i) { return std::cos(i * k); }));
        x += correction;
        guess.learn(correction, image);
        x -= solution;
        worst = std::max(worst, x.linfty_norm());
      }
    out << "a guess from rounding stays right to 1e-10: " << (worst < 1e-10 ? "yes" : "no") << std::endl;
  }

  template <typename Work>
  void refuses(const std::string &what, const Work &work)
  {
    bool refused = false;
    try
      {
        work();
      }
    catch (const ExcRun &)
      {
        refused = true;
      }
    out << what << (refused ? ": refused" : ": NOT refused") << std::endl;
  }

  void failures(const Lattice &lattice)
  {
    SparseMatrix matrix;
    lattice.fill(matrix);
    Vector x = lattice.vector([](const double) { return 1.; });
    for (const auto method : {Method::cg_ssor, Method::cg_amg, Method::gauss_seidel})
      {
        LinearSolverSettings settings;
        settings.method         = method;
        settings.max_iterations = 2;
        auto solve              = solver(lattice, settings);
        solve.set_matrix(matrix);
        refuses(solve.description() + " in two iterations", [&]() { solve.solve(x, x, 1e-12); });
      }
    auto solve = solver(lattice, {});
    solve.set_matrix(matrix);
    const Vector bad =
      lattice.vector([](const double i) { return i == 5. ? std::numeric_limits<double>::quiet_NaN() : 1.; });
    refuses("a right-hand side with NaN", [&]() { solve.solve(x, bad); });
    matrix *= 0.;
    for (const auto method : {Method::direct, Method::cg_ssor})
      {
        LinearSolverSettings settings;
        settings.method = method;
        auto lost       = solver(lattice, settings);
        refuses("a singular matrix", [&]() {
          lost.set_matrix(matrix);
          lost.solve(x, x, 1e-8);
        });
      }
  }
} // namespace Cautery::Test

int main(int argc, char **argv)
{
  using namespace Cautery::Test;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  out.set_condition(dealii::Utilities::MPI::this_mpi_process(communicator) == 0);
  const Lattice heat{1, 1., 5.};
  const Lattice elastic{3, 0.1, 0.};
  methods_agree("heat", heat);
  methods_agree("elastic", elastic);
  what_is_known_is_free(heat);
  what_is_known_is_free(elastic);
  guess_learns_nothing_from_rounding(elastic);
  automatic_goes_over_to_multigrid(elastic);
  failures(elastic);
}
