// SPDX-License-Identifier: LGPL-2.1-or-later
// The step that is known to be stable is, the one 1.3 times as long is not, and the thesis's L / c (Eq. 7-55)
// may lie far beyond both. Usage: stable_steps SCENE [resonates] [ENTRY=VALUE ...]; 77 where
// the scene's mesh is absent.
#include <cautery/physics/critical_step.h>
#include <cautery/problems/body.h>

#include <filesystem>
#include <iostream>
#include <random>

namespace Verification
{
  using namespace Cautery;

  class FreeMotion
  {
  public:
    explicit FreeMotion(const Scene &scene)
      : scene(scene)
      , body(this->scene, MPI_COMM_WORLD)
      , nodes(body.nodes)
      , cells(this->scene, body.nodes, body.tissues, nodes)
      , mass(nodes.sum(cells.masses()))
      , start(nodes.zero())
    {
      std::mt19937                     generator(1);
      std::uniform_real_distribution<> number(-1., 1.);
      for (unsigned int node = 0; node < nodes.n_own(); ++node)
        for (unsigned int c = 0; c < 3; ++c)
          start[node_record * node + c] = number(generator);
    }

    /** What the program takes for it where all is @p stretch longer, 1/s2. */
    template <typename Number>
    double bound(const double stretch = 0.) const
    {
      TledNodes<Number>    records(body.nodes);
      TledBody<Number>     loops(scene, body.nodes, body.tissues, records);
      CriticalStep<Number> critical(loops, records, TledBody<Number>::Part::motion, mass);
      auto                 values = records.zero();
      for (unsigned int node = 0; node < records.n_all(); ++node)
        for (unsigned int c = 0; c < 3; ++c)
          values[node_record * node + c] = stretch * records.places()[node][c];
      return critical.largest_eigenvalue(values);
    }

    double steady_share() const
    {
      TledNodes<double> records(body.nodes);
      TledBody<double>  loops(scene, body.nodes, body.tissues, records);
      return CriticalStep<double>(loops, records, TledBody<double>::Part::motion, mass).steady_share();
    }

    /** The largest eigenvalue of M^-1 K, all fibres being taut, by the power method: from below, 1/s2. */
    double largest_eigenvalue()
    {
      const double small      = 1e-7 * smallest_edge(); // keeps the body in its linear range
      Records      v          = start;
      double       eigenvalue = 0.;
      for (unsigned int i = 0; i < 1500; ++i)
        {
          const double size = std::sqrt(product(v, v));
          for (double &entry : v)
            entry /= size;
          Records w  = accelerations(v, small, Cells::SlackFibres::as_if_taut);
          eigenvalue = product(v, w);
          v          = w;
        }
      return eigenvalue;
    }

    /** How much larger the motion is after 3000 steps of @p duration (s) than at first. */
    double growth(const double duration)
    {
      const double small = 1e-6 * smallest_edge();
      Records      u = start, v = nodes.zero();
      for (double &entry : u)
        entry *= small;
      const double first = product(u, u);
      for (unsigned int i = 0; i < 3000; ++i)
        {
          const Records a = accelerations(u, 1., Cells::SlackFibres::as_they_are);
          for (unsigned int k = 0; k < u.size(); ++k)
            {
              v[k] -= duration * a[k];
              u[k] += duration * v[k];
            }
          if (!(product(u, u) < 1e6 * first))
            break;
        }
      return std::sqrt(product(u, u) / first);
    }

    /** L / c with the shortest edge (Eqs. 7-54 and 7-55), s. */
    double thesis_step() const
    {
      double slowest = std::numeric_limits<double>::max();
      for (unsigned int t = 0; t < body.tissues.size(); ++t)
        {
          const Tissue &tissue = body.tissues.tissue(t);
          const Lame    lame   = tissue.elastic.lame(310.);
          slowest = std::min(slowest, std::sqrt(tissue.thermal.density / (lame.lambda + 2. * lame.mu)));
        }
      return slowest * smallest_edge();
    }

  private:
    using Records = TledNodes<double>::Records;
    using Cells   = TledBody<double>;

    /** M^-1 times the forces at @p size @p v, over @p size. */
    Records accelerations(const Records &v, const double size, const Cells::SlackFibres slack)
    {
      Records values = v, forces = nodes.zero();
      for (double &entry : values)
        entry *= size;
      cells.add_forces(Cells::Part::motion, values, forces, slack);
      for (unsigned int k = 0; k < forces.size(); ++k)
        forces[k] /= size * mass[k / node_record];
      return forces;
    }

    double product(const Records &a, const Records &b) const
    {
      double sum = 0.;
      for (unsigned int k = 0; k < a.size(); ++k)
        sum += mass[k / node_record] * a[k] * b[k];
      return sum;
    }

    double smallest_edge() const
    {
      if (edge == 0.)
        {
          edge = std::numeric_limits<double>::max();
          for (const auto &cell : body.nodes.dof_handler().active_cell_iterators())
            for (unsigned int line = 0; line < cell->n_lines(); ++line)
              edge = std::min(edge, cell->line(line)->diameter());
        }
      return edge;
    }

    const Scene         scene;
    Body<3>             body;
    TledNodes<double>   nodes;
    TledBody<double>    cells;
    std::vector<double> mass;
    Records             start;
    mutable double      edge = 0.;
  };

  /** @p resonates: the motion is not steady at 0.9 of the stable step, because fibres buckle. */
  int check(const Scene &scene, const bool resonates)
  {
    FreeMotion   motion(scene);
    const double bound  = 2. / std::sqrt(motion.bound<double>());
    const double single = 2. / std::sqrt(motion.bound<float>());
    // fibres that are slack at the moment count: a moment later they may not be
    const double slack = 2. / std::sqrt(motion.bound<double>(-1e-4));
    const double limit = 2. / std::sqrt(motion.largest_eigenvalue());
    const double share = std::min(0.95, motion.steady_share());
    const double below = motion.growth(share * bound), above = motion.growth(1.02 * limit);
    std::cout << "stable step " << bound << " s, in single precision " << single << " s, true limit " << limit
              << " s (" << limit / bound << " times), fibres slack " << slack << " s, L/c "
              << motion.thesis_step() << " s (" << motion.thesis_step() / limit
              << " times the limit)\ngrowth at " << share << " of the stable step " << below
              << ", at 1.02 of the limit " << above << '\n';
    bool good = std::abs(single / bound - 1.) < 0.02 && std::abs(slack / bound - 1.) < 0.01 &&
                limit >= bound && limit <= 1.3 * bound && below < 10. && above > 100.;
    if (resonates)
      {
        const double between = motion.growth(0.9 * bound);
        std::cout << "growth at 0.9 " << between << '\n';
        good = good && between > 100.;
      }
    std::cout << (good ? "ok\n" : "BAD\n");
    return good ? 0 : 1;
  }
} // namespace Verification

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::vector<Cautery::Override>           overrides;
  bool                                     resonates = false;
  for (int i = 2; i < argc; ++i)
    {
      const std::string text(argv[i]);
      if (text == "resonates")
        {
          resonates = true;
          continue;
        }
      overrides.push_back({text.substr(0, text.find('=')), text.substr(text.find('=') + 1)});
    }
  const auto scene = Cautery::read_scene(argv[1], overrides);
  if (!scene.mesh.file_name.empty() && !std::filesystem::exists(scene.mesh.file_name))
    {
      std::cout << "skipped: no mesh " << std::filesystem::path(scene.mesh.file_name).filename() << '\n';
      return 77;
    }
  return Verification::check(scene, resonates);
}
