// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/scene.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * A scene's file, with what the command line changes in it: that from which a study makes its variants.
   */
  struct Origin
  {
    std::string           file_name;
    std::vector<Override> overrides;

    /** Errors: ExcInput where these @p changes do not fit the scene. */
    Scene scene(const std::vector<Override> &changes) const;
  };

  /**
   * The scene with some entries changed.
   */
  struct Variant
  {
    std::string           label; ///< for tables: what is special about it
    std::vector<Override> changes;
  };

  /**
   * "Section/Entry = value; Section/Entry = value".
   * Errors: ExcInput that begins with @p parameter.
   */
  std::vector<Override> parse_changes(const std::string &text, const std::string &parameter);

  /** The same text again. */
  std::string changes_text(const std::vector<Override> &changes);
} // namespace Cautery
