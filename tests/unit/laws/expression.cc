// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check.h"

#include <cmath>
#include <iostream>
#include <limits>

namespace Cautery::Test
{
  namespace
  {
    void test_in_space_and_time()
    {
      const Point<3> place(1., 2., 3.);
      expect("a number", Expression(" 2.5e-3 ").value(place, 4.), 2.5e-3);
      expect("x, y, z and t", Expression("x + 20*y + 300*z + 4000*t").value(place, 5.), 20941.);
      expect("pi and functions", Expression("if(x > 0, cos(pi), 7)").value(place, 0.), -1.);
      expect("the first of several times after a later one",
             Expression("t^2").value(place, 3.) + Expression("t^2").value(place, 2.),
             13.);
      holds("a number is constant", Expression("3").is_constant() && !Expression("3*x").is_constant());
      holds("t is seen as a word only",
            Expression("x*t").depends_on_time() && Expression("sqrt(t)").depends_on_time() &&
              !Expression("sqrt(x)+tan(y)").depends_on_time() && !Expression("3").depends_on_time());
      const VectorExpression vector(std::array<Expression, 3>{{Expression("x"), Expression("2*t"), 7.}});
      expect("a vector", vector.value(place, 5.).norm(), std::sqrt(1. + 100. + 49.));
      holds("a vector changes if one component does", vector.depends_on_time());
    }

    void test_refused_expressions()
    {
      const std::string form = "this is neither a number nor an expression in x,y,z,t with muParser's "
                               "functions (sin, exp, if, ...): ";
      const std::vector<std::pair<std::string, std::string>> refused = {
        {"", "nothing is written"},
        {"1 +* 2", "Unexpected operator \"*\" found at position 3"},
        {"q + 1", "Unexpected token \"q\" found at position 0."},
        {"sin(", "Unexpected end of expression at position 5"},
        {"erf(x)", "Unexpected token \"erf\" found at position 0."},
        {"nan", "Unexpected token \"nan\" found at position 0."},
        {"T", "Unexpected token \"T\" found at position 0."},
        {"1,5", "a comma only separates arguments; decimals have a point"},
        {"max(1, 2) + 1,5", "a comma only separates arguments; decimals have a point"}};
      for (const auto &[text, reason] : refused)
        expect("refused: `" + text + "`", message_of([t = text]() { Expression{t}; }), form + reason);
      expect("a value that is not finite",
             message_of<ExcRun>([]() { Expression("1/x").value(Point<3>(0., 0.25, 0.5), 3.); }),
             "the expression `1/x` has no finite value at (0, 0.25, 0.5) m, 3 s; change the expression or "
             "its range");
      expect(
        "nor of a temperature",
        message_of<ExcRun>([]() { TemperatureFunction("log(T - 300)").value(290.); }),
        "the expression `log(T - 300)` has no finite value at T = 290 K; change the expression or its range");
    }

    void test_tables()
    {
      const TemperatureFunction table("300: 1, 310: 2, 330: 0");
      expect("below a table", table.value(250.), 1.);
      expect("within its first row", table.value(303.), 1.3);
      expect("at a row", table.value(310.), 2.);
      expect("within its second row", table.value(325.), 0.5);
      expect("above it", table.value(1000.), 0.);
      expect("integral over a table and beyond", table.integral(290., 340.), 10. + 15. + 20.);
      expect("within one row", table.integral(301., 302.), 1.15);
      expect("backwards", table.integral(340., 290.), -45.);
      expect("over nothing", table.integral(305., 305.), 0.);
      expect("below the table", table.integral(100., 200.), 100.);
      expect("integral of a number", TemperatureFunction(3e-4).integral(310., 360.), 0.015);
      expect("of a line", TemperatureFunction("1 + 0.5*(T - 310)").integral(310., 320.), 35.);
      expect("of an exponential",
             TemperatureFunction("exp(T/100)").integral(300., 400.),
             100. * (std::exp(4.) - std::exp(3.)));
      expect("backwards",
             TemperatureFunction("exp(T/100)").integral(400., 300.),
             -100. * (std::exp(4.) - std::exp(3.)));
      holds("values that bounds are checked on",
            table.known_values() == std::vector<double>{1., 2., 0.} &&
              TemperatureFunction("4").known_values() == std::vector<double>{4.} &&
              TemperatureFunction("T").known_values().empty());
    }

    void test_refused_tables()
    {
      const std::string form = "a table is written `temperature: value, temperature: value, ...`";
      for (const std::string text :
           {"300: 1, 310", "300: 1, 310: x", "300: , 310: 2", "300: 1: 2", "300: nan"})
        expect("refused: `" + text + "`", message_of([&]() { TemperatureFunction{text}; }), form);
      for (const std::string text : {"300: 1, 300: 2", "310: 1, 300: 2"})
        expect("refused: `" + text + "`",
               message_of([&]() { TemperatureFunction{text}; }),
               "the temperatures of a table must rise from entry to entry");
      expect("refused: `2*x`",
             message_of([&]() { TemperatureFunction("2*x"); }),
             "this is neither a number nor an expression in T with muParser's functions (sin, exp, if, ...): "
             "Unexpected token \"x\" found at position 2.");
    }
  } // namespace

  void test_expressions()
  {
    std::cout << "Expressions in space and time\n";
    test_in_space_and_time();
    test_refused_expressions();
    std::cout << "Functions of temperature\n";
    test_tables();
    test_refused_tables();
  }
} // namespace Cautery::Test
