// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check.h"

#include <cautery/laws/heat_sources.h>

#include <cmath>
#include <iostream>

namespace Cautery::Test
{
  namespace
  {
    void test_schedule()
    {
      Schedule schedule;
      holds("on for ever by default", schedule.active(0.) && schedule.active(1e9));
      expect("whose share is 1", schedule.share(3., 4.), 1., 0.);

      read("set Switch on at = 1, 10\nset Switch off at = 5", schedule);
      holds("on from the switch on, off from the switch off",
            !schedule.active(0.) && schedule.active(1.) && schedule.active(4.999) && !schedule.active(5.) &&
              !schedule.active(9.999) && schedule.active(10.) && schedule.active(1e9));
      expect("a step within", schedule.share(2., 3.), 1., 0.);
      expect("a step outside", schedule.share(6., 7.), 0., 0.);
      expect("a step over a switch", schedule.share(4., 6.), 0.5, 0.);
      expect("a step over all of them", schedule.share(0., 20.), 14. / 20.);
      double on = 0., from = 0.;
      for (const double to : {0.3, 0.9, 1.7, 4.4, 8.1, 9.9, 10.2, 13.})
        {
          on += schedule.share(from, to) * (to - from);
          from = to;
        }
      expect("steps of whatever length add up to the time it is on", on, 4. + 3.);
      const std::vector<double> expected = {1., 5., 10.};
      holds("switching times rise", schedule.switching_times() == expected);
    }

    void test_refused_schedules()
    {
      const auto refused = [](const std::string &on, const std::string &off) {
        return refusal<Schedule>("set Switch on at = " + on + "\nset Switch off at = " + off);
      };
      expect("refused: more off than on",
             refused("0", "1, 2"),
             "Switch off at = 2 times: there must be as many as in `Switch on at`, or one fewer");
      expect("refused: two fewer", refused("0, 2, 4", "1").substr(0, 23), "Switch off at = 1 times");
      const std::string alternate = ": the times must alternate: on, off, on, off, ...";
      expect("refused: off before on", refused("5", "3"), "Switch off at = 3" + alternate);
      expect("refused: off when on", refused("5", "5"), "Switch off at = 5" + alternate);
      expect("refused: on again before off", refused("0, 2", "3, 4"), "Switch off at = 3" + alternate);
      expect("refused: times that fall", refused("4, 0", "5"), "Switch off at = 5" + alternate);
      expect("refused: before the start", refused("-1", "5"), "Switch on at = -1: it must be >= 0");
    }

    void test_gaussian()
    {
      GaussianSource source;
      source.centre = Point<3>(1e-3, -2e-3, 3e-3);
      source.radius = 0.5e-3;
      // equidistant points integrate a Gaussian to all digits
      const int    n        = 18;
      const double step     = source.radius / 2.;
      double       whole_3d = 0., whole_2d = 0.;
      for (int i = -n; i <= n; ++i)
        for (int j = -n; j <= n; ++j)
          {
            const Point<3> in_plane = source.centre + Point<3>(i * step, j * step, 0.);
            whole_2d += source.density(in_plane, 2) * step * step;
            for (int k = -n; k <= n; ++k)
              whole_3d += source.density(in_plane + Point<3>(0., 0., k * step), 3) * step * step * step;
          }
      expect("its integral over space is 1", whole_3d, 1.);
      expect("over the plane too", whole_2d, 1.);
      expect("at one radius it is down to exp(-1/2)",
             source.density(source.centre + Point<3>(0., source.radius, 0.), 3) /
               source.density(source.centre, 3),
             std::exp(-0.5));
    }

    /** Eq. 6-35 with Table 9's numbers at 1 W, computed by hand (r and z in mm; W/m3). */
    void test_antenna()
    {
      MicrowaveAntenna antenna;
      const auto       at = [&antenna](const double r_mm, const double z_mm) {
        return antenna.density(Point<3>(1e-3 * r_mm, 0., 1e-3 * z_mm), 3);
      };
      expect("Eq. 6-35 at r = 2 mm, z = 0", at(2., 0.), 212915.07538411007, 1e-12);
      expect("at r = 5 mm, z = 0", at(5., 0.), 37157.79433089176, 1e-12);
      expect("at r = 5 mm, z = z_0", at(5., 18.5), 13669.588613611848, 1e-12);
      expect("at r = 2 mm, z = -7 mm", at(2., -7.), 184513.6015429848, 1e-12);
      expect("within its own radius it stays the same", at(0.3, 2.), at(1., 2.), 1e-12);

      // 2 pi r q is the derivative of -2 pi C_t r^(2-n) exp(-2 rho r): compare with a midpoint rule in ln r
      const int    n     = 20000;
      const double first = std::log(1.), last = std::log(100.), width = (last - first) / n;
      double       per_length = 0.; // W/mm
      for (int i = 0; i < n; ++i)
        {
          const double r = std::exp(first + (i + 0.5) * width);
          per_length += 2. * numbers::PI * r * 1e-9 * at(r, 0.) * r * width;
        }
      const auto primitive = [](const double r) {
        return -2. * numbers::PI * 0.00316 * std::pow(r, -0.2) * std::exp(-2. * 0.0413 * r);
      };
      expect("power between 1 and 100 mm, per length", per_length, primitive(100.) - primitive(1.), 1e-7);

      MicrowaveAntenna turned = antenna;
      turned.axis             = Point<3>(0., 6., 8.);
      turned.centre           = Point<3>(0.1, 0.2, 0.3);
      const Tensor<1, 3> along({0., 0.6, 0.8}), across({0., 0.8, -0.6}), sideways({1., 0., 0.});
      for (const auto &direction : {across, sideways, Tensor<1, 3>((across - sideways) / std::sqrt(2.))})
        expect("moved, turned, with an axis of any length",
               turned.density(turned.centre + 5e-3 * direction - 18.5e-3 * along, 3),
               at(5., 18.5),
               1e-12);
    }

    void test_list()
    {
      expect(
        "all types", join(heat_source_types()), "points, uniform, Gaussian, microwave antenna, expression");
      for (const auto &type : heat_source_types())
        holds(
          "type `" + type + "` makes itself",
          std::visit([&type](const auto &source) { return type == source.type; }, make_heat_source(type)));
      expect("refused: a type that does not exist",
             message_of([]() { make_heat_source("laser"); }),
             "there is no heat source of type `laser`; choose one of: " + join(heat_source_types()));

      HeatSource needle{"needle", {}, make_heat_source("points")};
      read("set Places = 1, 2, 3; 4, 5, 6\nset Power = 2*t\nset Switch off at = 8", needle);
      expect("power in time", needle.amplitude(3.), 6.);
      expect("schedule of a source", needle.schedule.share(7., 9.), 0.5);
      expect("places of a source", std::get<PointSources>(needle.source).places.at(1)[0], 4.);
      expect("refused: points without places",
             refusal<PointSources>("set Power = 3"),
             "Places = : a point source needs at least one place");
      expect("refused: an axis without length",
             refusal<MicrowaveAntenna>("set Axis = 0, 0, 0"),
             "Axis = 0, 0, 0: a direction needs a length");
    }
  } // namespace

  void test_heat_sources()
  {
    std::cout << "Schedules\n";
    test_schedule();
    test_refused_schedules();
    std::cout << "Gaussian source\n";
    test_gaussian();
    std::cout << "Microwave antenna\n";
    test_antenna();
    std::cout << "List of sources\n";
    test_list();
  }
} // namespace Cautery::Test
