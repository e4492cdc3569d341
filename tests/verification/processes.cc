// SPDX-License-Identifier: LGPL-2.1-or-later
// Run on three processes: each scene on one, two and all of them. The probes must agree to 1e-9 of the
// largest value of their column, those of explicit steps to 1e-12.
#include "chain.h"

namespace
{
  using namespace Verification;

  struct Case
  {
    std::string           scene;
    std::vector<Override> overrides;
    double                tolerance = 1e-9;
  };

  /// Without any equation to solve, only the order of sums differs.
  constexpr double explicit_steps = 1e-12;

  const std::vector<Case> cases = {
    {"balance", {}},
    {"balance", {{"Mesh/Cells", "hexahedra"}, {"Numerics/Element degree", "2"}}},
    {"balance", {{"Effects/Heat", "non-Fourier"}}},
    {"balance",
     {{"Mesh/Cells", "hexahedra"},
      {"Numerics/Method", "finite differences"},
      {"Effects/Deformation", "equilibrium"},
      {"Effects/Coupling", "two-way"}}},
    {"condensed", {{"Numerics/Kept nodes", "inside, probes"}}},
    {"balance", {{"Time/Integrator", "IDA"}, {"Effects/Heat", "non-Fourier"}}},
    {"balance", {{"Time/Integrator", "IDA"}}},
    {"balance", {{"Effects/Deformation", "equilibrium"}, {"Effects/Coupling", "expansion"}}},
    {"balance", // at the default tolerances
     {{"Effects/Deformation", "equilibrium"},
      {"Effects/Coupling", "expansion"},
      {"Numerics/Heat solver/Tolerance", "1e-10"},
      {"Numerics/Deformation solver/Tolerance", "1e-10"}}},
    {"balance", {{"Effects/Deformation", "equilibrium"}, {"Effects/Coupling", "two-way"}}},
    {"balance", {{"Effects/Deformation", "inertia"}, {"Effects/Coupling", "expansion"}}},
    {"balance",
     {{"Effects/Deformation", "equilibrium"},
      {"Effects/Coupling", "expansion"},
      {"Effects/Damage", "thermo-mechanical strain energy"}}},
    {"balance",
     {{"Effects/Damage", "Arrhenius"},
      {"Effects/Perfusion stops in dead tissue", "on"},
      {"Heat sources/needle/Power", "2"}}},
    {"balance", {{"Effects/Damage", "critical thermal load"}}},
    {"balance",
     {{"Effects/Deformation", "large equilibrium"},
      {"Effects/Coupling", "expansion"},
      {"Effects/Damage", "thermo-mechanical strain energy"},
      {"Numerics/Newton/Tolerance", "1e-12"}}},
    {"large",
     {{"Mesh/Subdivisions", "3"},
      {"Boundaries/x1/Mechanical", "traction"},
      {"Boundaries/x1/Traction", "500; 300*y; 0"},
      {"Tissues/tissue/Fibre families", "all"},
      {"Tissues/tissue/all/Fibre direction", "1; y; 0.5"}}},
    {"large",
     {{"Mesh/Cells", "hexahedra"},
      {"Numerics/Element degree", "2"},
      {"Boundaries/x1/Mechanical", "displacement"},
      {"Boundaries/x1/Displacement", "0.3; 0.1*z; 0"}}},
    {"large",
     {{"Mesh/Subdivisions", "3"},
      {"Effects/Deformation", "explicit dynamics"},
      {"Boundaries/x1/Mechanical", "traction"},
      {"Boundaries/x1/Traction", "500*t; 300*y; 0"},
      {"Tissues/tissue/Fibre families", "all"},
      {"Tissues/tissue/all/Fibre direction", "1; y; 0.5"},
      {"Numerics/Explicit/Averaged pressure", "on"},
      {"Tools/Names", "grip"},
      {"Tools/grip/Centre", "1, 1, 1"},
      {"Tools/grip/Radius", "0.4"},
      {"Tools/grip/Displacement", "0; 0.2*sin(3*t); 0.1*t"},
      {"Output/Interval", "0.25"}},
     explicit_steps},
    {"balance",
     {{"Time/Integrator", "explicit"},
      {"Effects/Heat", "non-Fourier"},
      {"Effects/Deformation", "explicit dynamics"},
      {"Effects/Coupling", "expansion"},
      {"Tissues/tissue/Young's modulus", "1000"}},
     explicit_steps},
    {"balance",
     {{"Time/Integrator", "IDA"},
      {"Time/End", "3"}, // before IDA starts anew, which it does a little differently each time
      {"Output/Times", "1"},
      {"Effects/Deformation", "explicit dynamics"},
      {"Effects/Coupling", "expansion"},
      {"Tissues/tissue/Young's modulus", "1000"}}},
    {"balance", // meshes that come and go
     {{"Mesh/Cells", "hexahedra"},
      {"Mesh/Adaptive/Follow", "temperature"},
      {"Mesh/Adaptive/Interval", "2"},
      {"Mesh/Adaptive/Largest number of divisions", "2"}}},
    {"balance",
     {{"Mesh/Cells", "hexahedra"},
      {"Mesh/Subdivisions", "2"},
      {"Mesh/Adaptive/Follow", "both"},
      {"Mesh/Adaptive/Target error", "0.2"},
      {"Mesh/Adaptive/Interval", "3"},
      {"Mesh/Adaptive/Largest number of divisions", "2"},
      {"Effects/Heat", "non-Fourier"},
      {"Effects/Deformation", "equilibrium"},
      {"Effects/Coupling", "two-way"},
      {"Effects/Damage", "thermo-mechanical strain energy"},
      {"Effects/Perfusion stops in dead tissue", "on"}}},
    {"balance",
     {{"Mesh/Cells", "hexahedra"},
      {"Mesh/Subdivisions", "2"},
      {"Numerics/Element degree", "2"},
      {"Mesh/Adaptive/Follow", "displacement"},
      {"Mesh/Adaptive/Target error", "0.2"},
      {"Mesh/Adaptive/Interval", "4"},
      {"Mesh/Adaptive/Largest number of divisions", "2"},
      {"Effects/Deformation", "large equilibrium"},
      {"Effects/Coupling", "expansion"},
      {"Numerics/Newton/Tolerance", "1e-12"}}},
    {"patch", {}},
    {"patch", {{"Numerics/Element degree", "2"}}}};

