// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check.h"

#include <cautery/scene/scene.h>

#include <fstream>
#include <iostream>

namespace Cautery::Test
{
  namespace
  {
    Scene scene_of(const std::string &text, const std::vector<Override> &overrides = {})
    {
      std::ofstream("scene_under_test.prm") << text;
      return read_scene("scene_under_test.prm", overrides);
    }

    const std::string ten_lines = R"(
subsection Boundaries
  subsection outside
    set Thermal = insulated
  end
end
subsection Heat sources
  set Names = needle, spot
  subsection spot
    set Type = Gaussian
  end
  subsection needle
    set Places = 0.005, 0.005, 0.005
  end
end
)";

    void test_defaults()
    {
      const Scene scene = scene_of(ten_lines);
      expect("default tissue", scene.tissues.at(0).thermal.conductivity.value(310.), 0.613);
      expect("default end", scene.time.end, 120.);
      holds("types of the sources",
            std::holds_alternative<PointSources>(scene.heat_sources.at(0).source) &&
              std::holds_alternative<GaussianSource>(scene.heat_sources.at(1).source));
      expect("effects that are on", join(scene.effects.on()), "heat: Fourier, heat sources");
      expect("effects that are off",
             join(scene.effects.off()),
             "conduction in the deformed body, perfusion, perfusion stops in dead tissue, metabolism, "
             "deformation, "
             "coupling, gravity, "
             "temperature-dependent properties, damage");
    }

    void test_overrides()
    {
      const Scene scene = scene_of(ten_lines,
                                   {{"Time/End", "7"},
                                    {"Boundaries/Names", "outside, top"},
                                    {"Boundaries/top/Surfaces", "z max"},
                                    {"Boundaries/top/Thermal", "convection"},
                                    {"Heat sources/spot/Power", "3*t"},
                                    {"Time/End", "8"}});
      expect("the last of two overrides counts", scene.time.end, 8., 0.);
      expect("a name that only an override gives", scene.boundaries.at(1).name, "top");
      holds("its entries", scene.boundaries.at(1).thermal == Boundary::Thermal::convection);
      expect("an expression", scene.heat_sources.at(1).amplitude(2.), 6.);
    }

    void test_complete_text()
    {
      const Scene first =
        scene_of(ten_lines, {{"Tissues/tissue/Preset", "thesis type II"}, {"Time/Step", "0.1"}});
      const Scene second = scene_of(first.complete_text);
      expect("a complete scene reads back as itself", second.complete_text, first.complete_text);
      expect("with the values of its preset", second.tissues.at(0).elastic.poissons_ratio, 0.49, 0.);
      expect("and its own", second.time.step, 0.1, 0.);
      expect("the reference differs from a scene only in what it must",
             message_of([]() { scene_of(parameter_reference()); }),
             "scene_under_test.prm: Heat sources/points/Places = : a point source needs at least one place");
    }

    void test_output_times()
    {
      OutputSettings output;
      output.interval                    = 0.1;
      output.times                       = {0.25, 0.3};
      const std::vector<double> expected = {0.1, 0.2, 0.25, 0.3, 0.35};
      const auto                times    = output.output_times(0.35);
      bool                      same     = times.size() == expected.size();
      for (unsigned int i = 0; same && i < expected.size(); ++i)
        same = std::abs(times[i] - expected[i]) < 1e-15;
      holds("interval and times together, each once, and the end", same);
    }
  } // namespace

  void test_scene()
  {
    std::cout << "Scenes\n";
    test_defaults();
    test_overrides();
    test_complete_text();
    test_output_times();
  }
} // namespace Cautery::Test
