// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/study/variant.h>

#include <deal.II/base/utilities.h>

namespace Cautery
{
  Scene Origin::scene(const std::vector<Override> &changes) const
  {
    auto all = overrides;
    all.insert(all.end(), changes.begin(), changes.end());
    return read_scene(file_name, all);
  }

  std::vector<Override> parse_changes(const std::string &text, const std::string &parameter)
  {
    std::vector<Override> changes;
    for (const auto &part : Utilities::split_string_list(text, ';'))
      changes.push_back(
        parse_override(part, parameter + " = " + text + ": write `Section/Entry = value; ...`"));
    return changes;
  }

  std::string changes_text(const std::vector<Override> &changes)
  {
    std::vector<std::string> texts;
    for (const auto &change : changes)
      texts.push_back(change.path + " = " + change.value);
    return join(texts, "; ");
  }
} // namespace Cautery
