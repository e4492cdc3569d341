// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/interruption.h>

#include <array>
#include <csignal>
#include <utility>

namespace Cautery
{
  namespace
  {
    // a handler may touch nothing else
    volatile std::sig_atomic_t save_asked = 0, stop_asked = 0;

    void ask(const int signal) { (signal == SIGUSR1 ? save_asked : stop_asked) = 1; }

    constexpr std::array<int, 3>    signals = {{SIGUSR1, SIGTERM, SIGINT}};
    std::array<struct sigaction, 3> before;
  } // namespace

  Interruption::Interruption()
  {
    save_asked = stop_asked = 0;
    for (unsigned int i = 0; i < signals.size(); ++i)
      {
        struct sigaction action = {};
        action.sa_handler       = ask;
        sigemptyset(&action.sa_mask);
        // calls of the system go on; the second request to stop meets what was before
        action.sa_flags = SA_RESTART | (signals[i] == SIGUSR1 ? 0 : static_cast<int>(SA_RESETHAND));
        sigaction(signals[i], &action, &before[i]);
        if (before[i].sa_handler == SIG_IGN) // as under nohup
          sigaction(signals[i], &before[i], nullptr);
      }
  }

  Interruption::~Interruption()
  {
    for (unsigned int i = 0; i < signals.size(); ++i)
      sigaction(signals[i], &before[i], nullptr);
  }

  Interruption::Wish Interruption::wish()
  {
    if (stop_asked != 0)
      {
        stop_asked = 0;
        return Wish::stop;
      }
    if (save_asked == 0)
      return Wish::none;
    save_asked = 0;
    return Wish::save;
  }
} // namespace Cautery
