// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/study/accuracy_study.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace Cautery
{
  namespace
  {
    /// A report's file; an error in writing it ends the study.
    template <typename Write>
    void write_file(const std::string &file_name, const Write &write)
    {
      std::ofstream file(file_name);
      file << std::setprecision(6);
      write(file);
      file.flush();
      AssertThrow(file, ExcRun("cannot write " + file_name + ": is the disk full?"));
    }

    /// As a field of a .csv file.
    auto quoted(const std::string &text) { return std::quoted(text, '"', '"'); }

    void write_csv(const AccuracyResult &result, std::ostream &out)
    {
      out << "ladder,setting,changes,quantity,seconds,peak_memory_bytes,steps,unknowns,last_value,error,"
             "reference_uncertainty,pareto\n"
          << std::setprecision(12);
      for (const auto &row : result.rows)
        for (unsigned int q = 0; row.outcome.succeeded() && q < result.quantities.size(); ++q)
          out << quoted(row.ladder) << ',' << quoted(row.variant.label) << ','
              << quoted(changes_text(row.variant.changes)) << ',' << quoted(result.quantities[q].text())
              << ',' << row.outcome.seconds << ',' << row.outcome.bytes << ',' << row.outcome.steps << ','
              << row.outcome.unknowns << ',' << row.outcome.answers[q].values.back() << ',' << row.errors[q]
              << ',' << result.references[q].uncertainty << ',' << result.on_pareto_front(row, q) << '\n';
    }

    /// The order at which the error falls from one rung to the next, or "".
    std::string observed_order(const AccuracyResult::Row *before,
                               const AccuracyResult::Row &row,
                               const unsigned int         q,
                               const Ladder              &ladder)
    {
      if (ladder.error == LadderSettings::Error::none || before == nullptr || !(row.errors[q] > 0.) ||
          !(before->errors[q] > 0.))
        return "";
      std::ostringstream text;
      text << std::fixed << std::setprecision(2)
           << std::log(before->errors[q] / row.errors[q]) / std::log(ladder.ratio);
      return text.str();
    }

    void write_ladder(const AccuracyResult &result, const Ladder &ladder, std::ostream &out)
    {
      out << "\n### " << ladder.name << "\n\n| setting | seconds | MB | steps | unknowns |";
      for (const auto &quantity : result.quantities)
        out << ' ' << quantity.text() << ": error |"
            << (ladder.error == LadderSettings::Error::none ? "" : " order |");
      out << "\n|---|---|---|---|---|";
      for (unsigned int q = 0; q < result.quantities.size(); ++q)
        out << (ladder.error == LadderSettings::Error::none ? "---|" : "---|---|");
      out << '\n';
      const AccuracyResult::Row *before = nullptr;
      for (const auto &row : result.rows)
        {
          if (row.ladder != ladder.name)
            continue;
          out << "| " << row.variant.label << " | ";
          if (!row.outcome.succeeded())
            {
              out << "failed: " << row.outcome.message << " |\n";
              continue;
            }
          out << std::setprecision(3) << row.outcome.seconds << " | " << std::round(1e-6 * row.outcome.bytes)
              << " | " << row.outcome.steps << " | " << row.outcome.unknowns << " |";
          for (unsigned int q = 0; q < result.quantities.size(); ++q)
            {
              out << ' ' << std::setprecision(3) << row.errors[q] << result.quantities[q].unit()
                  << (result.on_pareto_front(row, q) ? " *" : "") << " |";
              if (ladder.error != LadderSettings::Error::none)
                out << ' ' << observed_order(before, row, q, ladder) << " |";
            }
          out << '\n';
          before = &row;
        }
    }

    std::string setting_text(const AccuracyResult::Row &row)
    {
      return row.variant.changes.empty() ? "the scene as it is" :
                                           "`" + changes_text(row.variant.changes) + "`";
    }

    /// What the reader came for: a line for each quantity and tolerance.
    void write_cheapest(const AccuracyResult &result, const AccuracySettings &settings, std::ostream &out)
    {
      for (unsigned int q = 0; q < result.quantities.size(); ++q)
        for (const double tolerance : result.tolerances(q, settings))
          {
            out << "- " << result.quantities[q].text() << " within " << std::setprecision(3) << tolerance
                << result.quantities[q].unit() << ": ";
            const auto *row = result.cheapest(q, tolerance);
            if (result.references[q].uncertainty > tolerance)
              out << "cannot be told, the reference itself is uncertain by "
                  << result.references[q].uncertainty << result.quantities[q].unit() << '\n';
            else if (row == nullptr)
              out << "no setting of these ladders\n";
            else
              out << setting_text(*row) << ", " << row->outcome.seconds << " s\n";
          }
    }

    void write_markdown(const AccuracyResult &result, const AccuracySettings &settings, std::ostream &out)
    {
      out << "# What accuracy costs" << (result.title.empty() ? "" : ": " + result.title) << "\n\n"
          << "Processor time of whole runs on " << result.processes
          << (result.processes == 1 ? " process" : " processes")
          << "; errors are the largest at all output times asked for. * : no other run is both cheaper and "
             "more "
             "accurate.\n\n## Cheapest settings\n\n";
      write_cheapest(result, settings, out);
      out << "\n## References\n\n| quantity | last value | its own estimated error | what it is "
             "|\n|---|---|---|---|\n";
      for (unsigned int q = 0; q < result.quantities.size(); ++q)
        out << "| " << result.quantities[q].text() << " | " << std::setprecision(8)
            << result.references[q].answer.values.back() << " | " << std::setprecision(2)
            << result.references[q].uncertainty << " | " << result.references[q].origin << " |\n";
      out << "\n## Ladders\n";
      for (const auto &ladder : result.ladders)
        write_ladder(result, ladder, out);
      if (!result.left_out.empty())
        out << "\nNot run, because they do not fit the scene:\n\n";
      for (const auto &reason : result.left_out)
        out << "- " << reason << '\n';
      out << "\n## Pictures\n\n";
      for (unsigned int q = 0; q < result.quantities.size(); ++q)
        out << "![" << result.quantities[q].text() << "](accuracy_" << q << ".png)\n";
    }

    /// For each quantity a block of points for every ladder, then one of the Pareto front.
    void write_points(const AccuracyResult &result, std::ostream &out)
    {
      const auto block = [&](const unsigned int q, const auto &belongs) {
        std::vector<std::pair<double, double>> points;
        for (const auto &row : result.rows)
          if (row.outcome.succeeded() && belongs(row) && row.errors[q] > 0.)
            points.emplace_back(row.outcome.seconds, row.errors[q]);
        if (points.empty())
          points.emplace_back(std::nan(""), std::nan(""));
        return points;
      };
      for (unsigned int q = 0; q < result.quantities.size(); ++q)
        {
          for (const auto &ladder : result.ladders)
            {
              for (const auto &[seconds, error] :
                   block(q, [&](const AccuracyResult::Row &row) { return row.ladder == ladder.name; }))
                out << seconds << ' ' << error << '\n';
              out << "\n\n";
            }
          auto front =
            block(q, [&](const AccuracyResult::Row &row) { return result.on_pareto_front(row, q); });
          std::sort(front.begin(), front.end());
          for (const auto &[seconds, error] : front)
            out << seconds << ' ' << error << '\n';
          out << "\n\n";
        }
    }

    /// In single quotes gnuplot takes all other characters as they stand; in double quotes it would run what
    /// stands between backquotes.
    std::string verbatim(std::string text)
    {
      std::replace(text.begin(), text.end(), '\'', '"');
      return '\'' + text + '\'';
    }

    void write_gnuplot(const AccuracyResult &result, std::ostream &out)
    {
      out << "set terminal pngcairo noenhanced size 900,600 font 'sans,11'\nset logscale xy\nset format xy "
             "'%g'\nset "
             "grid\n"
             "set key outside right top\nset xlabel 'processor time, s'\n";
      const unsigned int blocks = result.ladders.size() + 1;
      for (unsigned int q = 0; q < result.quantities.size(); ++q)
        {
          out << "set output 'accuracy_" << q << ".png'\nset title " << verbatim(result.title)
              << "\nset ylabel " << verbatim("error of " + result.quantities[q].text()) << "\nplot ";
          for (unsigned int l = 0; l < result.ladders.size(); ++l)
            out << "'accuracy.dat' index " << q * blocks + l << " with linespoints lw 1.5 pt 7 title "
                << verbatim(result.ladders[l].name) << ", ";
          if (result.references[q].uncertainty > 0.)
            out << result.references[q].uncertainty
                << " with lines dt 2 lc 'gray40' title \"reference uncertain\", ";
          out << "'accuracy.dat' index " << q * blocks + result.ladders.size()
              << " with linespoints lw 1 dt 3 lc 'black' pt 6 ps 2 title \"Pareto front\"\n";
        }
    }

    /// Pictures are gnuplot's, where it is installed.
    void draw(const std::string &directory)
    {
      const auto here = std::filesystem::current_path();
      std::filesystem::current_path(directory);
      const int status = std::system("gnuplot accuracy.gnuplot > /dev/null 2>&1");
      std::filesystem::current_path(here);
      if (status != 0)
        std::cout << "No pictures: `gnuplot accuracy.gnuplot` does not run here; try it in " << directory
                  << '\n';
    }

    void write_scenes(const AccuracyResult   &result,
                      const Origin           &origin,
                      const AccuracySettings &settings,
                      const std::string      &directory)
    {
      for (unsigned int q = 0; q < result.quantities.size(); ++q)
        {
          const auto tolerances = result.tolerances(q, settings);
          for (unsigned int i = 0; i < tolerances.size(); ++i)
            if (const auto *row = result.cheapest(q, tolerances[i]))
              if (result.references[q].uncertainty <= tolerances[i])
                write_file(directory + "/cheapest_" + std::to_string(q) + "_" + std::to_string(i) + ".prm",
                           [&](std::ostream &out) {
                             auto changes = row->variant.changes;
                             changes.push_back({"Accuracy/Temperature within", "0"});
                             out << "# " << result.quantities[q].text() << " within " << tolerances[i]
                                 << result.quantities[q].unit() << ", in " << row->outcome.seconds << " s\n"
                                 << origin.scene(changes).complete_text;
                           });
        }
    }
  } // namespace

  void report_accuracy(const AccuracyResult &result,
                       const Origin         &origin,
                       const Scene          &scene,
                       const std::string    &directory)
  {
    write_file(directory + "/accuracy.csv", [&](std::ostream &out) { write_csv(result, out); });
    write_file(directory + "/accuracy.md",
               [&](std::ostream &out) { write_markdown(result, scene.accuracy, out); });
    write_file(directory + "/accuracy.dat", [&](std::ostream &out) { write_points(result, out); });
    write_file(directory + "/accuracy.gnuplot", [&](std::ostream &out) { write_gnuplot(result, out); });
    write_scenes(result, origin, scene.accuracy, directory);
    draw(directory);
    std::cout << '\n';
    write_cheapest(result, scene.accuracy, std::cout);
    std::cout << "Results        " << directory << "/accuracy.md\n";
  }
} // namespace Cautery
