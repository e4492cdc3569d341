// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

#include <string>

namespace Cautery::Test
{
  /** Prints "ok  what", or "BAD what" with both numbers where they differ by more than @p tolerance times the
   * expected one (or than @p tolerance itself where that is 0). */
  void
  expect(const std::string &what, const double value, const double expected, const double tolerance = 1e-13);
  void expect(const std::string &what, const std::string &value, const std::string &expected);
  void holds(const std::string &what, const bool truth);

  /** How many checks were bad. */
  unsigned int failures();

  /** The message of the exception @p Error that @p work must throw; "ACCEPTED" where it throws none. */
  template <typename Error = ExcInput, typename Work>
  std::string message_of(const Work &work)
  {
    try
      {
        work();
      }
    catch (const Error &exception)
      {
        return Cautery::message_of(exception);
      }
    return "ACCEPTED";
  }

  /** Reads @p text with the entries of @p item, which then holds the values; ExcInput as in a scene. */
  template <typename Item>
  void read(const std::string &text, Item &item)
  {
    ParameterHandler handler;
    Parameters       declaring(handler, Parameters::Mode::declare);
    item.parameters(declaring);
    handler.parse_input_from_string(text);
    Parameters reading(handler, Parameters::Mode::read);
    item.parameters(reading);
  }

  /** The message with which an Item refuses @p text. */
  template <typename Item>
  std::string refusal(const std::string &text)
  {
    return message_of([&text]() {
      Item item;
      read(text, item);
    });
  }

  // one for each file here
  void test_expressions();
  void test_parameters();
  void test_scene();
  void test_heat_sources();
  void test_tissue();
  void test_damage();
  void test_large_deformation();
} // namespace Cautery::Test
