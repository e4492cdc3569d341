// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/study/reference.h>

namespace Cautery
{
  /**
   * What accuracy costs in time for a scene: all runs of its ladders, each with its error.
   */
  struct AccuracyResult
  {
    /// A rung that was run.
    struct Row
    {
      std::string         ladder;
      Variant             variant;
      Outcome             outcome;
      std::vector<double> errors; ///< of each quantity; empty where the run failed
    };

    std::string              title;
    std::vector<Quantity>    quantities;
    std::vector<Reference>   references; ///< of each quantity
    std::vector<Ladder>      ladders;
    std::vector<Row>         rows;     ///< first the scene as it is, then ladder after ladder
    std::vector<std::string> left_out; ///< standard ladders that do not fit the scene, with the reason
    unsigned int             processes = 1;

    /** The tolerances that quantity @p q is judged by, in its unit, falling. */
    std::vector<double> tolerances(const unsigned int q, const AccuracySettings &settings) const;

    /** The row of least seconds whose error in @p q is at most @p tolerance; nullptr: none. */
    const Row *cheapest(const unsigned int q, const double tolerance) const;

    /** Is no other row both cheaper and more accurate in @p q? */
    bool on_pareto_front(const Row &row, const unsigned int q) const;
  };

  /**
   * Runs the ladders of @p scene below @p directory, showing progress, and judges them. Finished runs of an
   * earlier call are not repeated. Collective. Errors: ExcInput.
   */
  AccuracyResult study_accuracy(const Origin      &origin,
                                const Scene       &scene,
                                const std::string &directory,
                                const MPI_Comm     communicator);

  /** Writes accuracy.csv, accuracy.md, pictures, and the cheapest settings as scenes. Process 0 only. */
  void report_accuracy(const AccuracyResult &result,
                       const Origin         &origin,
                       const Scene          &scene,
                       const std::string    &directory);
} // namespace Cautery
