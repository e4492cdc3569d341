// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Cautery
{
  /**
   * While it lives, SIGUSR1, SIGTERM and SIGINT are not obeyed at once but kept until somebody asks. A second
   * SIGTERM or SIGINT ends the process as ever.
   */
  class Interruption
  {
  public:
    enum class Wish
    {
      none,
      save, ///< SIGUSR1
      stop  ///< SIGTERM or SIGINT
    };

    Interruption();
    ~Interruption();
    Interruption(const Interruption &)            = delete;
    Interruption &operator=(const Interruption &) = delete;

    /** What this process has been asked for since the last call. */
    Wish wish();
  };
} // namespace Cautery
