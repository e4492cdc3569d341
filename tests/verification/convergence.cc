// SPDX-License-Identifier: LGPL-2.1-or-later
// Observed orders of convergence against manufactured solutions, printed as the tables of
// doc/verification.md:
//   convergence space | time | indicator
// Exit status 0 if every order is within 0.1 of theory, and the error indicator within a fifth of the error.
#include "manufactured.h"
#include "run.h"

#include <deal.II/base/mpi.h>

#include <iomanip>
#include <iostream>

namespace
{
  using namespace Verification;

  enum class Cells
  {
    tetrahedra,
    hexahedra,
    grid ///< of finite differences
  };

  std::string name(const Cells cells)
  {
    return cells == Cells::tetrahedra ? "tetrahedra" :
           cells == Cells::hexahedra  ? "hexahedra" :
                                        "differences";
  }

  /// The mesh, degree and course of time of one run.
  struct Choice
  {
    Cells        kind;
    unsigned int degree;
    unsigned int cells; ///< along an edge
    double       step          = 0.5;
    double       end           = 1.;
    double       ida_tolerance = 0.; ///< backward Euler if zero
  };

  struct Result
  {
    Errors         temperature;
    Errors         displacement;
    GradientErrors indicated;
  };

  Result solve(const Manufactured &exact, const Choice &choice)
  {
    auto overrides = exact.scene;
    overrides.push_back({"Mesh/Cells", choice.kind == Cells::tetrahedra ? "tetrahedra" : "hexahedra"});
    if (choice.kind == Cells::grid)
      overrides.push_back({"Numerics/Method", "finite differences"});
    overrides.push_back({"Mesh/Subdivisions", std::to_string(choice.cells)});
    overrides.push_back({"Numerics/Element degree", std::to_string(choice.degree)});
    overrides.push_back({"Time/Step", to_text(choice.step)});
    overrides.push_back({"Time/End", to_text(choice.end)});
    if (choice.ida_tolerance > 0.)
      {
        overrides.push_back({"Time/Integrator", "IDA"});
        overrides.push_back({"Time/Relative tolerance", to_text(choice.ida_tolerance)});
        overrides.push_back({"Time/Absolute tolerance", to_text(choice.ida_tolerance)});
      }
    const Run run(read_scene(VERIFICATION_SCENES "/manufactured.prm", overrides));
    Result    result;
    result.indicated = run.gradient_errors();
    if (!exact.temperature.empty())
      result.temperature = errors(run.temperature(), run.end().temperature, exact.temperature, choice.end);
    if (!exact.displacement.empty())
      result.displacement =
        errors(run.displacement(), run.end().displacement, exact.displacement, choice.end);
    return result;
  }

  /// Prints a row of a table: errors, then the orders between them. Returns whether the last is @p theory +-
  /// 0.1.
  bool row(const std::string         &label,
           const std::vector<double> &errors,
           const std::vector<double> &sizes,
           const double               theory)
  {
    double order = 0.;
    std::cout << "| " << label << " |" << std::scientific << std::setprecision(2);
    for (const double error : errors)
      std::cout << ' ' << error << " |";
    std::cout << std::fixed;
    for (unsigned int i = 1; i < errors.size(); ++i)
      {
        order = std::log(errors[i - 1] / errors[i]) / std::log(sizes[i - 1] / sizes[i]);
        std::cout << ' ' << order << " |";
      }
    const bool right = std::abs(order - theory) <= 0.1;
    std::cout << ' ' << std::setprecision(0) << theory << (right ? " |" : " | WRONG") << std::endl;
    return right;
  }

  const std::vector<Model> all_models = {Model::fourier,
                                         Model::non_fourier,
                                         Model::elastic,
                                         Model::expansion,
                                         Model::two_way_fourier,
                                         Model::two_way_non_fourier};

  bool space_row(const Model model, const Cells cells, const unsigned int degree)
  {
    const std::vector<unsigned int> counts =
      degree == 1 ? std::vector<unsigned int>{4, 7, 12} : std::vector<unsigned int>{2, 4, 6};
    const Manufactured  exact = wave_in_space(model);
    std::vector<double> sizes;
    std::vector<Result> results;
    for (const unsigned int count : counts)
      {
        sizes.push_back(1. / count);
        results.push_back(solve(exact, {cells, degree, count}));
      }
    const std::string label = name(model) + " | " + name(cells) + " | " + std::to_string(degree) + " | ";
    const auto        check = [&](const std::string &what, const auto &pick, const double theory) {
      std::vector<double> list;
      for (const Result &result : results)
        list.push_back(pick(result));
      return row(label + what, list, sizes, theory);
    };
    bool right = true;
    if (has_heat(model))
      {
        right &= check(
          "T, L2", [](const Result &r) { return r.temperature.l2; }, degree + 1);
        right &= check(
          "T, H1", [](const Result &r) { return r.temperature.h1; }, degree);
      }
    if (has_deformation(model))
      {
        right &= check(
          "u, L2", [](const Result &r) { return r.displacement.l2; }, degree + 1);
        right &= check(
          "u, H1", [](const Result &r) { return r.displacement.h1; }, degree);
      }
    return right;
  }

