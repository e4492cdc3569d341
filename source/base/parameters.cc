// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/parameters.h>

#include <deal.II/base/utilities.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace Cautery
{
  namespace
  {
    template <typename... Format>
    std::string written(const double value, const Format... format)
    {
      std::array<char, 32> buffer;
      const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
      return std::string(buffer.data(), result.ptr);
    }
  } // namespace

  std::string to_text(const double value) { return written(value); }

  std::string to_text(const Point<3> &place)
  {
    return to_text(place[0]) + ", " + to_text(place[1]) + ", " + to_text(place[2]);
  }

  std::string to_short_text(const double value) { return written(value, std::chars_format::general, 7); }

  std::string to_short_text(const Point<3> &place)
  {
    return to_short_text(place[0]) + ", " + to_short_text(place[1]) + ", " + to_short_text(place[2]);
  }

  std::string join(const std::vector<std::string> &texts, const std::string &separator)
  {
    std::string joined;
    for (const auto &text : texts)
      joined += (joined.empty() ? "" : separator) + text;
    return joined;
  }

  bool Bounds::contain(const double value) const
  {
    return (lower_open ? value > lower : value >= lower) && (upper_open ? value < upper : value <= upper);
  }

  std::string Bounds::to_string() const
  {
    std::vector<std::string> ends;
    if (std::isfinite(lower))
      ends.push_back((lower_open ? "> " : ">= ") + to_text(lower));
    if (std::isfinite(upper))
      ends.push_back((upper_open ? "< " : "<= ") + to_text(upper));
    return join(ends, " and ");
  }

  namespace
  {
    /// "text [unit; bounds]", the documentation of a number
    std::string
    describe(const std::string &documentation, const std::string &unit, const Bounds &bounds = Bounds::any())
    {
      std::vector<std::string> notes;
      if (!unit.empty())
        notes.push_back(unit);
      if (const std::string range = bounds.to_string(); !range.empty())
        notes.push_back(range);
      return notes.empty() ? documentation : documentation + " [" + join(notes, "; ") + "]";
    }

    template <typename T>
    std::string list_text(const std::vector<T> &values, const std::string &separator)
    {
      std::vector<std::string> texts;
      for (const auto &value : values)
        texts.push_back(to_text(value));
      return join(texts, separator);
    }
  } // namespace

  Parameters::Parameters(ParameterHandler &handler, const Mode mode) : handler(handler), mode(mode) {}

  void Parameters::enter(const std::string &name)
  {
    handler.enter_subsection(name);
    sections.push_back(name);
  }

  void Parameters::leave()
  {
    handler.leave_subsection();
    sections.pop_back();
  }

  std::string Parameters::path(const std::string &name) const
  {
    return sections.empty() ? name : join(sections, "/") + "/" + name;
  }

  void Parameters::reject(const std::string &name, const std::string &value, const std::string &reason) const
  {
    AssertThrow(false, ExcInput(path(name) + " = " + value + ": " + reason));
    std::abort();
  }

  std::string Parameters::text(const std::string &name,
                               const std::string &default_value,
                               const std::string &documentation)
  {
    if (mode == Mode::read)
      return handler.get(name);
    handler.declare_entry(name, default_value, Patterns::Anything(), documentation);
    return default_value;
  }

  double Parameters::number(const std::string &name, const std::string &text, const Bounds &bounds) const
  {
    double            value  = 0.;
    const std::string bare   = Utilities::trim(text);
    const auto        result = std::from_chars(bare.data(), bare.data() + bare.size(), value);
    if (result.ec != std::errc() || result.ptr != bare.data() + bare.size() || !std::isfinite(value))
      reject(name, text, "this is not a number");
    if (!bounds.contain(value))
      reject(name, text, "it must be " + bounds.to_string());
    return value;
  }

  Point<3> Parameters::place(const std::string &name, const std::string &text) const
  {
    const auto parts = Utilities::split_string_list(text, ',');
    if (parts.size() < least_coordinates || parts.size() > 3)
      reject(name,
             text,
             least_coordinates == 3 ? "a place has three coordinates, x, y, z" :
                                      "a place has two or three coordinates, x, y, z");
    Point<3> place;
    for (unsigned int d = 0; d < parts.size(); ++d)
      place[d] = number(name, parts[d], Bounds::any());
    return place;
  }

  std::string Parameters::choose(const std::string              &name,
                                 const std::string              &default_value,
                                 const std::vector<std::string> &names,
                                 const std::string              &documentation)
  {
    std::string chosen = text(name, default_value, documentation + " [" + join(names, " | ") + "]");
    if (std::find(names.begin(), names.end(), chosen) == names.end())
      reject(name, chosen, "choose one of: " + join(names));
    return chosen;
  }

  void Parameters::entry(const std::string &name,
                         double            &value,
                         const std::string &unit,
                         const std::string &documentation,
                         const Bounds      &bounds)
  {
    const std::string given = text(name, to_text(value), describe(documentation, unit, bounds));
    if (reading())
      value = number(name, given, bounds);
  }

  void Parameters::entry(const std::string &name,
                         unsigned int      &value,
                         const std::string &documentation,
                         const Bounds      &bounds)
  {
    const std::string given = text(name, std::to_string(value), describe(documentation, "", bounds));
    if (!reading())
      return;
    const double as_number = number(name, given, bounds);
    if (as_number != std::floor(as_number) || as_number > std::numeric_limits<unsigned int>::max())
      reject(name, given, "this is not a whole number");
    value = static_cast<unsigned int>(as_number);
  }

  void Parameters::entry(const std::string &name, bool &value, const std::string &documentation)
  {
    entry(name, value, Choices<bool>{{"off", false}, {"on", true}}, documentation);
  }

  void Parameters::entry(const std::string &name, std::string &value, const std::string &documentation)
  {
    value = text(name, value, documentation);
  }

  void Parameters::entry(const std::string        &name,
                         std::vector<std::string> &value,
                         const std::string        &documentation)
  {
    const std::string given = text(name, join(value), documentation);
    if (reading())
      value = Utilities::split_string_list(given, ',');
  }

  void Parameters::entry(const std::string   &name,
                         std::vector<double> &value,
                         const std::string   &unit,
                         const std::string   &documentation,
                         const Bounds        &bounds)
  {
    const std::string given = text(name, list_text(value, ", "), describe(documentation, unit, bounds));
    if (!reading())
      return;
    value.clear();
    for (const auto &part : Utilities::split_string_list(given, ','))
      value.push_back(number(name, part, bounds));
  }

  void Parameters::entry(const std::string &name,
                         Point<3>          &value,
                         const std::string &unit,
                         const std::string &documentation)
  {
    const std::string given = text(name, to_text(value), describe(documentation, unit));
    if (reading())
      value = place(name, given);
  }

  void Parameters::entry(const std::string     &name,
                         std::vector<Point<3>> &value,
                         const std::string     &unit,
                         const std::string     &documentation)
  {
    const std::string given = text(name, list_text(value, "; "), describe(documentation, unit));
    if (!reading())
      return;
    value.clear();
    for (const auto &part : Utilities::split_string_list(given, ';'))
      value.push_back(place(name, part));
  }

  namespace
  {
    /// Runs @p make, which may throw ExcInput for a bad expression, and puts the parameter's path in front.
    template <typename Make>
    auto parse_for(const Parameters &p, const std::string &name, const std::string &text, const Make &make)
    {
      try
        {
          return make();
        }
      catch (const ExceptionBase &exception)
        {
          p.reject(name, text, message_of(exception));
        }
    }
  } // namespace

  void Parameters::entry(const std::string &name,
                         Expression        &value,
                         const std::string &unit,
                         const std::string &documentation,
                         const Bounds      &bounds)
  {
    const std::string given = text(name, value.text(), describe(documentation, unit, bounds));
    if (!reading())
      return;
    value = parse_for(*this, name, given, [&]() { return Expression(given); });
    if (value.is_constant())
      number(name, given, bounds);
  }

  void Parameters::entry(const std::string &name,
                         VectorExpression  &value,
                         const std::string &unit,
                         const std::string &documentation)
  {
    const std::string given = text(name, value.text(), describe(documentation, unit));
    if (!reading())
      return;
    const auto parts = Utilities::split_string_list(given, ';');
    if (parts.size() != 2 && parts.size() != 3)
      reject(name, given, "a vector has two or three components, separated by semicolons");
    std::array<Expression, 3> components;
    for (unsigned int c = 0; c < parts.size(); ++c)
      components[c] = parse_for(*this, name, given, [&]() { return Expression(parts[c]); });
    value = VectorExpression(components);
  }

  void Parameters::entry(const std::string   &name,
                         TemperatureFunction &value,
                         const std::string   &unit,
                         const std::string   &documentation,
                         const Bounds        &bounds)
  {
    const std::string given = text(name, value.text(), describe(documentation, unit, bounds));
    if (!reading())
      return;
    value = parse_for(*this, name, given, [&]() { return TemperatureFunction(given); });
    for (const double known : value.known_values())
      if (!bounds.contain(known))
        reject(name, given, "it must be " + bounds.to_string());
    value.judge_values(
      [bounds, entry = path(name) + " = " + given](const double v, const double temperature) {
        AssertThrow(bounds.contain(v),
                    ExcRun(entry + " is " + to_short_text(v) + " at T = " + to_short_text(temperature) +
                           " K, where it must be " + bounds.to_string() +
                           "; give an expression that holds at all temperatures of the run"));
      });
  }
} // namespace Cautery
