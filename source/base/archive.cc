// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/archive.h>
#include <cautery/base/parameters.h>

namespace Cautery
{
  Archive::Entry &Archive::entry(const std::string &name, const Kind kind)
  {
    const std::string path = prefix + name;
    if (!restoring)
      {
        const auto [place, is_new] = all.insert({path, Entry{kind, {}}});
        Assert(is_new, ExcMessage("`" + path + "` is stored twice."));
        (void)is_new;
        return place->second;
      }
    const auto place = all.find(path);
    AssertThrow(place != all.end() && place->second.kind == kind,
                ExcInput("the checkpoint has no entry `" + path + "`; was it written by another program?"));
    return place->second;
  }

  void Archive::check_size(const std::string &name, const std::size_t stored, const std::size_t wanted) const
  {
    AssertThrow(stored == wanted,
                ExcInput("the checkpoint's entry `" + prefix + name + "` has " + std::to_string(stored) +
                         " numbers in the place of " + std::to_string(wanted)));
  }

  void Archive::shared(const std::string &name, std::vector<double> &values)
  {
    Entry &found                         = entry(name, Kind::shared);
    (restoring ? values : found.numbers) = restoring ? found.numbers : values;
  }

  bool Archive::own(const std::string &name, std::vector<double> &values)
  {
    if (restoring && all.count(prefix + name) == 0)
      return false;
    Entry &found                         = entry(name, Kind::own);
    (restoring ? values : found.numbers) = restoring ? found.numbers : values;
    return true;
  }
} // namespace Cautery
