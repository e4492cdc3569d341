// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/output/ablation_zone.h>
#include <cautery/output/extremes.h>
#include <cautery/output/probes.h>
#include <cautery/output/run_record.h>
#include <cautery/problems/problem.h>

#include <memory>
#include <string>
#include <vector>

namespace Cautery
{
  /**
   * Those who look at a run: some after each step, the others at output times. What the latter see besides
   * the state (strain and stress, forces, errors in space) is found for them here, and only where it is asked
   * for.
   */
  template <int dim>
  class Audience
  {
  public:
    /** Arguments must live as long as it. Collective. */
    Audience(const Scene &scene, const Body<dim> &body, Cost &cost);

    /** Those who write do so in @p directory. */
    void write_to(const std::string &directory);

    /** After a step. */
    void follow(const State &state) { extremes.observe(state, dim); }

    /** At an output, of a state that @p problem has completed. Collective. Errors: ExcRun. */
    void look(const State &state, Problem<dim> &problem);
    /** The same, of a part of a load. */
    void look(const BorneLoad &borne, Problem<dim> &problem);

    /** The mesh has been adapted: @p next is in the place of the body so far. Collective. */
    void use(const Body<dim> &next);

    /** K; collective. */
    double hottest_now() const;

    /** What has been seen so far. Collective. */
    void archive(Archive &archive);
    /** How far the files have come; see Observer. */
    void archive_files(Archive &archive);

    /** What a whole run is told by. Collective. */
    void tell(RunRecord &record) const;

  private:
    void look(const State &state, Problem<dim> &problem, const std::optional<Vector> &unbalanced);
    std::vector<Observer<dim> *> all() const;
    RunRecord::Ablation          ablated() const;

    const Scene                                &scene;
    const Body<dim>                            *body;
    Cost                                       &cost;
    std::unique_ptr<Probes<dim>>                probes;
    std::unique_ptr<AblationZone<dim>>          ablation;
    std::vector<std::unique_ptr<Observer<dim>>> others;
    Extremes                                    extremes;
    SpaceErrors                                 space_errors;
  };
} // namespace Cautery
