// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/heat_sources.h>
#include <cautery/scene/accuracy_settings.h>
#include <cautery/scene/boundary.h>
#include <cautery/scene/effects.h>
#include <cautery/scene/mesh_settings.h>
#include <cautery/scene/numerics.h>
#include <cautery/scene/output_settings.h>
#include <cautery/scene/tissue.h>
#include <cautery/scene/tool.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * What happens to damage between two steps: section "Damage".
   */
  struct DamageSettings
  {
    enum class Quadrature
    {
      end_of_step, ///< thesis Eq. 6-24
      exponential  ///< the rate's logarithm is a straight line in the step
    };
    Quadrature quadrature = Quadrature::exponential;

    void parameters(Parameters &p);
  };

  /**
   * Everything that a user asked for: plain data, checked once, then unchanged.
   */
  struct Scene
  {
    std::string             title;
    unsigned int            dimension           = 3;
    Expression              initial_temperature = 310.; ///< K
    MeshSettings            mesh;
    Effects                 effects;
    std::vector<Tissue>     tissues;
    std::vector<HeatSource> heat_sources;
    std::vector<Boundary>   boundaries;
    Loads                   loads;
    std::vector<Tool>       tools;
    TimeSettings            time;
    Numerics                numerics;
    DamageSettings          damage;
    OutputSettings          output;
    AccuracySettings        accuracy;

    std::string complete_text; ///< all entries with their values, ready to be run again
    std::string identity;      ///< the same without what a run may resume with another value of

    /** Are motion or heat advanced by explicit steps? */
    bool has_explicit_loop() const;

    /** Must the linear operators be assembled anew while time goes on? */
    bool thermal_properties_change() const;
    bool elastic_properties_change() const;
  };

  /** An entry given on the command line: "Section/Entry" and its value. */
  struct Override
  {
    std::string path;
    std::string value;
  };

  /** Of "Section/Entry = value". Errors: ExcInput, saying @p remedy. */
  Override parse_override(const std::string &text, const std::string &remedy);

  /**
   * Reads and checks @p file_name; @p overrides replace entries of the file.
   * Errors: ExcInput with file, line or parameter, value and remedy.
   */
  Scene read_scene(const std::string &file_name, const std::vector<Override> &overrides);

  /** The documented template of a scene with all defaults and one heat source of every type. */
  std::string parameter_reference();
} // namespace Cautery
