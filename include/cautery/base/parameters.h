// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/exceptions.h>
#include <cautery/base/expression.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace Cautery
{
  using namespace dealii;

  /**
   * The values a number may take. An open end excludes the bound itself.
   */
  struct Bounds
  {
    double lower      = -std::numeric_limits<double>::infinity();
    double upper      = std::numeric_limits<double>::infinity();
    bool   lower_open = false;
    bool   upper_open = false;

    bool        contain(const double value) const;
    std::string to_string() const;

    static Bounds any() { return {}; }
    static Bounds positive() { return {0., std::numeric_limits<double>::infinity(), true, false}; }
    static Bounds non_negative() { return {0., std::numeric_limits<double>::infinity(), false, false}; }
    static Bounds between(const double lower, const double upper) { return {lower, upper, false, false}; }
    static Bounds between_open(const double lower, const double upper) { return {lower, upper, true, true}; }
  };

  /**
   * The names a user may choose from, each with its value: the one place where the text of a choice stands.
   */
  template <typename Enum>
  using Choices = std::vector<std::pair<std::string, Enum>>;

  /**
   * One text for each parameter: the same call declares an entry (its present value is the default) and, once
   * the input has been parsed, reads it. A struct lists its entries in one function `void
   * parameters(Parameters &)`.
   *
   * Every `entry` takes the name, the variable, the unit ("" for none), and the documentation.
   * Errors: ExcInput, naming path, value and bounds.
   */
  class Parameters
  {
  public:
    enum class Mode
    {
      declare,
      read
    };

    Parameters(ParameterHandler &handler, const Mode mode);

    /** Calls @p inside within the subsection @p name. */
    template <typename Function>
    void section(const std::string &name, const Function &inside)
    {
      enter(name);
      inside();
      leave();
    }

    void entry(const std::string &name,
               double            &value,
               const std::string &unit,
               const std::string &documentation,
               const Bounds      &bounds = Bounds::any());
    void entry(const std::string &name,
               unsigned int      &value,
               const std::string &documentation,
               const Bounds      &bounds = Bounds::non_negative());
    void entry(const std::string &name, bool &value, const std::string &documentation);
    void entry(const std::string &name, std::string &value, const std::string &documentation);
    void entry(const std::string &name, std::vector<std::string> &value, const std::string &documentation);
    void entry(const std::string   &name,
               std::vector<double> &value,
               const std::string   &unit,
               const std::string   &documentation,
               const Bounds        &bounds = Bounds::any());
    /** A place: x, y, z; in two dimensions z may be left out (see require_coordinates). */
    void entry(const std::string &name,
               Point<3>          &value,
               const std::string &unit,
               const std::string &documentation);
    /** Places, separated by semicolons. */
    void entry(const std::string     &name,
               std::vector<Point<3>> &value,
               const std::string     &unit,
               const std::string     &documentation);
    /** An expression in x, y, z, t; a constant is checked against the bounds at once. */
    void entry(const std::string &name,
               Expression        &value,
               const std::string &unit,
               const std::string &documentation,
               const Bounds      &bounds = Bounds::any());
    /** A vector of three expressions, separated by semicolons. */
    void entry(const std::string &name,
               VectorExpression  &value,
               const std::string &unit,
               const std::string &documentation);
    /** A function of temperature: constant, table or expression. */
    void entry(const std::string   &name,
               TemperatureFunction &value,
               const std::string   &unit,
               const std::string   &documentation,
               const Bounds        &bounds = Bounds::any());

    template <typename Enum>
    void entry(const std::string   &name,
               Enum                &value,
               const Choices<Enum> &choices,
               const std::string   &documentation)
    {
      std::vector<std::string> names;
      std::string              text;
      for (const auto &choice : choices)
        {
          names.push_back(choice.first);
          if (choice.second == value)
            text = choice.first;
        }
      text = choose(name, text, names, documentation);
      for (const auto &choice : choices)
        if (choice.first == text)
          value = choice.second;
    }

    /** Of places that are read from now on, at least. */
    void require_coordinates(const unsigned int number) { least_coordinates = number; }

    bool reading() const { return mode == Mode::read; }

    /** "Section/Subsection/Entry", as messages name it. */
    std::string path(const std::string &name) const;

    /** Throws ExcInput that says "Section/Entry = value: reason". */
    [[noreturn]] void
    reject(const std::string &name, const std::string &value, const std::string &reason) const;

  private:
    void enter(const std::string &name);
    void leave();
    std::string
    text(const std::string &name, const std::string &default_value, const std::string &documentation);
    std::string choose(const std::string              &name,
                       const std::string              &default_value,
                       const std::vector<std::string> &names,
                       const std::string              &documentation);
    double      number(const std::string &name, const std::string &text, const Bounds &bounds) const;
    Point<3>    place(const std::string &name, const std::string &text) const;

    ParameterHandler        &handler;
    const Mode               mode;
    unsigned int             least_coordinates = 2;
    std::vector<std::string> sections;
  };

  /** The shortest text that reads back as the same number. */
  std::string to_text(const double value);
  /** "x, y, z" of these. */
  std::string to_text(const Point<3> &place);

  /** For people: with seven digits at most. */
  std::string to_short_text(const double value);
  std::string to_short_text(const Point<3> &place);

  /** One text of several, with @p separator between them. */
  std::string join(const std::vector<std::string> &texts, const std::string &separator = ", ");
} // namespace Cautery
