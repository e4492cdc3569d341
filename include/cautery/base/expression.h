// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  template <int dim>
  class FunctionParser;
}

namespace Cautery
{
  using namespace dealii;

  /**
   * A number or a muParser expression in x, y, z (m) and t (s). A plain number costs no parser at evaluation.
   * Errors: ExcInput for a text that does not parse, ExcRun where a value is not finite.
   */
  class Expression
  {
  public:
    Expression(const double constant = 0.);
    explicit Expression(const std::string &text);

    /** The value at @p place (m; z = 0 in two dimensions) and @p time (s). */
    double value(const Point<3> &place, const double time) const;

    bool is_constant() const { return constant.has_value(); }
    /** Does the value change in time? Found by looking for the variable t in the parsed expression. */
    bool depends_on_time() const { return uses_time; }
    /** The same for x, y and z. */
    bool               depends_on_place() const { return uses_place; }
    const std::string &text() const { return source; }

  private:
    std::string                        source;
    std::optional<double>              constant;
    bool                               uses_time  = false;
    bool                               uses_place = false;
    std::shared_ptr<FunctionParser<3>> parser;
  };

  /**
   * Three expressions, the components of a vector.
   */
  class VectorExpression
  {
  public:
    VectorExpression() = default;
    explicit VectorExpression(const std::array<Expression, 3> &components) : components(components) {}

    Tensor<1, 3>      value(const Point<3> &place, const double time) const;
    bool              depends_on_time() const;
    bool              depends_on_place() const;
    const Expression &operator[](const unsigned int c) const { return components[c]; }
    std::string       text() const;

  private:
    std::array<Expression, 3> components;
  };

  /**
   * A property as a function of temperature (K): a number, a table "293: 0.5, 310: 0.52, ..." with linear
   * interpolation and constant continuation, or a muParser expression in T.
   */
  class TemperatureFunction
  {
  public:
    TemperatureFunction(const double constant = 0.);
    explicit TemperatureFunction(const std::string &text);

    double value(const double temperature) const;

    /** The integral from @p from to @p to (K): exact for numbers and tables, Gauss quadrature for
     * expressions. */
    double integral(const double from, const double to) const;

    bool               is_constant() const { return constant.has_value(); }
    const std::string &text() const { return source; }

    /** Has @p judge look at every value of an expression, with its temperature (K): its bounds are known only
     * where it is evaluated. */
    void judge_values(std::function<void(double value, double temperature)> judge)
    {
      judged = std::move(judge);
    }

    /** The values that bounds are checked on: the number, the table's values, or none for an expression. */
    std::vector<double> known_values() const;

  private:
    std::string                            source;
    std::optional<double>                  constant;
    std::vector<std::pair<double, double>> table;
    std::shared_ptr<FunctionParser<1>>     parser;
    std::function<void(double, double)>    judged;
  };
} // namespace Cautery
