// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/names.h>
#include <cautery/scene/scene_text.h>

#include <deal.II/base/utilities.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace Cautery
{
  namespace
  {
    using Path = std::vector<std::string>;

    std::string override_text(const Override &given)
    {
      const auto  parts = Utilities::split_string_list(given.path, '/');
      std::string text;
      for (unsigned int i = 0; i + 1 < parts.size(); ++i)
        text += "subsection " + parts[i] + "\n";
      text += "set " + parts.back() + " = " + given.value + "\n";
      for (unsigned int i = 0; i + 1 < parts.size(); ++i)
        text += "end\n";
      return text;
    }

    void parse_text(ParameterHandler  &handler,
                    const std::string &text,
                    const std::string &origin,
                    const bool         skip_undefined)
    {
      std::istringstream stream(text);
      try
        {
          handler.parse_input(stream, origin, "", skip_undefined);
        }
      catch (const ExceptionBase &exception)
        {
          AssertThrow(false,
                      ExcInput(origin + ": " + message_of(exception) +
                               " (`cautery parameters` lists every section and entry)"));
        }
    }
  } // namespace

  SceneText::SceneText(const std::string &file_name, const std::vector<Override> &overrides)
    : file_name(file_name), overrides(overrides)
  {
    std::ifstream file(file_name);
    AssertThrow(file && !std::filesystem::is_directory(file_name),
                ExcInput("the scene `" + file_name + "` cannot be read; give the path of a .prm file"));
    text.assign(std::istreambuf_iterator<char>(file), {});
    refuse_doubled_entries_and_included_files();
  }

  /**
   * Of an entry that stands twice deal.II takes the last and says nothing: one of them is a mistake. An
   * included file could be any, even the scene itself, over and over again.
   */
  void SceneText::refuse_doubled_entries_and_included_files() const
  {
    std::map<Path, unsigned int> line_of;
    Path                         sections;
    std::istringstream           stream(text);
    std::string                  line;
    for (unsigned int number = 1; std::getline(stream, line); ++number)
      {
        std::istringstream start(line.substr(0, line.find_first_of("#=")));
        std::string        keyword, word;
        Path               words;
        for (start >> keyword; start >> word;)
          words.push_back(word);
        const std::string place = file_name + ", line " + std::to_string(number) + ": ";
        if (keyword == "subsection" || keyword == "SUBSECTION")
          sections.push_back(join(words, " "));
        else if ((keyword == "end" || keyword == "END") && !sections.empty())
          sections.pop_back();
        else if (keyword == "set" || keyword == "SET")
          {
            Path path = sections;
            path.push_back(join(words, " "));
            const auto [first, is_new] = line_of.emplace(path, number);
            AssertThrow(is_new,
                        ExcInput(place + join(path, "/") + " stands in line " +
                                 std::to_string(first->second) + " already; keep one"));
          }
        else
          AssertThrow(keyword != "include" && keyword != "INCLUDE",
                      ExcInput(place + "a scene is one file; write here what `" + join(words, " ") +
                               "` has, in place of `include`"));
      }
  }

  void SceneText::parse(ParameterHandler &handler, const bool skip_undefined) const
  {
    parse_text(handler, text, file_name, skip_undefined);
    for (const auto &given : overrides)
      parse_text(
        handler, override_text(given), "--set \"" + given.path + "=" + given.value + "\"", skip_undefined);
  }

  std::string SceneText::peek(const std::vector<std::string> &sections,
                              const std::string              &name,
                              const std::string              &default_value) const
  {
    ParameterHandler handler;
    for (const auto &section : sections)
      handler.enter_subsection(section);
    handler.declare_entry(name, default_value);
    for (unsigned int i = 0; i < sections.size(); ++i)
      handler.leave_subsection();
    parse(handler, true);
    return handler.get(sections, name);
  }

  std::vector<std::string> SceneText::peek_names(const std::vector<std::string> &sections,
                                                 const std::string              &name,
                                                 const std::string              &default_names) const
  {
    auto              names = Utilities::split_string_list(peek(sections, name, default_names), ',');
    const std::string fault = fault_of_names(names);
    AssertThrow(
      fault.empty(),
      ExcInput(file_name + ": " + join(sections, "/") + "/" + name + " = " + join(names) + ": " + fault));
    return names;
  }
} // namespace Cautery
