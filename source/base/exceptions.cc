// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/exceptions.h>

#include <deal.II/base/utilities.h>

#include <sstream>

namespace Cautery
{
  std::string message_of(const std::exception &exception)
  {
    const auto *told = dynamic_cast<const ExceptionBase *>(&exception);
    if (told == nullptr)
      return exception.what();
    std::ostringstream message;
    told->print_info(message);
    return Utilities::trim(message.str());
  }
} // namespace Cautery
