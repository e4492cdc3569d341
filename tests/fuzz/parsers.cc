// SPDX-License-Identifier: LGPL-2.1-or-later
// Reads standard input by one of the program's own parsers, for AFL++: see doc/fuzzing.md. The first line
// names the parser, the rest is its text. Ends with 0 whether the text is taken or refused; anything else
// than a refusal with a reason is a fault.
#include <cautery/scene/scene.h>
#include <cautery/study/quantity.h>
#include <cautery/study/variant.h>

#include <sys/mman.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>

namespace
{
  using namespace Cautery;

  /// A scene is read from a file: here from one in memory, which goes with the process.
  void read_as_scene(const std::string &text)
  {
    const std::string file_name = "/proc/self/fd/" + std::to_string(memfd_create("scene", 0));
    std::ofstream(file_name) << text;
    read_scene(file_name, {});
  }

  void read_expression(const std::string &text)
  {
    const Expression expression(text);
    expression.value(Point<3>(0.1, 0.2, 0.3), 0.4);
  }

  void read_property(const std::string &text)
  {
    const TemperatureFunction property(text);
    for (const double temperature : {0., 310., 2000.})
      property.value(temperature);
  }

  const std::map<std::string, std::function<void(const std::string &)>> parsers = {
    {"scene", read_as_scene},
    {"expression", read_expression},
    {"property", read_property},
    {"changes", [](const std::string &text) { parse_changes(text, "Accuracy/With"); }},
    {"quantity", [](const std::string &text) { Quantity quantity(text); }}};
} // namespace

int main()
{
  deal_II_exceptions::suppress_stacktrace_in_exceptions();
  std::string name;
  std::getline(std::cin, name);
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const auto        parser = parsers.find(name);
  if (parser == parsers.end())
    return 0;
  try
    {
      parser->second(text);
    }
  catch (const ExcInput &exception)
    {
      if (message_of(exception).empty())
        std::abort();
    }
  return 0;
}
