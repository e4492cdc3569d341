// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/files.h>

#include <chrono>
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
    /** Silent (@p speaks is false) it writes no log either. */
    Progress(const MPI_Comm communicator, const bool speaks, const double end_time);
    ~Progress();

    /** What is said from now on is written there too. */
    void log_to(const std::string &file_name);

    /** The log's length, see GrowingFile; and where the archive brings back, time goes on from @p time. */
    void archive(const double time, Archive &archive);

    /** A line, or several, for good. Collective. Errors: ExcRun where the log cannot be written. */
    void say(const std::string &text);

    /** Updates the progress line, a few times a second at most. @p hottest in K, or 0 without heat. */
    void show(const double time, const unsigned int step, const double hottest);

    /** The text of the progress line: time, step, percentage, time left, hottest point. */
    std::string line(const double time, const unsigned int step, const double hottest) const;

  private:
    using Clock = std::chrono::steady_clock;

    void clear();

    const MPI_Comm    communicator;
    const bool        silent; ///< all processes are
    const bool        speaks; ///< this one does
    const bool        terminal;
    const double      end_time;
    double            begin_time = 0.; ///< s
    GrowingFile       log;
    bool              logs  = false;
    Clock::time_point start = Clock::now();
    Clock::time_point last  = start;
    bool              shown = false;
  };
} // namespace Cautery
