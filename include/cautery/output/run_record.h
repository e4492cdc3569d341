// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/cost.h>
#include <cautery/output/extremes.h>
#include <cautery/output/forecast.h>
#include <cautery/output/space_errors.h>
#include <cautery/physics/heat_balance.h>
#include <cautery/physics/time_error.h>
#include <cautery/scene/scene.h>

#include <map>
#include <optional>
#include <string>

namespace Cautery
{
  /**
   * What is said of a whole run: summary.json, and a few lines for a reader.
   */
  struct RunRecord
  {
    std::string  title;
    std::string  status = "running"; ///< "done", "failed", "stopped"
    std::string  message;
    Effects      effects;
    unsigned int dimension = 3;  ///< in two dimensions volumes and heat are those of one metre of depth
    double       end_time  = 0.; ///< reached, s

    std::optional<double> resumed_from; ///< s; none: the run began at its start

    std::map<std::string, types::global_dof_index> unknowns;
    unsigned int                                   time_steps = 0;
    unsigned int                                   steps_here = 0; ///< of them since the run was resumed
    std::map<std::string, double>                  statistics;
    Extremes                                       extremes;
    std::optional<HeatTotals>                      balance;
    std::map<std::string, TimeError>               time_errors; ///< by balance
    SpaceErrors                                    space_errors;

    struct Ablation
    {
      struct Region
      {
        std::string name;
        double      volume   = 0.; ///< dead, m^dim
        double      fraction = 0.; ///< of the region
      };
      double                        volume = 0.; ///< m^dim
      double                        radius = 0.; ///< m
      Point<3>                      centre;      ///< m
      std::map<std::string, Region> regions;     ///< by number
    };
    std::optional<Ablation> ablation;

    /** Of the mesh to the solution. */
    struct Adaption
    {
      unsigned int times      = 0; ///< that the mesh has been changed in the course of the run
      unsigned int most_cells = 0;
      unsigned int last_cells = 0;
    };
    std::optional<Adaption> adaption;

    double                          wall_seconds      = 0.;
    double                          processor_seconds = 0.; ///< of the process that took most
    double                          seconds_per_step  = 0.; ///< mean over the time loop without output
    std::map<std::string, double>   seconds_by_part;
    std::map<std::string, double>   seconds_by_effect;
    std::map<std::string, double>   bytes_by_effect;  ///< of what is built once, over all processes
    double                          peak_memory = 0.; ///< over all processes, bytes
    unsigned int                    processes   = 1;
    std::optional<Forecast::Result> forecast; ///< none: the run was shorter than a trial

    /// What an effect, or another part of a run, took.
    struct Share
    {
      std::string             effect;
      double                  seconds  = 0.;
      double                  share    = 0.; ///< of the wall time
      double                  bytes    = 0.; ///< of what is built once
      types::global_dof_index unknowns = 0;
    };

    /** The ledger, dearest first; last what no part accounts for. */
    std::vector<Share> ledger() const;

    /** Replaces @p file_name in one go. Errors: ExcRun. */
    void write(const std::string &file_name) const;

    /** The closing lines of a run. */
    std::string text() const;
  };
} // namespace Cautery