  bool space()
  {
    std::cout << "| model | cells | degree | error | coarse | middle | fine | order | order | theory |\n"
                 "|---|---|---|---|---|---|---|---|---|---|\n";
    bool right = true;
    for (const Model model : all_models)
      {
        for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra})
          for (const unsigned int degree : {1, 2})
            right &= space_row(model, cells, degree);
        right &= space_row(model, Cells::grid, 1);
      }
    return right;
  }

  /// Indicated error over true error, of the gradients. It must come closer to one and end within a fifth.
  bool indicator_row(const Cells cells, const unsigned int degree)
  {
    const Manufactured exact = wave_in_space(Model::expansion);
    const auto         counts =
      degree == 1 ? std::vector<unsigned int>{4, 8, 16} : std::vector<unsigned int>{2, 4, 8};
    std::vector<double> temperature, displacement;
    for (const unsigned int count : counts)
      {
        const Result result = solve(exact, {cells, degree, count});
        temperature.push_back(result.indicated.at("temperature").error / result.temperature.h1);
        displacement.push_back(result.indicated.at("displacement").error / result.displacement.h1);
      }
    const auto print = [&](const std::string &field, const std::vector<double> &ratios) {
      std::cout << "| " << name(cells) << " | " << degree << " | " << field << " |" << std::fixed
                << std::setprecision(2);
      for (const double ratio : ratios)
        std::cout << ' ' << ratio << " |";
      const bool right = std::abs(ratios.back() - 1.) <= 0.2 &&
                         std::abs(ratios.back() - 1.) <= std::abs(ratios.front() - 1.) + 0.02;
      std::cout << (right ? "" : " WRONG") << std::endl;
      return right;
    };
    return print("T", temperature) & print("u", displacement);
  }

  bool indicator()
  {
    std::cout << "| cells | degree | field | coarse | middle | fine |\n|---|---|---|---|---|---|\n";
    bool right = true;
    for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra})
      for (const unsigned int degree : {1, 2})
        right &= indicator_row(cells, degree);
    return right;
  }

  bool backward_euler_rows(const Model model, const Cells cells)
  {
    const unsigned int        degree = has_deformation(model) ? 2 : 1;
    const std::vector<double> steps  = {0.04, 0.02, 0.01};
    const Manufactured        exact  = wave_in_time(model);
    std::vector<double>       temperature, displacement;
    for (const double step : steps)
      {
        const Result result = solve(exact, {cells, degree, 2, step, 0.6});
        temperature.push_back(result.temperature.l2);
        displacement.push_back(result.displacement.l2);
      }
    const std::string label = name(model) + " | " + name(cells) + " | ";
    bool              right = row(label + "T, L2", temperature, steps, 1.);
    if (has_deformation(model))
      right &= row(label + "u, L2", displacement, steps, 1.);
    return right;
  }

  /**
   * IDA controls its local error, of which a number adds up that hardly changes: errors in proportion to the
   * tolerance. Its order and steps change in jumps, hence a factor of 5 either way over the whole range of
   * 1e4.
   */
  bool ida_row(const Model model)
  {
    const Manufactured        exact      = wave_in_time(model);
    const std::vector<double> tolerances = {1e-4, 1e-6, 1e-8};
    std::vector<double>       found;
    bool                      right = true;
    std::cout << "| " << name(model) << " |" << std::scientific << std::setprecision(2);
    for (const double tolerance : tolerances)
      {
        found.push_back(solve(exact, {Cells::tetrahedra, 1, 2, 0.5, 0.6, tolerance}).temperature.l2);
        std::cout << ' ' << found.back() << " |";
      }
    std::cout << std::fixed << std::setprecision(0);
    for (unsigned int i = 1; i < found.size(); ++i)
      {
        right &= found[i] < found[i - 1];
        std::cout << ' ' << found[i - 1] / found[i] << " |";
      }
    const double gain = found.front() / found.back();
    right &= gain > 2e3 && gain < 5e4;
    std::cout << (right ? "" : " WRONG") << std::endl;
    return right;
  }

  bool time()
  {
    bool right = true;
    std::cout << "| model | cells | error | dt = 0.04 | 0.02 | 0.01 | order | order | theory |\n"
                 "|---|---|---|---|---|---|---|---|---|\n";
    for (const Model model : all_models)
      if (has_heat(model))
        for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra})
          right &= backward_euler_rows(model, cells);
    std::cout
      << "\n| IDA | error at tolerance 1e-4 | 1e-6 | 1e-8 | ratio | ratio |\n|---|---|---|---|---|---|\n";
    for (const Model model : {Model::fourier, Model::non_fourier})
      right &= ida_row(model);
    return right;
  }
} // namespace

int main(int argc, char **argv)
{
  deal_II_exceptions::suppress_stacktrace_in_exceptions();
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      const std::string what = argc > 1 ? argv[1] : "";
      return (what == "time" ? time() : what == "indicator" ? indicator() : space()) ? 0 : 1;
    }
  catch (const std::exception &exception)
    {
      std::cerr << exception.what() << std::endl;
      return 2;
    }
}
