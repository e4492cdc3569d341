// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/output/progress.h>

#include <cstdio>
#include <iostream>
#include <sstream>
#include <unistd.h>

namespace Cautery
{
  Progress::Progress(const bool speaks, const std::string &log_file, const double end_time)
    : speaks(speaks), terminal(isatty(STDOUT_FILENO) != 0), end_time(end_time)
  {
    if (speaks)
      log.open(log_file);
  }

  Progress::~Progress() { clear(); }

  void Progress::clear()
  {
    if (shown)
      std::cout << "\r\033[K" << std::flush;
    shown = false;
  }

  void Progress::say(const std::string &text)
  {
    if (!speaks)
      return;
    clear();
    std::cout << text << std::flush;
    log << text << std::flush;
  }

  void Progress::show(const double time, const unsigned int step, const double hottest)
  {
    if (!speaks || !terminal)
      return;
    const auto now = Clock::now();
    if (now - last < std::chrono::milliseconds(200))
      return;
    last  = now;
    shown = true;
    std::cout << '\r' << line(time, step, hottest) << "\033[K" << std::flush;
  }

  std::string Progress::line(const double time, const unsigned int step, const double hottest) const
  {
    const double share   = time / end_time;
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    char         buffer[160];
    std::snprintf(buffer, sizeof(buffer), "t = %.6g s  step %u  %.0f %%", time, step, 100. * share);
    std::ostringstream out;
    out << buffer;
    if (share > 0. && share < 1.)
      {
        const double left = elapsed * (1. - share) / share;
        std::snprintf(
          buffer, sizeof(buffer), "  %d:%02d left", static_cast<int>(left) / 60, static_cast<int>(left) % 60);
        out << buffer;
      }
    if (hottest > 0.)
      {
        std::snprintf(buffer, sizeof(buffer), "  hottest %.2f K", hottest);
        out << buffer;
      }
    return out.str();
  }
} // namespace Cautery
