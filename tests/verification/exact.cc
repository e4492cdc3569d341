// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole runs against exact solutions: exact GROUP. Exit status 0 if all is right.
#include "chain.h"

int main(int argc, char **argv)
{
  using namespace Verification;
  return run_group(argc,
                   argv,
                   {{"heat", heat},
                    {"waves", waves},
                    {"damage", damage},
                    {"deformation", deformation},
                    {"motion", motion},
                    {"balance", balance},
                    {"stencils", stencils},
                    {"condensation", condensation},
                    {"time_errors", time_errors}});
}
