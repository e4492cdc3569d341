// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/grid/tria.h>

namespace Cautery
{
  using namespace dealii;

  /**
   * Cuts @p mesh into @p n parts by METIS: the subdomain ids of its cells. METIS takes SIGTERM for an error
   * of its own and leaves by a long jump, wherever it is; so a child does it, which no signal reaches.
   * Errors: ExcRun.
   */
  template <int dim>
  void partition(Triangulation<dim> &mesh, const unsigned int n);
} // namespace Cautery