  std::string label(const std::string &scene, const std::vector<Override> &overrides)
  {
    std::string text = scene;
    for (const auto &given : overrides)
      text += ", " + given.path + " = " + given.value;
    return text;
  }

  Outcome on(const int n_processes, const std::string &scene, const std::vector<Override> &overrides)
  {
    const int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    MPI_Comm  part;
    MPI_Comm_split(MPI_COMM_WORLD, rank < n_processes ? 0 : MPI_UNDEFINED, rank, &part);
    Outcome outcome;
    if (part != MPI_COMM_NULL)
      {
        outcome = run(scene, overrides, part);
        MPI_Comm_free(&part);
      }
    MPI_Barrier(MPI_COMM_WORLD);
    return outcome;
  }
} // namespace

int main(int argc, char **argv)
{
  deal_II_exceptions::suppress_stacktrace_in_exceptions();
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                       speaks = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  Checks                           checks;
  try
    {
      for (const auto &[scene, overrides, tolerance] : cases)
        {
          const Outcome one = on(1, scene, overrides);
          for (const int n : {2, 3})
            {
              const Outcome other = on(n, scene, overrides);
              if (speaks)
                checks.holds("ran on " + std::to_string(n) + " processes",
                             other.summary.at("cost").at("processes") == n);
              if (speaks)
                checks.below("1 against " + std::to_string(n) + " processes: " + label(scene, overrides),
                             one.probes.empty() ? std::numeric_limits<double>::infinity() :
                                                  difference_by_column(one, other),
                             tolerance);
            }
        }
    }
  catch (const std::exception &exception)
    {
      std::cerr << exception.what() << std::endl;
      MPI_Abort(MPI_COMM_WORLD, 2);
    }
  return !speaks || checks.all_right() ? 0 : 1;
}
