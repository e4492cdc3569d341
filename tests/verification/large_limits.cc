// SPDX-License-Identifier: LGPL-2.1-or-later
#include "large.h"

namespace Verification
{
  namespace
  {
    const std::vector<Override> pulled_up   = {{"Boundaries/x1/Mechanical", "traction"},
                                               {"Boundaries/x1/Traction", "1e-4*y; 2e-4; 0"},
                                               {"Boundaries/y1/Mechanical", "displacement"},
                                               {"Boundaries/y1/Displacement", "1e-8*x*z; 2e-8; 0"},
                                               {"Effects/Gravity", "on"},
                                               {"Loads/Gravity", "1e-8, -2e-8, -3e-7"},
                                               {"Loads/Names", "pull"},
                                               {"Loads/pull/Place", "0.9, 0.2, 1"},
                                               {"Loads/pull/Force", "1e-5; 0; 2e-5"}};
    const std::vector<Override> barely_warm = {{"Effects/Heat", "Fourier"},
                                               {"Effects/Coupling", "expansion"},
                                               {"Initial state/Temperature", "310.0001"}};

    void small_loads(Checks &checks)
    {
      for (const auto &element : elements)
        for (const auto &law : {laws[0], laws[1]})
          for (const bool heated : {false, true})
            {
              const auto mesh = bent_cube(element);
              const auto all =
                joined({mesh, law.overrides, pulled_up, heated ? barely_warm : std::vector<Override>()});
              const Outcome large = run("large", all);
              const Outcome small = run("large",
                                        joined({all,
                                                {{"Effects/Deformation", "equilibrium"},
                                                 {"Numerics/Deformation solver/Tolerance", "1e-12"}}}));
              checks.holds("it moves", std::abs(small.end("inside", "displacement_y_m")) > 1e-10);
              checks.below(element.name + ", " + law.name + (heated ? ", heated" : "") +
                             ": small loads against linear elasticity",
                           difference(large, small),
                           1e-6);
            }
    }

    /// exp(int alpha dT) is a stretch by 1.35 here.
    void free_expansion(Checks &checks)
    {
      const double stretch = std::exp(0.01 * 30.);
      for (const auto &element : elements)
        {
          const Outcome     outcome = run("large",
                                      joined({bent_cube(element),
                                                  laws.back().overrides,
                                                  heats.back().overrides,
                                                  {{"Tissues/tissue/Thermal expansion coefficient", "0.01"}}}));
          const std::string what    = element.name + ", free expansion: ";
          checks.near(
            what + "u_x, m", outcome.end("inside", "displacement_x_m"), 0.31 * (stretch - 1.), 1e-10);
          checks.near(
            what + "u_z, m", outcome.end("inside", "displacement_z_m"), 0.73 * (stretch - 1.), 1e-10);
          checks.near(
            what + "Green strain", outcome.end("inside", "strain_yy"), 0.5 * (stretch * stretch - 1.), 1e-10);
          checks.near(what + "stress, Pa", outcome.end("inside", "stress_xx_Pa"), 0., 1e-7);
        }
    }

    /// The same body in two positions, so that rollers are inclined in one.
    void inclined_rollers(Checks &checks)
    {
      const double       c = std::cos(0.5), s = std::sin(0.5), d = std::cos(0.3), e = std::sin(0.3);
      const Tensor<2, 3> turn = Tensor<2, 3>({{c, -s, 0.}, {s, c, 0.}, {0., 0., 1.}}) *
                                Tensor<2, 3>({{1., 0., 0.}, {0., d, -e}, {0., e, d}});
      const auto text = [](const Tensor<1, 3> &v, const std::string &separator) {
        std::ostringstream stream;
        stream << std::setprecision(17) << v[0] << separator << v[1] << separator << v[2];
        return stream.str();
      };
      const Tensor<1, 3> place({0.31, 0.52, 0.73}), corner({1., 1., 1.}), traction({500., 0., 0.});
      for (const auto &element : elements)
        {
          Tensor<1, 3> moved[2];
          for (const bool turned : {false, true})
            {
              const Tensor<2, 3> rotation = turned ? turn : unit_symmetric_tensor<3>();
              const Outcome      outcome =
                run("large",
                    joined({bent_cube(element, rotation),
                            laws[1].overrides,
                            {{"Boundaries/x1/Mechanical", "traction"},
                             {"Boundaries/x1/Traction", text(rotation * traction, "; ")},
                             {"Output/Probe names", "inside"},
                             {"Output/Probe places", text(rotation * place, ", ")}}}));
              for (unsigned int i = 0; i < 3; ++i)
                moved[turned][i] = outcome.end("inside", std::string("displacement_") + "xyz"[i] + "_m");
            }
          checks.holds("it is stretched", moved[0][0] > 0.03);
          checks.below(element.name + ": inclined rollers, displacement turned back, m",
                       (transpose(turn) * moved[1] - moved[0]).norm(),
                       1e-10);
        }
    }

