// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/expression.h>
#include <cautery/base/parameters.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>
#include <regex>

namespace Cautery
{
  namespace
  {
    std::optional<double> plain_number(const std::string &text)
    {
      const std::string bare  = Utilities::trim(text);
      double            value = 0.;
      const auto        end   = bare.data() + bare.size();
      const auto        found = std::from_chars(bare.data(), end, value);
      if (found.ec == std::errc() && found.ptr == end && std::isfinite(value))
        return value;
      return {};
    }

    /// deal.II prints what muParser says besides throwing it: keeps that off the screen.
    class QuietErrors
    {
    public:
      ~QuietErrors() { std::cerr.rdbuf(screen); }

    private:
      std::streambuf *const screen = std::cerr.rdbuf(nullptr);
    };

    /// muParser takes "1,5" for two values, of which the last counts: only functions may have commas.
    bool comma_outside_functions(const std::string &text)
    {
      int depth = 0;
      for (const char letter : text)
        {
          depth += (letter == '(') - (letter == ')');
          if (letter == ',' && depth == 0)
            return true;
        }
      return false;
    }

    /// muParser's `x = 1` gives a variable another value.
    bool assigns(const std::string &text)
    {
      return std::regex_search(text, std::regex("(^|[^<>=!])=([^=]|$)"));
    }

    std::string reason_of(const std::exception &exception)
    {
      const std::string reason = message_of(exception), start = "The parser said: ";
      const auto        found = reason.find(start);
      return found == std::string::npos ? reason : reason.substr(found + start.size());
    }

    /// muParser compiles at the first evaluation only: evaluate once, so that a bad text is told at the
    /// start.
    template <int n_variables>
    std::shared_ptr<FunctionParser<n_variables>>
    compile(const std::string &text, const std::string &variables, const bool with_time)
    {
      const std::map<std::string, double> constants = {{"pi", numbers::PI}};
      const std::string expected = "this is neither a number nor an expression in " + variables +
                                   " with muParser's functions (sin, exp, if, ...)";
      AssertThrow(!text.empty(), ExcInput(expected + ": nothing is written"));
      AssertThrow(!comma_outside_functions(text),
                  ExcInput(expected + ": a comma only separates arguments; decimals have a point"));
      AssertThrow(!assigns(text), ExcInput(expected + ": nothing can be assigned; compare with =="));
      auto parser = std::make_shared<FunctionParser<n_variables>>(1);
      try
        {
          const QuietErrors quiet;
          parser->initialize(variables, text, constants, with_time);
          parser->value(Point<n_variables>());
        }
      catch (const std::exception &exception)
        {
          AssertThrow(false, ExcInput(expected + ": " + reason_of(exception)));
        }
      return parser;
    }

    double checked(const double value, const std::string &text, const std::string &where)
    {
      AssertThrow(std::isfinite(value),
                  ExcRun("the expression `" + text + "` has no finite value at " + where +
                         "; change the expression or its range"));
      return value;
    }
  } // namespace

  Expression::Expression(const double constant) : source(to_text(constant)), constant(constant) {}

  Expression::Expression(const std::string &text)
    : source(Utilities::trim(text))
    , constant(plain_number(text))
    , uses_time(!constant && std::regex_search(text, std::regex("\\bt\\b")))
    , uses_place(!constant && std::regex_search(text, std::regex("\\b[xyz]\\b")))
  {
    if (!constant)
      parser = compile<3>(source, "x,y,z,t", true);
  }

  double Expression::value(const Point<3> &place, const double time) const
  {
    if (constant)
      return *constant;
    parser->set_time(time);
    const double result = parser->value(place);
    if (!std::isfinite(result)) // the text of the place is costly: only where it is needed
      checked(result, source, "(" + to_short_text(place) + ") m, " + to_short_text(time) + " s");
    return result;
  }

  Tensor<1, 3> VectorExpression::value(const Point<3> &place, const double time) const
  {
    Tensor<1, 3> result;
    for (unsigned int c = 0; c < 3; ++c)
      result[c] = components[c].value(place, time);
    return result;
  }

