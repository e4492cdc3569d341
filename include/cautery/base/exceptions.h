// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/exceptions.h>

#include <string>

namespace Cautery
{
  using namespace dealii;

  /**
   * The user's input is wrong: the program ends with exit status 2. The message names the parameter, the
   * value and the remedy.
   */
  DeclException1(ExcInput, std::string, << arg1);

  /**
   * The run failed numerically: exit status 1.
   */
  DeclException1(ExcRun, std::string, << arg1);

  /** What @p exception says: of deal.II's, which ours are too, without the place in the source. */
  std::string message_of(const std::exception &exception);
} // namespace Cautery
