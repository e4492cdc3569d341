// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/tled_kernel.h>

namespace Cautery
{
  // one pair for each compilation of lanes/tled_kernel_lanes.cc
  void fill_x86_64(TledKernel<float> &);
  void fill_x86_64(TledKernel<double> &);
  void fill_x86_64_v3(TledKernel<float> &);
  void fill_x86_64_v3(TledKernel<double> &);
  void fill_x86_64_v4(TledKernel<float> &);
  void fill_x86_64_v4(TledKernel<double> &);

  std::vector<InstructionSet> instruction_sets()
  {
    std::vector<InstructionSet> result = {InstructionSet::x86_64};
    if (__builtin_cpu_supports("x86-64-v3"))
      result.push_back(InstructionSet::x86_64_v3);
    if (__builtin_cpu_supports("x86-64-v4"))
      result.push_back(InstructionSet::x86_64_v4);
    return result;
  }

  InstructionSet best_instruction_set() { return instruction_sets().back(); }

  std::string name(const InstructionSet instruction_set)
  {
    switch (instruction_set)
      {
      case InstructionSet::x86_64_v4:
        return "x86-64-v4";
      case InstructionSet::x86_64_v3:
        return "x86-64-v3";
      default:
        return "x86-64";
      }
  }

  template <typename Number>
  TledKernel<Number> tled_kernel(const InstructionSet instruction_set)
  {
    TledKernel<Number> kernel;
    switch (instruction_set)
      {
      case InstructionSet::x86_64_v4:
        fill_x86_64_v4(kernel);
        break;
      case InstructionSet::x86_64_v3:
        fill_x86_64_v3(kernel);
        break;
      default:
        fill_x86_64(kernel);
      }
    return kernel;
  }

  template TledKernel<float>  tled_kernel<float>(const InstructionSet);
  template TledKernel<double> tled_kernel<double>(const InstructionSet);
} // namespace Cautery
