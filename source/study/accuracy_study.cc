// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/study/accuracy_study.h>
#include <cautery/study/study_progress.h>

#include <algorithm>
#include <iostream>

namespace Cautery
{
  namespace
  {
    std::string folder_of(const std::string &ladder, const unsigned int rung)
    {
      std::string name = ladder + "_" + std::to_string(rung);
      std::replace_if(
        name.begin(), name.end(), [](const char c) { return c == '/' || c == ' '; }, '_');
      return name;
    }

    /// Of quantity @p q, ladder by ladder, without the runs that failed.
    std::vector<std::vector<Series>> answers_by_ladder(const AccuracyResult &result, const unsigned int q)
    {
      std::vector<std::vector<Series>> answers(result.ladders.size());
      for (unsigned int l = 0; l < result.ladders.size(); ++l)
        for (const auto &row : result.rows)
          if (row.ladder == result.ladders[l].name && row.outcome.succeeded())
            answers[l].push_back(row.outcome.answers[q]);
      return answers;
    }

    Series exact_series(const std::string &text, const Series &like)
    {
      const Expression expression(text);
      Series           series = like;
      for (unsigned int i = 0; i < series.times.size(); ++i)
        series.values[i] = expression.value(Point<3>(), series.times[i]);
      return series;
    }

    /// The finer run that counts for true, and runs that tell how wrong it is.
    struct FinerRun
    {
      Outcome                                     outcome;
      std::vector<std::pair<Outcome, Coarsening>> coarser;

      /// The estimated error in quantity @p q, from mesh and steps together.
      double error(const unsigned int q) const
      {
        double sum = 0.;
        for (const auto &[other, coarsening] : coarser)
          sum += coarsening.share * other.answers[q].distance(outcome.answers[q]);
        return sum;
      }
    };

    void find_references(AccuracyResult         &result,
                         const AccuracySettings &settings,
                         const Outcome          &base,
                         const FinerRun         &finer)
    {
      const auto exact = Utilities::split_string_list(settings.exact, ';');
      AssertThrow(
        settings.reference != AccuracySettings::Reference::exact || exact.size() == result.quantities.size(),
        ExcInput("Accuracy/Exact values = " + settings.exact + ": there are " + std::to_string(exact.size()) +
                 " for " + std::to_string(result.quantities.size()) + " quantities"));
      for (unsigned int q = 0; q < result.quantities.size(); ++q)
        switch (settings.reference)
          {
          case AccuracySettings::Reference::exact:
            result.references.push_back({exact_series(exact[q], base.answers[q]), 0., "exact: " + exact[q]});
            break;
          case AccuracySettings::Reference::finer_run:
            result.references.push_back(
              {finer.outcome.answers[q], finer.error(q), "a finer run: " + settings.finer_run});
            break;
          case AccuracySettings::Reference::richardson:
            result.references.push_back(
              richardson_reference(base.answers[q], result.ladders, answers_by_ladder(result, q)));
          }
    }

    void require_success(const Outcome &outcome, const std::string &what)
    {
      AssertThrow(
        outcome.succeeded(),
        ExcInput("Accuracy: " + what + " fails, so nothing can be compared with it: " + outcome.message));
    }

    /// @p run takes a folder, what to say, and the changes.
    template <typename Run>
    FinerRun run_finer(const Origin &origin, const AccuracySettings &settings, const Run &run)
    {
      const auto  changes = parse_changes(settings.finer_run, "Accuracy/Finer run");
      const Scene fine    = origin.scene(changes);
      FinerRun    finer;
      for (const auto &[what, coarsening] : {std::make_pair("coarser_mesh", with_coarser_mesh(fine)),
                                             std::make_pair("coarser_steps", with_coarser_steps(fine))})
        {
          auto coarser = changes;
          coarser.insert(coarser.end(), coarsening.changes.begin(), coarsening.changes.end());
          finer.coarser.emplace_back(run(what, "reference, less fine", coarser), coarsening);
          require_success(finer.coarser.back().first, "the less fine reference");
        }
      finer.outcome = run("finer", "reference", changes);
      require_success(finer.outcome, "the reference");
      return finer;
    }
  } // namespace

