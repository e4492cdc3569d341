// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/elimination.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Cautery
{
  void Elimination::reinit(const AffineConstraints<double> &constraints,
                           const IndexSet                  &owned,
                           const MPI_Comm                   communicator)
  {
    lines.clear();
    partitioner.reset();
    n_owned = owned.n_elements();
    std::vector<types::global_dof_index> elsewhere;
    for (const auto &line : constraints.get_lines())
      if (owned.is_element(line.index))
        for (const auto &entry : line.entries)
          if (!owned.is_element(entry.first))
            elsewhere.push_back(entry.first);
    IndexSet ghosts(owned.size());
    std::sort(elsewhere.begin(), elsewhere.end());
    ghosts.add_indices(elsewhere.begin(), std::unique(elsewhere.begin(), elsewhere.end()));
    if (Utilities::MPI::max(ghosts.n_elements(), communicator) > 0)
      partitioner = std::make_shared<Utilities::MPI::Partitioner>(owned, ghosts, communicator);
    imported.resize(ghosts.n_elements());

    for (const auto &line : constraints.get_lines())
      if (owned.is_element(line.index))
        {
          lines.push_back({static_cast<unsigned int>(owned.index_within_set(line.index)), {}});
          for (const auto &[index, weight] : line.entries)
            lines.back().depends_on.emplace_back(owned.is_element(index) ?
                                                   owned.index_within_set(index) :
                                                   n_owned + ghosts.index_within_set(index),
                                                 weight);
        }
  }

  void Elimination::condense(Vector &residual) const
  {
    double *const entries = residual.begin();
    std::fill(imported.begin(), imported.end(), 0.);
    for (const auto &line : lines)
      {
        for (const auto &[index, weight] : line.depends_on)
          (index < n_owned ? entries[index] : imported[index - n_owned]) += weight * entries[line.row];
        entries[line.row] = 0.;
      }
    if (!partitioner)
      return;
    std::vector<double>      temporary(partitioner->n_import_indices());
    std::vector<MPI_Request> requests;
    partitioner->import_from_ghosted_array_start(
      VectorOperation::add, 0, make_array_view(imported), make_array_view(temporary), requests);
    partitioner->import_from_ghosted_array_finish(VectorOperation::add,
                                                  ArrayView<const double>(temporary.data(), temporary.size()),
                                                  ArrayView<double>(entries, n_owned),
                                                  make_array_view(imported),
                                                  requests);
  }

  void Elimination::import(const Vector &x) const
  {
    if (!partitioner)
      return;
    std::vector<double>      temporary(partitioner->n_import_indices());
    std::vector<MPI_Request> requests;
    partitioner->export_to_ghosted_array_start(0,
                                               ArrayView<const double>(x.begin(), n_owned),
                                               make_array_view(temporary),
                                               make_array_view(imported),
                                               requests);
    partitioner->export_to_ghosted_array_finish(make_array_view(imported), requests);
  }

  void Elimination::distribute(Vector &x) const
  {
    clear(x);
    add_dependence(x);
  }

  void Elimination::add_dependence(Vector &x) const
  {
    import(x);
    double *const entries = x.begin();
    for (const auto &line : lines)
      for (const auto &[index, weight] : line.depends_on)
        entries[line.row] += weight * (index < n_owned ? entries[index] : imported[index - n_owned]);
  }

  void Elimination::clear(Vector &x) const
  {
    for (const auto &line : lines)
      x.begin()[line.row] = 0.;
  }

  void Elimination::copy_constrained(const Vector &from, Vector &to) const
  {
    for (const auto &line : lines)
      to.begin()[line.row] = from.begin()[line.row];
  }

  void Elimination::keep_constrained(Vector &x) const
  {
    std::vector<double> kept;
    kept.reserve(lines.size());
    for (const auto &line : lines)
      kept.push_back(x.begin()[line.row]);
    x = 0.;
    for (unsigned int i = 0; i < lines.size(); ++i)
      x.begin()[lines[i].row] = kept[i];
  }
} // namespace Cautery
