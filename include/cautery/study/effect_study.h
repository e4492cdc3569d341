// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/study/outcome.h>

namespace Cautery
{
  /**
   * The variants of @p scene that leave out one effect each, or take a simpler one, and what else cannot stay
   * without it.
   */
  std::vector<Variant> without_effects(const Scene &scene);

  /**
   * Runs the scene and these variants below @p directory: what each effect changes in the answer, and what it
   * costs. Writes effects.md and effects.csv, and prints the table. Collective. Errors: ExcInput, ExcRun.
   */
  void study_effects(const Origin      &origin,
                     const Scene       &scene,
                     const std::string &directory,
                     const MPI_Comm     communicator);
} // namespace Cautery