    /// A clamped block whose far side is pulled away sidewards by its own length: at once, which takes steps
    /// of the load, and little by little.
    void load_steps(Checks &checks)
    {
      const std::vector<Override> clamped = {{"Boundaries/x0/Mechanical", "fixed"},
                                             {"Boundaries/y0/Mechanical", "free"},
                                             {"Boundaries/z0/Mechanical", "free"},
                                             {"Boundaries/x1/Mechanical", "traction"},
                                             {"Tissues/tissue/Poisson's ratio", "0.49"}};
      for (const auto &element : {elements[2], elements[3]})
        {
          const auto    all     = joined({bent_cube(element), laws[2].overrides, clamped});
          const Outcome at_once = run("large", joined({all, {{"Boundaries/x1/Traction", "6000; 0; 9000"}}}));
          const Outcome slowly =
            run("large",
                joined({all,
                        {{"Boundaries/x1/Traction", "6000*t; 0; 9000*t"},
                         {"Output/Times", "0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9"}}}));
          // the first equilibrium, and the second, which the first already is
          checks.holds(element.name + ", far at once: the load is taken in steps",
                       at_once.summary.at("statistics").at("load_steps") > 2.);
          for (const std::string column : {"displacement_x_m", "displacement_z_m"})
            checks.near(element.name + ", at once and little by little: " + column,
                        at_once.end("corner", column),
                        slowly.end("corner", column),
                        1e-9);
          checks.holds(element.name + ", far at once: that is far",
                       at_once.end("corner", "displacement_z_m") > 1.);
        }
    }

    /// A body that is turned by 97 degrees at once feels no stress; one that is turned inside out is
    /// refused.
    void extremes(Checks &checks)
    {
      const auto everywhere = [](const std::string &displacement) {
        std::vector<Override> result;
        for (const std::string face : {"x0", "y0", "z0", "x1", "y1", "z1"})
          {
            result.push_back({"Boundaries/" + face + "/Mechanical", "displacement"});
            result.push_back({"Boundaries/" + face + "/Displacement", displacement});
          }
        return result;
      };
      const std::string turn = "(cos(1.7)-1)*x - sin(1.7)*y; sin(1.7)*x + (cos(1.7)-1)*y; 0*x";
      for (const auto &element : elements)
        checks.near(element.name + ", turned by 97 degrees: stress, Pa",
                    run("large", joined({bent_cube(element), laws.back().overrides, everywhere(turn)}))
                      .end("inside", "stress_xx_Pa"),
                    0.,
                    1e-7);
      std::string message = "ACCEPTED";
      try
        {
          std::ostringstream hidden;
          auto *const        screen = std::cout.rdbuf(hidden.rdbuf());
          const auto         scene  = read_scene(VERIFICATION_SCENES "/large.prm",
                                        joined({bent_cube(elements[0]), everywhere("-1.2*x; 0*x; 0*x")}));
          try
            {
              Simulation<3>(scene, MPI_COMM_SELF).run("refused");
            }
          catch (...)
            {
              std::cout.rdbuf(screen);
              throw;
            }
          std::cout.rdbuf(screen);
        }
      catch (const ExcRun &exception)
        {
          message = message_of(exception);
        }
      std::cout << "    " << message << '\n';
      checks.holds("turned inside out: the message names a cell",
                   message.find("no equilibrium found at t = 0 s beyond 83") != std::string::npos &&
                     message.find("is turned inside out") != std::string::npos);
    }
  } // namespace

  void limits(Checks &checks)
  {
    small_loads(checks);
    free_expansion(checks);
    inclined_rollers(checks);
    load_steps(checks);
    extremes(checks);
  }
} // namespace Verification
