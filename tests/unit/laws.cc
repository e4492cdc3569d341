// SPDX-License-Identifier: LGPL-2.1-or-later
// Every law and every kind of entry by itself, without a mesh, against closed forms and hand-made numbers.
#include "laws/check.h"

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iostream>

namespace Cautery::Test
{
  namespace
  {
    unsigned int bad = 0;

    void report(const std::string &what, const bool good, const std::string &details)
    {
      bad += !good;
      std::cout << (good ? "  ok  " + what : "  BAD " + what + ": " + details) << std::endl;
    }
  } // namespace

  void expect(const std::string &what, const double value, const double expected, const double tolerance)
  {
    const double scale = expected == 0. ? 1. : std::abs(expected);
    const bool   same  = value == expected || std::abs(value - expected) <= tolerance * scale;
    report(what, same, to_text(value) + " instead of " + to_text(expected));
  }

  void expect(const std::string &what, const std::string &value, const std::string &expected)
  {
    report(what, value == expected, "`" + value + "` instead of `" + expected + "`");
  }

  void holds(const std::string &what, const bool truth) { report(what, truth, "false"); }

  unsigned int failures() { return bad; }
} // namespace Cautery::Test

int main(int argc, char **argv)
{
  using namespace Cautery::Test;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
  test_expressions();
  test_parameters();
  test_scene();
  test_heat_sources();
  test_tissue();
  test_damage();
  test_large_deformation();
  return failures() == 0 ? 0 : 1;
}
