// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * The terms that a scene turns on: this list is the model. What is off has no unknowns, no memory and no
   * work. Section "Effects".
   */
  struct Effects
  {
    enum class Heat
    {
      off,
      fourier,    ///< thesis Eq. 4-22
      non_fourier ///< thesis Eq. 6-8
    };
    enum class Jumps
    {
      consistent, ///< a source that is switched makes dT/dt jump by Q/(rho C)
      neglected   ///< the thesis's: only the smooth part of dQ/dt
    };
    enum class Conduction
    {
      reference_body,
      deformed_body ///< Fourier's law holds where the tissue has moved to
    };
    enum class Metabolism
    {
      off,
      constant,
      q10 ///< thesis Eq. 4-17
    };
    enum class Deformation
    {
      off,
      equilibrium,
      inertia, ///< thesis Eq. 4-25
      large_equilibrium,
      explicit_dynamics ///< large, thesis 7.3.2
    };
    enum class Coupling
    {
      off,
      expansion, ///< one way: heat deforms
      two_way    ///< and deformation cools: beta T_0 div du/dt
    };
    enum class Damage
    {
      off,
      critical_thermal_load,           ///< thesis Eq. 2-1
      arrhenius,                       ///< Eq. 2-2
      thermal_strain_energy,           ///< Eqs. 2-3, 2-4
      thermo_mechanical_strain_energy, ///< Eq. 5-7
      cem43
    };

    Heat        heat                             = Heat::fourier;
    Jumps       source_jumps                     = Jumps::consistent;
    Conduction  conduction                       = Conduction::reference_body;
    bool        perfusion                        = false;
    bool        perfusion_stops_in_dead_tissue   = false;
    Metabolism  metabolism                       = Metabolism::off;
    bool        heat_sources                     = true;
    Deformation deformation                      = Deformation::off;
    Coupling    coupling                         = Coupling::off;
    bool        gravity                          = false;
    bool        temperature_dependent_properties = false;
    Damage      damage                           = Damage::off;

    bool has_heat() const { return heat != Heat::off; }
    bool has_deformation() const { return deformation != Deformation::off; }
    bool has_large_deformation() const
    {
      return deformation == Deformation::large_equilibrium || deformation == Deformation::explicit_dynamics;
    }
    bool has_damage() const { return damage != Damage::off; }
    bool damage_needs_strain_energy() const
    {
      return damage == Damage::thermal_strain_energy || damage == Damage::thermo_mechanical_strain_energy;
    }

    void parameters(Parameters &p);

    /** Throws ExcInput where effects contradict each other. */
    void check() const;

    /** What is on, as "heat: Fourier", ... */
    std::vector<std::string> on() const;
    /** What is off. */
    std::vector<std::string> off() const;
  };
} // namespace Cautery
