// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes with hanging nodes, and adapted in the course of a run: adaptive GROUP. Exit status 0 if all is
// right.
#include "chain.h"
#include "manufactured.h"
#include "run.h"

#include <cautery/problems/adaption.h>
#include <cautery/space/nodal_transfer.h>

#include <deal.II/base/mpi.h>

#include <set>

namespace
{
  using namespace Verification;

  /// Cells of a mesh of which a third is divided and all others are merged that can be: as irregular as it
  /// gets.
  std::vector<CellNumber> other_cells(const Mesh<3> &mesh, const unsigned int remainder)
  {
    std::vector<CellChange> changes(mesh.triangulation().n_active_cells(), CellChange::keep);
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const Point<3> centre = cell->center();
          const long     code   = std::lround(1000. * (centre[0] + 3. * centre[1] + 7. * centre[2]));
          changes[cell->active_cell_index()] =
            code % 3 == remainder ? CellChange::refine : CellChange::coarsen;
        }
    return mesh.cells_of_all(changes);
  }

  Scene unit_cube(const std::vector<Override> &effects,
                  const unsigned int           degree,
                  const std::vector<Override> &more = {})
  {
    auto overrides = effects;
    overrides.push_back({"Mesh/Cells", "hexahedra"});
    overrides.push_back({"Mesh/Subdivisions", "3"});
    overrides.push_back({"Numerics/Element degree", std::to_string(degree)});
    overrides.push_back({"Time/Step", "0.1"});
    overrides.push_back({"Time/End", "0.4"});
    overrides.insert(overrides.end(), more.begin(), more.end());
    Scene scene                = read_scene(VERIFICATION_SCENES "/manufactured.prm", overrides);
    scene.mesh.adaptive.follow = AdaptiveSettings::Follow::temperature; // the meshes here are chosen by hand
    return scene;
  }

  /// What is left of a solution at the end: all errors, against the exact one.
  std::vector<double> errors_on(const Scene &scene, const Body<3> &body, const Manufactured &exact)
  {
    Cost  cost;
    auto  problem = make_problem(scene, body, cost);
    State state   = problem->start();
    while (state.time < scene.time.end)
      problem->step(state, scene.time.end);
    problem->complete(state);
    std::vector<double> result;
    const auto          add = [&](const Errors &found) {
      result.push_back(found.l2);
      result.push_back(found.h1);
    };
    if (!exact.temperature.empty())
      add(errors(body.nodes, state.temperature, exact.temperature, scene.time.end));
    if (!exact.displacement.empty())
      add(errors(*problem->displacement(), state.displacement, exact.displacement, scene.time.end));
    return result;
  }

  /// Solutions that elements and steps hold exactly on any mesh.
  void exact_on_hanging_nodes(Checks                      &checks,
                              const std::string           &label,
                              const Manufactured          &exact,
                              const unsigned int           degree,
                              const std::vector<Override> &more,
                              const double                 tolerance)
  {
    const Scene   scene = unit_cube(exact.scene, degree, more);
    const Body<3> even(scene, MPI_COMM_WORLD);
    const Body<3> once(scene, Mesh<3>(even.mesh, other_cells(even.mesh, 0)));
    const Body<3> twice(scene, Mesh<3>(once.mesh, other_cells(once.mesh, 1)));
    checks.holds(label + ": " + std::to_string(twice.mesh.n_cells()) + " cells and " +
                   std::to_string(twice.nodes.hanging_nodes().n_constraints()) + " hanging nodes",
                 twice.nodes.hanging_nodes().n_constraints() > 50);
    const auto found = errors_on(scene, twice, exact);
    for (unsigned int i = 0; i < found.size(); ++i)
      checks.near(label + (i < 2 ? ", first" : ", second") + " field, error in " + (i % 2 == 0 ? "L2" : "H1"),
                  found[i],
                  0.,
                  tolerance);
  }

  void hanging(Checks &checks)
  {
    for (const Model model : {Model::fourier, Model::non_fourier})
      {
        for (const unsigned int degree : {1, 2})
          exact_on_hanging_nodes(
            checks, name(model) + ", degree " + std::to_string(degree), straight(model), degree, {}, 1e-9);
        exact_on_hanging_nodes(checks,
                               name(model) + ", IDA",
                               wave_in_time(model),
                               1,
                               {{"Time/Integrator", "IDA"},
                                {"Time/Relative tolerance", "1e-8"},
                                {"Time/Absolute tolerance", "1e-8"}},
                               3e-7);
      }
    for (const Model model : {Model::expansion, Model::two_way_fourier, Model::two_way_non_fourier})
      exact_on_hanging_nodes(checks, name(model), straight(model), 2, {}, 1e-9);
  }

  double nodal(const Point<3> &p, const unsigned int degree)
  {
    const double linear = 1. + p[0] - 2. * p[1] + 0.5 * p[0] * p[2] + p[0] * p[1] * p[2];
    return degree == 1 ? linear : linear + p[0] * p[0] - p[1] * p[1] * p[2] + 3. * p[2] * p[2];
  }

  /// look(node, its place), for the process's own nodes.
  template <typename Look>
  void for_each_node(const Field<3> &nodes, const Look &look)
  {
    std::vector<types::global_dof_index> dofs(nodes.element().n_dofs_per_cell());
    for (const auto &cell : nodes.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (nodes.owned().is_element(dofs[i]))
            look(dofs[i],
                 nodes.mapping().transform_unit_to_real_cell(cell, nodes.element().unit_support_point(i)));
      }
  }

  Cautery::Vector sampled(const Field<3> &nodes)
  {
    Cautery::Vector result = nodes.vector();
    for_each_node(nodes, [&](const types::global_dof_index node, const Point<3> &place) {
      result(node) = nodal(place, nodes.element().degree);
    });
    result.compress(VectorOperation::insert);
    return result;
  }

  /// As rough as damage is: hanging nodes do not follow their neighbours.
  double rough(const Point<3> &p) { return std::sin(1000. * (p[0] + 2. * p[1] + 3. * p[2])); }

  /// Places of nodes of all processes.
  class Places
  {
  public:
    void add(const Point<3> &place) { own.push_back(code(place)); }
    void gather()
    {
      for (const auto &part : Utilities::MPI::all_gather(MPI_COMM_WORLD, own))
        all.insert(part.begin(), part.end());
    }
    bool have(const Point<3> &place) const { return all.count(code(place)) > 0; }

  private:
    /// Nodes are more than a thousandth apart.
    static double code(const Point<3> &p)
    {
      return std::round(1e3 * p[0]) + 1e4 * std::round(1e3 * p[1]) + 1e8 * std::round(1e3 * p[2]);
    }
    std::vector<double> own;
    std::set<double>    all;
  };

  /// How far values move at nodes that both meshes have, but where some hang in the new one.
  double moved(const Body<3> &from, const Body<3> &to)
  {
    Cautery::Vector values = from.nodes.vector(), free = to.nodes.vector();
    free = 1.;
    to.nodes.hanging().clear(free);
    Places old, hanging;
    for_each_node(from.nodes, [&](const types::global_dof_index node, const Point<3> &place) {
      values(node) = rough(place);
      old.add(place);
    });
    values.compress(VectorOperation::insert);
    for_each_node(to.nodes, [&](const types::global_dof_index node, const Point<3> &place) {
      if (free(node) == 0.)
        hanging.add(place);
    });
    old.gather();
    hanging.gather();
    const auto   carried = NodalTransfer<3>(from.nodes, to.nodes)(values, from.nodes, to.nodes);
    double       largest = 0.;
    unsigned int n       = 0;
    for_each_node(to.nodes, [&](const types::global_dof_index node, const Point<3> &place) {
      if (!old.have(place) || hanging.have(place))
        return;
      ++n;
      largest = std::max(largest, std::abs(carried(node) - rough(place)));
    });
    AssertThrow(Utilities::MPI::sum(n, MPI_COMM_WORLD) > 0, ExcInternalError());
    return Utilities::MPI::max(largest, MPI_COMM_WORLD);
  }

  /// What the indicator makes of a uniform field that has been computed.
  double error_of_rounding(const Body<3> &body)
  {
    Cautery::Vector x = body.nodes.vector();
    double          i = 0.;
    for (double &value : x)
      value = 310. * (1. + 1e-15 * std::sin(++i));
    const GradientError error = gradient_error(body.nodes, body.tissues, body.nodes, x);
    return std::max<double>(error.relative(), error.cells.linfty_norm());
  }

  double difference(Cautery::Vector a, const Cautery::Vector &b)
  {
    a -= b;
    return a.linfty_norm();
  }

  /// Fields of the elements survive any division and merging; no damage anywhere stays so.
  void transfer(Checks &checks)
  {
    for (const unsigned int degree : {1, 2})
      {
        const Scene   scene = unit_cube({{"Effects/Heat", "Fourier"}}, degree);
        const Body<3> even(scene, MPI_COMM_WORLD);
        const Body<3> once(scene, Mesh<3>(even.mesh, other_cells(even.mesh, 0)));
        const Body<3> twice(scene, Mesh<3>(once.mesh, other_cells(once.mesh, 1)));
        const auto    label = "degree " + std::to_string(degree) + ", ";
        const auto    carry = [&](const Body<3> &from, const Body<3> &to, const Cautery::Vector &values) {
          return NodalTransfer<3>(from.nodes, to.nodes)(values, from.nodes, to.nodes);
        };
        const auto on_once  = carry(even, once, sampled(even.nodes));
        const auto on_twice = carry(once, twice, on_once);
        checks.near(label + "divided", difference(on_once, sampled(once.nodes)), 0., 1e-12);
        checks.near(label + "divided and merged", difference(on_twice, sampled(twice.nodes)), 0., 1e-12);
        checks.near(label + "old nodes keep their own", moved(once, twice), 0., 1e-12);
        checks.near(label + "error of a uniform field", error_of_rounding(once), 0., 0.);
        Cautery::Vector no_damage = once.nodes.vector();
        std::fill(no_damage.begin(), no_damage.end(), -std::numeric_limits<double>::infinity());
        const auto still_none = carry(once, twice, no_damage);
        checks.holds(label + "no damage stays none",
                     std::all_of(still_none.begin(), still_none.end(), [](const double value) {
                       return std::isinf(value) && value < 0.;
                     }));
      }
  }

  /// The largest error at the probes at the end, K.
  double at_probes(const Outcome &outcome, const Outcome &truth)
  {
    double largest = 0.;
    for (const std::string probe : {"tip", "half", "one", "diagonal"})
      largest =
        std::max(largest, std::abs(outcome.end(probe, "temperature_K") - truth.end(probe, "temperature_K")));
    return largest;
  }

  double unknowns(const Outcome &outcome) { return outcome.summary.at("unknowns").at("temperature"); }

  /// Against a uniform mesh of the finest cells that the adapted ones have.
  void needle(Checks &checks)
  {
    const auto uniform = [](const std::string &cells) {
      return run("octant", {{"Mesh/Subdivisions", cells}});
    };
    const auto adapted = [](const std::string &target, const std::string &interval) {
      return run("octant",
                 {{"Mesh/Adaptive/Follow", "temperature"},
                  {"Mesh/Adaptive/Target error", target},
                  {"Mesh/Adaptive/Interval", interval}});
    };
    const Outcome fine = uniform("40"), middle = uniform("20");
    const double  error_middle = at_probes(middle, fine);
    double        last         = std::numeric_limits<double>::infinity();
    for (const std::string target : {"0.2", "0.1", "0.05"})
      {
        const Outcome outcome = adapted(target, "2");
        const double  error   = at_probes(outcome, fine);
        checks.below(
          "target " + target + ", " + to_text(unknowns(outcome)) + " unknowns, error, K", error, last);
        checks.below(
          "target " + target + ", what is not accounted for", outcome.balance("relative_error"), 1e-8);
        last = error;
        if (target == "0.05")
          {
            checks.below("target 0.05, error over that of a uniform mesh", error / error_middle, 1.);
            checks.below("target 0.05, unknowns over its", unknowns(outcome) / unknowns(middle), 0.7);
          }
      }
  }
} // namespace

int main(int argc, char **argv)
{
  return run_group(argc, argv, {{"hanging", hanging}, {"transfer", transfer}, {"needle", needle}});
}
