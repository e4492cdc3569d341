// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/names.h>

#include <algorithm>
#include <set>

namespace Cautery
{
  std::string fault_of_names(const std::vector<std::string> &names)
  {
    const std::set<std::string> unique(names.begin(), names.end());
    if (unique.size() != names.size())
      return "a name stands twice; names must differ";
    if (unique.count("") > 0)
      return "a name is empty; write one between two commas";
    const auto breaks = [](const unsigned char letter) {
      return letter < 0x20 || letter == 0x7f || std::string("/\\\"`").find(letter) != std::string::npos;
    };
    for (const auto &name : names)
      if (std::any_of(name.begin(), name.end(), breaks))
        return "a name has a slash, backslash, quote or control character; leave it out";
    return "";
  }
} // namespace Cautery
