// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/output/run_record.h>
#include <cautery/problems/problem.h>

namespace Cautery
{
  /**
   * When the mesh of a run is to be adapted, and what is to be told of the meshes that it has left. Without
   * an adaptive mesh it is never time.
   */
  template <int dim>
  class MeshHistory
  {
  public:
    /** Arguments must live as long as it. @p first: the mesh that the run begins with. */
    MeshHistory(const Scene &scene, const Mesh<dim> &first);

    /** @p time, or when the mesh is adapted before; s. */
    double stop_before(const double time) const;

    /** Is it time? The next one is an interval later then. */
    bool is_due(const double time);

    /** The run goes on on @p next, and leaves @p before. */
    void change(const Problem<dim> &before, const Mesh<dim> &next);

    /** Into @p record: the counts and errors in time of all meshes, the last of which is that of @p present.
     */
    void tell(const Problem<dim> &present, RunRecord &record) const;

    /** @p present: the problem on the present mesh. */
    void archive(Archive &archive, const Problem<dim> &present);

  private:
    void add(const Problem<dim> &problem);

    const AdaptiveSettings          &settings;
    const double                     end;  ///< s
    double                           next; ///< time of the next adaption, s
    std::map<std::string, double>    statistics;
    std::map<std::string, TimeError> time_errors;
    RunRecord::Adaption              adaption;
  };
} // namespace Cautery
