// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/study/ladder.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  namespace
  {
    using Error = LadderSettings::Error;

    /// A mesh with more cells than this is not refined by a standard ladder.
    constexpr double largest_standard_mesh = 60000.;

    Ladder mesh_ladder(const Scene &scene)
    {
      Ladder ladder{"mesh", Error::space, 2., {}};
      if (scene.mesh.shape == MeshSettings::Shape::file)
        {
          for (const unsigned int more : {0, 1})
            {
              const std::string refinements = std::to_string(scene.mesh.refinements + more);
              ladder.rungs.push_back(
                {"refined " + refinements + " times", {{"Mesh/Refinements", refinements}}});
            }
          return ladder;
        }
      double cells = scene.mesh.cells == MeshSettings::Cells::tetrahedra ? 6. : 1.;
      for (unsigned int d = 0; d < scene.dimension; ++d)
        cells *= scene.mesh.subdivisions[d];
      const auto too_many = [&](const double factor) {
        return cells * std::pow(factor, scene.dimension) > largest_standard_mesh;
      };
      // three rungs or more, because fewer allow no extrapolation
      std::vector<double> factors = {0.5, 1.};
      if (too_many(2.))
        factors.insert(factors.begin(), 0.25);
      for (const double factor : {2., 4.})
        if (!too_many(factor))
          factors.push_back(factor);
      for (const double factor : factors)
        {
          std::vector<std::string> numbers;
          for (const double number : scene.mesh.subdivisions)
            numbers.push_back(to_text(std::max(1., std::round(factor * number))));
          ladder.rungs.push_back({join(numbers, " x "), {{"Mesh/Subdivisions", join(numbers)}}});
        }
      return ladder;
    }

    Ladder step_ladder(const Scene &scene)
    {
      Ladder ladder{"step", Error::time, 2., {}};
      for (const double factor : {4., 2., 1., 0.5})
        {
          const std::string step = to_text(factor * scene.time.step);
          ladder.rungs.push_back({step + " s", {{"Time/Step", step}}});
        }
      return ladder;
    }

    Ladder ida_ladder(const Scene &)
    {
      Ladder ladder{"IDA", Error::time, 10., {}};
      // a relative one, of rises of some 100 K, and the absolute one ten times that, K
      for (const auto &[relative, absolute] :
           {std::make_pair(1e-3, 1e-2), {1e-4, 1e-3}, {1e-5, 1e-4}, {1e-6, 1e-5}, {1e-7, 1e-6}})
        ladder.rungs.push_back({"tolerance " + to_text(relative),
                                {{"Time/Integrator", "IDA"},
                                 {"Time/Relative tolerance", to_text(relative)},
                                 {"Time/Absolute tolerance", to_text(absolute)}}});
      return ladder;
    }

    Ladder solver_ladder(const Scene &)
    {
      Ladder ladder{"solver", Error::solver, 1e3, {}};
      for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12})
        ladder.rungs.push_back({"margin " + to_text(tolerance),
                                {{"Numerics/Heat solver/Tolerance", to_text(tolerance)},
                                 {"Numerics/Deformation solver/Tolerance", to_text(tolerance)}}});
      return ladder;
    }

    Ladder comparison(const std::string                        &name,
                      const std::string                        &entry,
                      const std::vector<std::string>           &values,
                      const std::vector<std::vector<Override>> &also = {})
    {
      Ladder ladder{name, Error::none, 2., {}};
      for (unsigned int i = 0; i < values.size(); ++i)
        {
          ladder.rungs.push_back({values[i].empty() ? "off" : values[i], {{entry, values[i]}}});
          if (!also.empty())
            ladder.rungs.back().changes.insert(
              ladder.rungs.back().changes.end(), also[i].begin(), also[i].end());
        }
      return ladder;
    }

    using Maker = Ladder (*)(const Scene &);
    /// The one place where the standard ladders are listed.
    const std::vector<std::pair<std::string, Maker>> standard_ladders = {
      {"mesh", mesh_ladder},
      {"step", step_ladder},
      {"IDA", ida_ladder},
      {"solver", solver_ladder},
      {"degree",
       [](const Scene &) {
         return comparison("degree", "Numerics/Element degree", {"1", "2"});
       }},
      {"cells",
       [](const Scene &) {
         return comparison("cells", "Mesh/Cells", {"tetrahedra", "hexahedra"});
       }},
      {"method",
       [](const Scene &) {
         return comparison("method",
                           "Numerics/Method",
                           {"finite differences", "finite elements"},
                           {{{"Mesh/Cells", "hexahedra"}}, {{"Mesh/Cells", "hexahedra"}}});
       }},
      {"precision",
       [](const Scene &) {
         return comparison("precision", "Numerics/Explicit/Precision", {"single", "double"});
       }},
      {"condensation", [](const Scene &) {
         return comparison("condensation", "Numerics/Kept nodes", {"inside", ""});
       }}};

    /// What a standard ladder would vary must count for something in the scene.
    bool concerns(const std::string &name, const Scene &scene)
    {
      const bool box      = scene.mesh.shape == MeshSettings::Shape::box;
      const bool implicit = !scene.has_explicit_loop();
      if (name == "cells")
        return box;
      if (name == "method")
        return box && implicit;
      if (name == "precision")
        return scene.has_explicit_loop();
      if (name == "step")
        return scene.time.integrator != TimeSettings::Integrator::ida;
      if (name == "IDA")
        return scene.effects.has_heat();
      return implicit || name == "mesh";
    }

    Ladder standard_ladder(const std::string &name, const Scene &scene)
    {
      for (const auto &[known, make] : standard_ladders)
        if (known == name)
          return make(scene);
      AssertThrow(false,
                  ExcInput("Accuracy/Names: `" + name + "` is no standard ladder (" +
                           join(standard_ladder_names()) + "); give Accuracy/" + name +
                           "/Entries and Rungs, or take one of these"));
      return {};
    }

    Ladder own_ladder(const LadderSettings &settings)
    {
      Ladder     ladder{settings.name, settings.error, settings.ratio, {}};
      const auto path = "Accuracy/" + settings.name + "/Rungs";
      for (const auto &rung : Utilities::split_string_list(settings.rungs, '|'))
        {
          const auto values = Utilities::split_string_list(rung, ';');
          AssertThrow(values.size() == settings.entries.size(),
                      ExcInput(path + " = " + settings.rungs + ": `" + rung + "` has " +
                               std::to_string(values.size()) + " values for " +
                               std::to_string(settings.entries.size()) +
                               " Entries; separate the values of a rung by `;`"));
          ladder.rungs.push_back({rung, {}});
          for (unsigned int i = 0; i < values.size(); ++i)
            ladder.rungs.back().changes.push_back({settings.entries[i], values[i]});
        }
      return ladder;
    }

    void multiply(Ladder &ladder, const Ladder &other)
    {
      std::vector<Variant> rungs;
      for (const auto &rung : ladder.rungs)
        for (const auto &more : other.rungs)
          {
            rungs.push_back({rung.label + ", " + more.label, rung.changes});
            rungs.back().changes.insert(rungs.back().changes.end(), more.changes.begin(), more.changes.end());
          }
      ladder.rungs = rungs;
      ladder.error = Error::none;
    }

    /// Without `times`, which needs the others.
    Ladder simple_ladder(const LadderSettings &settings, const Scene &scene)
    {
      Ladder ladder = settings.entries.empty() ? standard_ladder(settings.name, scene) : own_ladder(settings);
      const auto with = parse_changes(settings.with, "Accuracy/" + settings.name + "/With");
      for (auto &rung : ladder.rungs)
        rung.changes.insert(rung.changes.end(), with.begin(), with.end());
      return ladder;
    }

    void check_rungs(const Origin &origin, const Ladder &ladder)
    {
      for (const auto &rung : ladder.rungs)
        try
          {
            origin.scene(rung.changes);
          }
        catch (const ExcInput &exception)
          {
            AssertThrow(false,
                        ExcInput("the ladder `" + ladder.name + "`, rung `" + rung.label +
                                 "`: " + message_of(exception)));
          }
    }

    std::vector<Ladder>
    fitting_ladders(const Origin &origin, const Scene &scene, std::vector<std::string> &left_out)
    {
      std::vector<Ladder> ladders;
      for (const auto &[name, make] : standard_ladders)
        if (concerns(name, scene))
          try
            {
              const Ladder ladder = make(scene);
              check_rungs(origin, ladder);
              ladders.push_back(ladder);
            }
          catch (const ExcInput &exception)
            {
              left_out.push_back(message_of(exception));
            }
      return ladders;
    }
  } // namespace

  std::vector<std::string> standard_ladder_names()
  {
    std::vector<std::string> names;
    for (const auto &ladder : standard_ladders)
      names.push_back(ladder.first);
    return names;
  }

  std::vector<Ladder>
  make_ladders(const Origin &origin, const Scene &scene, std::vector<std::string> &left_out)
  {
    const auto &wanted = scene.accuracy.ladders;
    if (wanted.empty())
      return fitting_ladders(origin, scene, left_out);
    std::vector<Ladder> ladders;
    for (const auto &settings : wanted)
      {
        ladders.push_back(simple_ladder(settings, scene));
        if (!settings.times.empty())
          {
            const auto other = std::find_if(wanted.begin(), wanted.end(), [&](const LadderSettings &ladder) {
              return ladder.name == settings.times;
            });
            multiply(ladders.back(),
                     other == wanted.end() ? standard_ladder(settings.times, scene) :
                                             simple_ladder(*other, scene));
          }
        check_rungs(origin, ladders.back());
      }
    return ladders;
  }
} // namespace Cautery