  bool VectorExpression::depends_on_time() const
  {
    return components[0].depends_on_time() || components[1].depends_on_time() ||
           components[2].depends_on_time();
  }

  bool VectorExpression::depends_on_place() const
  {
    return components[0].depends_on_place() || components[1].depends_on_place() ||
           components[2].depends_on_place();
  }

  std::string VectorExpression::text() const
  {
    return components[0].text() + "; " + components[1].text() + "; " + components[2].text();
  }

  TemperatureFunction::TemperatureFunction(const double constant)
    : source(to_text(constant)), constant(constant)
  {
  }

  TemperatureFunction::TemperatureFunction(const std::string &text)
    : source(Utilities::trim(text)), constant(plain_number(text))
  {
    if (constant)
      return;
    if (source.find(':') == std::string::npos)
      {
        parser = compile<1>(source, "T", false);
        return;
      }
    for (const auto &row : Utilities::split_string_list(source, ','))
      {
        const auto   columns     = Utilities::split_string_list(row, ':');
        const double nothing     = std::numeric_limits<double>::quiet_NaN();
        const double temperature = columns.size() == 2 ? plain_number(columns[0]).value_or(nothing) : nothing;
        const double value       = columns.size() == 2 ? plain_number(columns[1]).value_or(nothing) : nothing;
        AssertThrow(std::isfinite(temperature) && std::isfinite(value),
                    ExcInput("a table is written `temperature: value, temperature: value, ...`"));
        AssertThrow(table.empty() || table.back().first < temperature,
                    ExcInput("the temperatures of a table must rise from entry to entry"));
        table.emplace_back(temperature, value);
      }
  }

  namespace
  {
    using Table = std::vector<std::pair<double, double>>;

    double interpolate(const Table &table, const double temperature)
    {
      const auto above =
        std::upper_bound(table.begin(), table.end(), temperature, [](const double t, const auto &row) {
          return t < row.first;
        });
      if (above == table.begin())
        return table.front().second;
      if (above == table.end())
        return table.back().second;
      const auto  &below = *(above - 1);
      const double share = (temperature - below.first) / (above->first - below.first);
      return below.second + share * (above->second - below.second);
    }

    /// @p f must be smooth in between.
    template <typename Function>
    double gauss(const Function &f, const double from, const double to)
    {
      static const QGauss<1> rule(8);
      double                 sum = 0.;
      for (unsigned int q = 0; q < rule.size(); ++q)
        sum += rule.weight(q) * f(from + rule.point(q)[0] * (to - from));
      return sum * (to - from);
    }
  } // namespace

  double TemperatureFunction::value(const double temperature) const
  {
    if (constant)
      return *constant;
    if (parser)
      {
        const double result = parser->value(Point<1>(temperature));
        if (!std::isfinite(result))
          checked(result, source, "T = " + to_short_text(temperature) + " K");
        if (judged)
          judged(result, temperature);
        return result;
      }
    return interpolate(table, temperature);
  }

  double TemperatureFunction::integral(const double from, const double to) const
  {
    if (constant)
      return *constant * (to - from);
    if (to < from)
      return -integral(to, from);
    if (parser)
      return gauss([this](const double temperature) { return value(temperature); }, from, to);

    // straight pieces: the trapezoid is exact on each
    double     sum   = 0.;
    double     start = from, start_value = value(from);
    const auto add = [&](const double end, const double end_value) {
      sum += 0.5 * (start_value + end_value) * (end - start);
      start       = end;
      start_value = end_value;
    };
    for (const auto &[temperature, entry] : table)
      if (temperature > from && temperature < to)
        add(temperature, entry);
    add(to, value(to));
    return sum;
  }

  std::vector<double> TemperatureFunction::known_values() const
  {
    if (constant)
      return {*constant};
    std::vector<double> values;
    for (const auto &row : table)
      values.push_back(row.second);
    return values;
  }
} // namespace Cautery
