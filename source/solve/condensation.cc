// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/parameters.h>
#include <cautery/solve/condensation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Cautery
{
  namespace
  {
    using Entry  = std::pair<types::global_dof_index, double>;
    using Number = types::global_dof_index;

    /// Calls use(row, entries) for each row of this process, the columns being global numbers.
    template <typename Use>
    void for_each_row(const SparseMatrix &matrix, const Use &use)
    {
      const Epetra_CrsMatrix &entries = matrix.trilinos_matrix();
      std::vector<Entry>      row;
      for (int r = 0; r < entries.NumMyRows(); ++r)
        {
          int     length  = 0;
          double *values  = nullptr;
          int    *columns = nullptr;
          entries.ExtractMyRowView(r, length, values, columns);
          row.clear();
          for (int k = 0; k < length; ++k)
            if (values[k] != 0.)
              row.emplace_back(entries.GCID(columns[k]), values[k]);
          use(static_cast<unsigned int>(r), row);
        }
    }

    /// Makes a matrix of entries by rows.
    void fill(SparseMatrix                          &matrix,
              const IndexSet                        &rows,
              const IndexSet                        &columns,
              const std::vector<std::vector<Entry>> &entries,
              const MPI_Comm                         communicator)
    {
      DynamicSparsityPattern pattern(rows.size(), columns.size(), rows);
      for (unsigned int r = 0; r < entries.size(); ++r)
        for (const auto &entry : entries[r])
          pattern.add(rows.nth_index_in_set(r), entry.first);
      matrix.reinit(rows, columns, pattern, communicator);
      for (unsigned int r = 0; r < entries.size(); ++r)
        for (const auto &[column, value] : entries[r])
          matrix.set(rows.nth_index_in_set(r), column, value);
      matrix.compress(VectorOperation::insert);
    }
  } // namespace

  Condensation::Condensation(const SparseMatrix &matrix, const IndexSet &kept_unknowns)
    : communicator(matrix.get_mpi_communicator())
    , factorisation(control, TrilinosWrappers::SolverDirect::AdditionalData(false, "Amesos_Klu"))
  {
    number(matrix.locally_owned_range_indices(), kept_unknowns);
    split(matrix);
    factorise();
    complement();
  }

  void Condensation::number(const IndexSet &owned, const IndexSet &kept_unknowns)
  {
    for (unsigned int place = 0; place < owned.n_elements(); ++place)
      (kept_unknowns.is_element(owned.nth_index_in_set(place)) ? kept : rest).places.push_back(place);
    for (Part *part : {&kept, &rest})
      part->numbers = Utilities::MPI::create_ascending_partitioning(
        communicator, part->places.size())[Utilities::MPI::this_mpi_process(communicator)];
  }

  void Condensation::split(const SparseMatrix &matrix)
  {
    // The number of each unknown in its part, kept ones from 1 on, the others from -1 down: also of those of
    // other processes that this one's rows meet.
    const IndexSet      owned    = matrix.locally_owned_range_indices();
    IndexSet            relevant = owned;
    std::vector<Number> met;
    for_each_row(matrix, [&](const unsigned int, const std::vector<Entry> &row) {
      for (const auto &entry : row)
        met.push_back(entry.first);
    });
    std::sort(met.begin(), met.end());
    relevant.add_indices(met.begin(), std::unique(met.begin(), met.end()));
    Vector numbers(owned, communicator);
    for (unsigned int i = 0; i < kept.places.size(); ++i)
      numbers.begin()[kept.places[i]] = 1. + kept.numbers.nth_index_in_set(i);
    for (unsigned int i = 0; i < rest.places.size(); ++i)
      numbers.begin()[rest.places[i]] = -1. - rest.numbers.nth_index_in_set(i);
    Vector number_of(owned, relevant, communicator);
    number_of = numbers;

    std::vector<std::vector<Entry>> kk, rk, rr;
    for_each_row(matrix, [&](const unsigned int place, const std::vector<Entry> &row) {
      std::vector<Entry> to_kept, to_rest;
      for (const auto &[column, value] : row)
        if (const double number = number_of(column); number > 0.)
          to_kept.emplace_back(std::lround(number) - 1, value);
        else
          to_rest.emplace_back(std::lround(-number) - 1, value);
      if (numbers.begin()[place] > 0.)
        kk.push_back(std::move(to_kept));
      else
        {
          rk.push_back(std::move(to_kept));
          rr.push_back(std::move(to_rest));
        }
    });
    fill(kept_kept, kept.numbers, kept.numbers, kk, communicator);
    fill(rest_kept, rest.numbers, kept.numbers, rk, communicator);
    fill(rest_rest, rest.numbers, rest.numbers, rr, communicator);
  }

  void Condensation::factorise()
  {
    for (auto *vector : {&rest_load, &rest_solution, &rest_product})
      vector->reinit(rest.numbers, communicator);
    kept_product.reinit(kept.numbers, communicator);
    factorisation.initialize(rest_rest);
  }

  void Condensation::complement()
  {
    std::vector<Number> touching; // kept unknowns that touch the rest
    for_each_row(rest_kept, [&](const unsigned int, const std::vector<Entry> &row) {
      for (const auto &entry : row)
        touching.push_back(entry.first);
    });
    std::sort(touching.begin(), touching.end());
    touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
    touching = Utilities::MPI::compute_set_union(touching, communicator);
    std::sort(touching.begin(), touching.end());

    std::vector<std::vector<Entry>> rows(kept.places.size());
    std::vector<unsigned int>       own; // rows here that touch the rest
    for (const Number j : touching)
      if (kept.numbers.is_element(j))
        own.push_back(kept.numbers.index_within_set(j));
    AssertThrow(
      static_cast<double>(touching.size()) * own.size() < std::numeric_limits<int>::max(),
      ExcInput("Numerics/Kept nodes: " + std::to_string(touching.size()) +
               " kept unknowns touch the condensed ones; a dense block of so many is too large. Keep "
               "fewer, or none for no condensation"));
    FullMatrix<double> dense(own.size(), touching.size());
    Vector             unit(kept.numbers, communicator);
    for (unsigned int j = 0; j < touching.size(); ++j)
      {
        unit = 0.;
        if (kept.numbers.is_element(touching[j]))
          unit.begin()[kept.numbers.index_within_set(touching[j])] = 1.;
        rest_kept.vmult(rest_product, unit);
        factorisation.solve(rest_solution, rest_product);
        rest_kept.Tvmult(kept_product, rest_solution);
        for (unsigned int i = 0; i < own.size(); ++i)
          dense(i, j) = kept_product.begin()[own[i]];
      }

    for_each_row(kept_kept,
                 [&](const unsigned int row, const std::vector<Entry> &entries) { rows[row] = entries; });
    for (unsigned int i = 0; i < own.size(); ++i)
      {
        std::map<Number, double> sum(rows[own[i]].begin(), rows[own[i]].end());
        for (unsigned int j = 0; j < touching.size(); ++j)
          sum[touching[j]] -= dense(i, j);
        rows[own[i]].assign(sum.begin(), sum.end());
      }
    fill(schur, kept.numbers, kept.numbers, rows, communicator);
  }

  Vector Condensation::kept_part(const Vector &x) const
  {
    Vector result(kept.numbers, communicator);
    for (unsigned int i = 0; i < kept.places.size(); ++i)
      result.begin()[i] = x.begin()[kept.places[i]];
    return result;
  }

  void Condensation::reduce(const Vector &b, Vector &remaining)
  {
    for (unsigned int i = 0; i < rest.places.size(); ++i)
      rest_load.begin()[i] = b.begin()[rest.places[i]];
    remaining = kept_part(b);
    factorisation.solve(rest_solution, rest_load);
    rest_kept.Tvmult(kept_product, rest_solution);
    remaining -= kept_product;
  }

  void Condensation::recover(const Vector &remaining, Vector &x)
  {
    rest_kept.vmult(rest_product, remaining);
    rest_load -= rest_product;
    factorisation.solve(rest_solution, rest_load);
    for (unsigned int i = 0; i < rest.places.size(); ++i)
      x.begin()[rest.places[i]] = rest_solution.begin()[i];
    for (unsigned int i = 0; i < kept.places.size(); ++i)
      x.begin()[kept.places[i]] = remaining.begin()[i];
  }
} // namespace Cautery
