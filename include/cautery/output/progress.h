// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <fstream>
#include <string>

namespace Cautery
{
  /**
   * What a run says: to standard output and log.txt, on process 0 only. On a terminal one line shows how far
   * it has come.
   */
  class Progress
  {
  public:
    Progress(const bool speaks, const std::string &log_file, const double end_time);
    ~Progress();

    /** A line, or several, for good. */
    void say(const std::string &text);

    /** Updates the progress line, a few times a second at most. @p hottest in K, or 0 without heat. */
    void show(const double time, const unsigned int step, const double hottest);

    /** The text of the progress line: time, step, percentage, time left, hottest point. */
    std::string line(const double time, const unsigned int step, const double hottest) const;

  private:
    using Clock = std::chrono::steady_clock;

    void clear();

    const bool        speaks;
    const bool        terminal;
    const double      end_time;
    std::ofstream     log;
    Clock::time_point start = Clock::now();
    Clock::time_point last  = start;
    bool              shown = false;
  };
} // namespace Cautery
