// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/study/study_progress.h>

#include <iomanip>
#include <iostream>

namespace Cautery
{
  void StudyProgress::say(const std::string &what, const Outcome &outcome)
  {
    ++done;
    if (!speaks)
      return;
    std::cout << "  " << std::setw(3) << done;
    if (n_runs > 0)
      std::cout << " of " << n_runs;
    std::cout << "  " << std::left << std::setw(52) << what << std::right;
    if (outcome.succeeded())
      std::cout << std::setw(9) << std::setprecision(3) << outcome.seconds << " s"
                << (outcome.is_new ? "" : "  (kept)");
    else
      std::cout << "  failed: " << outcome.message;
    std::cout << "  [" << static_cast<int>(timer.wall_time()) << " s so far]" << std::endl;
  }
} // namespace Cautery
