// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/scene.h>

namespace Cautery
{
  /**
   * Whether the entries of a scene fit each other, as far as that needs no mesh.
   * Errors: ExcInput with the entries, their values and the remedy.
   */
  void check(const Scene &scene);
} // namespace Cautery