  std::vector<double> AccuracyResult::tolerances(const unsigned int q, const AccuracySettings &settings) const
  {
    std::vector<double> tolerances = settings.tolerances;
    if (tolerances.empty())
      for (const double share : {1., 0.1, 0.01})
        tolerances.push_back(quantities[q].is_temperature() ? share :
                                                              0.1 * share * references[q].answer.size());
    std::sort(tolerances.rbegin(), tolerances.rend());
    return tolerances;
  }

  const AccuracyResult::Row *AccuracyResult::cheapest(const unsigned int q, const double tolerance) const
  {
    const Row *best = nullptr;
    for (const auto &row : rows)
      if (row.outcome.succeeded() && row.errors[q] <= tolerance &&
          (best == nullptr || row.outcome.seconds < best->outcome.seconds))
        best = &row;
    return best;
  }

  bool AccuracyResult::on_pareto_front(const Row &row, const unsigned int q) const
  {
    return row.outcome.succeeded() && std::none_of(rows.begin(), rows.end(), [&](const Row &other) {
             return other.outcome.succeeded() && other.outcome.seconds < row.outcome.seconds &&
                    other.errors[q] <= row.errors[q];
           });
  }

  AccuracyResult study_accuracy(const Origin      &origin,
                                const Scene       &scene,
                                const std::string &directory,
                                const MPI_Comm     communicator)
  {
    AccuracyResult result;
    result.title      = scene.title;
    result.processes  = Utilities::MPI::n_mpi_processes(communicator);
    result.quantities = quantities_of(scene);
    result.ladders    = make_ladders(origin, scene, result.left_out);

    const bool   speaks    = Utilities::MPI::this_mpi_process(communicator) == 0;
    const bool   has_finer = scene.accuracy.reference == AccuracySettings::Reference::finer_run;
    unsigned int n_runs    = has_finer ? 4 : 1;
    for (const auto &ladder : result.ladders)
      n_runs += ladder.rungs.size();
    if (speaks)
      std::cout << (scene.title.empty() ? "" : scene.title + "\n") << "What accuracy costs: " << n_runs
                << " runs below " << directory << std::endl;

    StudyProgress progress(n_runs, speaks);
    Runner     runner(origin, result.quantities, scene.accuracy.repeats, directory + "/runs", communicator);
    const auto run =
      [&](const std::string &folder, const std::string &what, const std::vector<Override> &changes) {
        Outcome outcome = runner.run(folder, changes);
        progress.say(what, outcome);
        return outcome;
      };

    result.rows.push_back({"scene", {"as it is", {}}, run("scene", "the scene as it is", {}), {}});
    require_success(result.rows.front().outcome, "the scene as it is");
    require_answers(result.quantities, result.rows.front().outcome, directory);
    for (const auto &ladder : result.ladders)
      for (unsigned int i = 0; i < ladder.rungs.size(); ++i)
        result.rows.push_back({ladder.name,
                               ladder.rungs[i],
                               run(folder_of(ladder.name, i),
                                   ladder.name + ": " + ladder.rungs[i].label,
                                   ladder.rungs[i].changes),
                               {}});
    const FinerRun finer = has_finer ? run_finer(origin, scene.accuracy, run) : FinerRun();
    const Outcome  base  = result.rows.front().outcome;
    find_references(result, scene.accuracy, base, finer);
    for (auto &row : result.rows)
      if (row.outcome.succeeded())
        for (unsigned int q = 0; q < result.quantities.size(); ++q)
          row.errors.push_back(row.outcome.answers[q].distance(result.references[q].answer));
    return result;
  }
} // namespace Cautery
