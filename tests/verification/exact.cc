// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole runs against exact solutions: exact GROUP. Exit status 0 if all is right.
#include "chain.h"

int main(int argc, char **argv)
{
  using namespace Verification;
  const std::map<std::string, std::function<void(Checks &)>> groups = {{"heat", heat},
                                                                       {"waves", waves},
                                                                       {"damage", damage},
                                                                       {"deformation", deformation},
                                                                       {"motion", motion},
                                                                       {"balance", balance}};
  deal_II_exceptions::suppress_stacktrace_in_exceptions();
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Checks                           checks;
  try
    {
      groups.at(argc > 1 ? argv[1] : "")(checks);
    }
  catch (const std::exception &exception)
    {
      std::cerr << exception.what() << std::endl;
      return 2;
    }
  return checks.all_right() ? 0 : 1;
}
