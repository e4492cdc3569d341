// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace Cautery
{
  /**
   * What @p work finds in a child process, which has a copy of all memory: for libraries that may break the
   * process they are in. Nothing where the child does not end well. It is silent, and signals that ask the
   * program to stop do not reach it. Errors: ExcRun where there can be no child.
   */
  std::optional<std::string> found_by_child(const std::function<std::string()> &work);
} // namespace Cautery
