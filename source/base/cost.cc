// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/cost.h>

#include <deal.II/base/utilities.h>

#include <fstream>
#include <malloc.h>

namespace Cautery
{
  namespace
  {
    double heap()
    {
      const auto info = mallinfo2();
      return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
    }
  } // namespace

  Cost::Growth::Growth(double &sum) : sum(sum), before(heap()) {}

  Cost::Growth::~Growth() { sum += heap() - before; }

  std::map<std::string, double> Cost::seconds_by_effect() const
  {
    std::map<std::string, double> effects;
    for (const auto &[part, spent] : seconds)
      effects[effect_of(part)] += spent;
    return effects;
  }

  double Cost::wall_seconds() const { return total.wall_time(); }

  double Cost::processor_seconds() const { return total.cpu_time(); }

  void Cost::forget_peak_memory()
  {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5; // see proc(5)
  }

  double Cost::peak_memory()
  {
    Utilities::System::MemoryStats stats;
    Utilities::System::get_memory_stats(stats);
    return 1024. * stats.VmHWM;
  }
} // namespace Cautery
