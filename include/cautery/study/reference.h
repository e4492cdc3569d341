// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/study/ladder.h>
#include <cautery/study/outcome.h>

namespace Cautery
{
  /**
   * What counts for true in a study, for one quantity.
   */
  struct Reference
  {
    Series      answer;
    double      uncertainty = 0.; ///< its own estimated error, in the quantity's unit
    std::string origin;           ///< for the report: what it is
  };

  /**
   * What the answers of a ladder tend to.
   */
  struct Limit
  {
    Series answer;
    double uncertainty  = 0.;
    bool   extrapolated = false; ///< else it is that of the last rung
  };

  /**
   * Richardson's extrapolation from the last three of @p answers, coarse to fine, with the rate at which they
   * approach each other; where that is not steady, the last one. Uncertain is, from four answers on, how far
   * the extrapolation moved with the last one, else what it adds to the last one. Answers that approach each
   * other faster than any method does are not trusted. At least two answers.
   * @param ratio of the lengths of neighbouring rungs.
   */
  Limit extrapolate(const std::vector<Series> &answers, const double ratio);

  /**
   * The scene's own answer with the corrections from the errors in space, in time and of the solvers, each by
   * the ladder that knows its limit best: good as long as these errors are small enough to add up.
   */
  Reference richardson_reference(const Series                           &base,
                                 const std::vector<Ladder>              &ladders,
                                 const std::vector<std::vector<Series>> &answers);

  /// Settings less fine than a scene's, and how much further they are from the truth than these are from each
  /// other.
  struct Coarsening
  {
    std::vector<Override> changes;
    double                share = 1.; ///< of the difference that the scene itself still errs by
  };

  /** Cells twice as large: the error, of order degree + 1, falls by that power of 2. Of a mesh file that is
   * not refined, nothing. */
  Coarsening with_coarser_mesh(const Scene &scene);
  /** Steps twice as long (order 1), or IDA's tolerances ten times as large. */
  Coarsening with_coarser_steps(const Scene &scene);
} // namespace Cautery
