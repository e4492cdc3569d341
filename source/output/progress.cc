// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/agreement.h>
#include <cautery/output/progress.h>

#include <cstdio>
#include <iostream>
#include <sstream>
#include <unistd.h>

namespace Cautery
{
  Progress::Progress(const MPI_Comm communicator, const bool speaks, const double end_time)
    : communicator(communicator)
    , silent(!speaks)
    , speaks(speaks && Utilities::MPI::this_mpi_process(communicator) == 0)
    , terminal(isatty(STDOUT_FILENO) != 0)
    , end_time(end_time)
  {
  }

  Progress::~Progress() { clear(); }

  void Progress::log_to(const std::string &file_name)
  {
    logs = !silent;
    if (speaks)
      log.name_it(file_name);
  }

  void Progress::clear()
  {
    if (shown)
      std::cout << "\r\033[K" << std::flush;
    shown = false;
  }

  void Progress::say(const std::string &text)
  {
    if (speaks)
      {
        clear();
        std::cout << text << std::flush;
      }
    if (logs)
      fail_together(communicator, [&]() {
        if (speaks)
          log.add(text);
      });
  }

  void Progress::archive(const double time, Archive &archive)
  {
    log.archive("log", archive);
    if (archive.restores())
      begin_time = time;
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
    const double covered = (time - begin_time) / end_time;
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    char         buffer[160];
    std::snprintf(buffer, sizeof(buffer), "t = %.6g s  step %u  %.0f %%", time, step, 100. * share);
    std::ostringstream out;
    out << buffer;
    if (covered > 0. && share < 1.)
      {
        const double left = elapsed * (1. - share) / covered;
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
