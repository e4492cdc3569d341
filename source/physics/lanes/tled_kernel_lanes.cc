// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled once for each instruction set: CAUTERY_FILL names the function to define, CAUTERY_LANE_BYTES is
// the size of a register. Nothing but lanes.h and the laws may be included here and in the headers beside
// this file, see there.
#include <cautery/physics/lanes/hexahedra.h>
#include <cautery/physics/lanes/nodes.h>
#include <cautery/physics/lanes/tetrahedra.h>

namespace Cautery
{
  namespace
  {
    template <typename Number>
    using Sweep = typename TledKernel<Number>::Sweep;

    template <typename Number, Law law, int n_fibres, StretchForm form, Conduction conduction>
    Sweep<Number> find_shape(const SweepChoice &choice)
    {
      if (choice.averaged_pressure)
        {
          if constexpr (law == Law::neo_hookean)
            if (!choice.hexahedra)
              return sweep_tetrahedra<TermsOf<law, form, n_fibres, conduction, true>, Number>;
          return nullptr;
        }
      using These = TermsOf<law, form, n_fibres, conduction, false>;
      return choice.hexahedra ? sweep_hexahedra<These, Number> : sweep_tetrahedra<These, Number>;
    }

    template <typename Number, Law law, int n_fibres, StretchForm form>
    Sweep<Number> find_conduction(const SweepChoice &choice)
    {
      switch (choice.conduction)
        {
        case Conduction::reference:
          return find_shape<Number, law, n_fibres, form, Conduction::reference>(choice);
        case Conduction::deformed:
          return find_shape<Number, law, n_fibres, form, Conduction::deformed>(choice);
        default:
          return find_shape<Number, law, n_fibres, form, Conduction::none>(choice);
        }
    }

    template <typename Number, Law law, int n_fibres>
    Sweep<Number> find_stretch(const SweepChoice &choice)
    {
      switch (choice.stretch)
        {
        case StretchForm::linearised:
          return find_conduction<Number, law, n_fibres, StretchForm::linearised>(choice);
        case StretchForm::exact:
          return find_conduction<Number, law, n_fibres, StretchForm::exact>(choice);
        default:
          return find_conduction<Number, law, n_fibres, StretchForm::none>(choice);
        }
    }

    template <typename Number>
    Sweep<Number> find(const SweepChoice &choice)
    {
      switch (choice.law)
        {
        case Law::none:
          return choice.conduction == Conduction::deformed ?
                   find_shape<Number, Law::none, 0, StretchForm::none, Conduction::deformed>(choice) :
                   find_shape<Number, Law::none, 0, StretchForm::none, Conduction::reference>(choice);
        case Law::small_strain:
          return find_stretch<Number, Law::small_strain, 0>(choice);
        default:
          return choice.n_fibres == 0 ? find_stretch<Number, Law::neo_hookean, 0>(choice) :
                 choice.n_fibres == 1 ? find_stretch<Number, Law::neo_hookean, 1>(choice) :
                                        find_stretch<Number, Law::neo_hookean, some_fibres>(choice);
        }
    }

    template <typename Number>
    Sweep<Number> find_volumes(const SweepChoice &choice)
    {
      switch (choice.stretch)
        {
        case StretchForm::linearised:
          return sweep_volumes<StretchForm::linearised, Number>;
        case StretchForm::exact:
          return sweep_volumes<StretchForm::exact, Number>;
        default:
          return sweep_volumes<StretchForm::none, Number>;
        }
    }

    template <typename Number>
    constexpr TledKernel<Number> kernel_of_lanes = {
      lanes<Number>, any_step<Number>, any_pressures<Number>, find<Number>, find_volumes<Number>};
  } // namespace

  void CAUTERY_FILL(TledKernel<float> &kernel) { kernel = kernel_of_lanes<float>; }
  void CAUTERY_FILL(TledKernel<double> &kernel) { kernel = kernel_of_lanes<double>; }
} // namespace Cautery
