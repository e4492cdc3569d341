// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/state.h>

namespace Cautery
{
  State State::between(const State &from, const State &to, const double share)
  {
    State result = to;
    result.time  = from.time + share * (to.time - from.time);
    for (Vector State::*part : {&State::temperature,
                                &State::temperature_rate,
                                &State::displacement,
                                &State::displacement_rate,
                                &State::ln_damage})
      if ((to.*part).size() > 0)
        (result.*part).sadd(share, 1. - share, from.*part);
    return result;
  }
} // namespace Cautery
