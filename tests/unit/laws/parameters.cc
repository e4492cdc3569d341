// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check.h"

#include <cmath>
#include <iostream>

namespace Cautery::Test
{
  namespace
  {
    enum class Colour
    {
      red,
      green
    };

    /// One entry of every kind.
    struct Everything
    {
      double                   number = 0.1;
      double                   share  = 0.5;
      unsigned int             count  = 3;
      bool                     flag   = true;
      Colour                   colour = Colour::green;
      std::string              word   = "liver";
      std::vector<std::string> words  = {"left", "right"};
      std::vector<double>      numbers{1. / 3., 1e-300};
      Point<3>                 place{1., 2., 3.};
      std::vector<Point<3>>    places{{1., 2., 3.}, {4., 5., 6.}};
      Expression               expression = 310.;
      VectorExpression         vector;
      TemperatureFunction      function = 0.5;

      void parameters(Parameters &p)
      {
        p.section("Part", [&]() {
          p.entry("Number", number, "K", "A number");
          p.entry("Share", share, "", "From 0 to below 1", Bounds{0., 1., false, true});
          p.entry("Count", count, "How many", Bounds::between(1, 9));
          p.entry("Flag", flag, "On or off");
          p.entry(
            "Colour", colour, Choices<Colour>{{"red", Colour::red}, {"green", Colour::green}}, "A choice");
          p.entry("Word", word, "A word");
          p.entry("Words", words, "Words");
          p.entry("Numbers", numbers, "s", "Numbers", Bounds::non_negative());
          p.entry("Place", place, "m", "A place");
          p.entry("Places", places, "m", "Places");
          p.entry("Expression", expression, "K", "An expression", Bounds::non_negative());
          p.entry("Vector", vector, "m", "A vector");
          p.entry("Function", function, "W/(m K)", "A function of T", Bounds::positive());
        });
      }
    };

    std::string in_part(const std::string &line) { return "subsection Part\n set " + line + "\nend\n"; }

    void test_bounds()
    {
      const Bounds share{0., 1., false, true};
      holds("a closed end belongs to the range, an open one does not",
            share.contain(0.) && !share.contain(1.) && share.contain(0.999) && !share.contain(-1e-300));
      holds("positive excludes zero, non-negative does not",
            !Bounds::positive().contain(0.) && Bounds::positive().contain(1e-300) &&
              Bounds::non_negative().contain(0.));
      expect("as text", share.to_string(), ">= 0 and < 1");
      expect("as text, without ends", Bounds::any().to_string(), "");
      for (const double value : {0.1, 1. / 3., 1e-300, 120., -1.98e106})
        expect("number " + to_text(value) + " reads back", std::stod(to_text(value)), value, 0.);
    }

    void test_reading()
    {
      Everything defaults;
      read("", defaults);
      expect("default number", defaults.number, 0.1, 0.);
      expect("default list", defaults.numbers.at(0) - 1. / 3. + defaults.numbers.at(1), 1e-300, 0.);
      expect("default places", defaults.places.at(1)[2], 6., 0.);
      holds("default choice and flag", defaults.colour == Colour::green && defaults.flag);

      Everything given;
      read(in_part("Number = -2e3") + in_part("Flag = off") + in_part("Colour = red") +
             in_part("Words = a b , c") + in_part("Place = 7, 8") + in_part("Places = 1, 2; 3, 4, 5") +
             in_part("Vector = x; 2*t; 3") + in_part("Function = 300: 1, 310: 2") + in_part("Numbers =") +
             in_part("Count = 9"),
           given);
      expect("number", given.number, -2000., 0.);
      holds("flag and choice", !given.flag && given.colour == Colour::red);
      expect("words keep their inner blanks", join(given.words, "|"), "a b|c");
      expect("z of a place in the plane", given.place[2], 0., 0.);
      expect("places of two and three coordinates", given.places.at(0)[1] + given.places.at(1)[2], 7., 0.);
      expect("vector", given.vector.value(Point<3>(1., 0., 0.), 4.)[1], 8., 0.);
      expect("table", given.function.value(305.), 1.5);
      holds("an empty list", given.numbers.empty());
      expect("count", given.count, 9., 0.);
    }

    void test_round_trip()
    {
      Everything       item;
      ParameterHandler handler;
      Parameters       declaring(handler, Parameters::Mode::declare);
      item.parameters(declaring);
      std::ostringstream written;
      handler.print_parameters(written, ParameterHandler::PRM | ParameterHandler::Short);
      item          = Everything();
      item.number   = 7.;
      item.numbers  = {};
      item.function = 7.;
      read(written.str(), item);
      expect("number after writing and reading", item.number, 0.1, 0.);
      expect("list after writing and reading", item.numbers.at(0), 1. / 3., 0.);
      expect("function after writing and reading", item.function.value(0.), 0.5, 0.);
      holds("the documentation names unit and bounds", [&]() {
        std::ostringstream documented;
        handler.print_parameters(documented, ParameterHandler::PRM);
        return documented.str().find("A function of T [W/(m K); > 0]") != std::string::npos &&
               documented.str().find("A choice [red | green]") != std::string::npos;
      }());
    }

    void test_messages()
    {
      const auto refused = [](const std::string &line, const std::string &reason) {
        expect("refused: " + line, refusal<Everything>(in_part(line)), "Part/" + line + ": " + reason);
      };
      refused("Number = ten", "this is not a number");
      refused("Number = 1,5", "this is not a number");
      refused("Number = 3 K", "this is not a number");
      refused("Number = nan", "this is not a number");
      refused("Number = inf", "this is not a number");
      refused("Number = 1e999", "this is not a number");
      refused("Share = 1", "it must be >= 0 and < 1");
      refused("Count = 0", "it must be >= 1 and <= 9");
      refused("Count = 2.5", "this is not a whole number");
      refused("Flag = yes", "choose one of: off, on");
      refused("Colour = blue", "choose one of: red, green");
      refused("Place = 1", "a place has two or three coordinates, x, y, z");
      refused("Place = 1, 2, 3, 4", "a place has two or three coordinates, x, y, z");
      refused("Expression = -5", "it must be >= 0");
      refused("Vector = 1", "a vector has two or three components, separated by semicolons");
      refused("Function = 300: 1, 310: -1", "it must be > 0");
      expect("refused: one number of a list",
             refusal<Everything>(in_part("Numbers = 1, -2")),
             "Part/Numbers = -2: it must be >= 0");
      expect("refused: one component",
             refusal<Everything>(in_part("Vector = 1; 2+; 3")).substr(0, 42),
             "Part/Vector = 1; 2+; 3: this is neither a ");
    }
  } // namespace

  void test_parameters()
  {
    std::cout << "Parameters\n";
    test_bounds();
    test_reading();
    test_round_trip();
    test_messages();
  }
} // namespace Cautery::Test
