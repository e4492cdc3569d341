// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/scene.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * A scene's text with its overrides. Which entries exist depends on other entries (a subsection for each
   * name, entries by a source's type), so these are peeked at before everything is declared.
   */
  class SceneText
  {
  public:
    /** Errors: ExcInput for a file that cannot be read or includes another, or an entry that stands twice. */
    SceneText(const std::string &file_name, const std::vector<Override> &overrides);

    /** Gives the values to @p handler, the overrides last. Errors: ExcInput with file, line or override. */
    void parse(ParameterHandler &handler, const bool skip_undefined) const;

    /** The value of one entry. */
    std::string peek(const std::vector<std::string> &sections,
                     const std::string              &name,
                     const std::string              &default_value) const;

    /** An entry that is a list of names. Errors: ExcInput for names that cannot be, see fault_of_names. */
    std::vector<std::string> peek_names(const std::vector<std::string> &sections,
                                        const std::string              &name,
                                        const std::string              &default_names) const;

  private:
    void refuse_doubled_entries_and_included_files() const;

    const std::string           file_name;
    const std::vector<Override> overrides;
    std::string                 text;
  };
} // namespace Cautery
