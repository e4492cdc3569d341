// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * Why @p names cannot name the parts of a scene, or "". They must differ, and stand as they are in paths of
   * entries (`Section/Name/Entry`) and in fields of .csv files.
   */
  std::string fault_of_names(const std::vector<std::string> &names);
} // namespace Cautery
