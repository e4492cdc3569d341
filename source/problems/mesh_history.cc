// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/mesh_history.h>

#include <algorithm>

namespace Cautery
{
  namespace
  {
    /// Relative: times that are the same but for rounding.
    constexpr double same_time = 1e-12;
  } // namespace

  template <int dim>
  MeshHistory<dim>::MeshHistory(const Scene &scene, const Mesh<dim> &first)
    : settings(scene.mesh.adaptive), end(scene.time.end), next(settings.interval)
  {
    adaption.most_cells = adaption.last_cells = first.n_cells();
  }

  template <int dim>
  double MeshHistory<dim>::stop_before(const double time) const
  {
    const bool before = settings.is_on() && settings.interval > 0. && next < time * (1. - same_time);
    return before ? next : time;
  }

  template <int dim>
  bool MeshHistory<dim>::is_due(const double time)
  {
    if (!settings.is_on() || settings.interval == 0. || time < next * (1. - same_time) || time >= end)
      return false;
    next += settings.interval;
    return true;
  }

  template <int dim>
  void MeshHistory<dim>::add(const Problem<dim> &problem)
  {
    for (const auto &[name, count] : problem.statistics())
      statistics[name] += count;
    for (const auto &[name, error] : problem.time_errors())
      time_errors[name] += error;
  }

  template <int dim>
  void MeshHistory<dim>::change(const Problem<dim> &before, const Mesh<dim> &next_mesh)
  {
    add(before);
    ++adaption.times;
    adaption.last_cells = next_mesh.n_cells();
    adaption.most_cells = std::max(adaption.most_cells, adaption.last_cells);
  }

  template <int dim>
  void MeshHistory<dim>::tell(const Problem<dim> &present, RunRecord &record) const
  {
    MeshHistory all = *this;
    all.add(present);
    record.statistics = all.statistics;
    for (const auto &[name, error] : all.time_errors)
      if (error.steps > 0)
        record.time_errors[name] = error;
    if (settings.is_on())
      record.adaption = adaption;
  }

  template <int dim>
  void MeshHistory<dim>::archive(Archive &archive, const Problem<dim> &present)
  {
    if (!settings.is_on())
      return;
    archive.shared("next", next);
    archive.shared("times", adaption.times);
    archive.shared("most cells", adaption.most_cells);
    archive.shared("last cells", adaption.last_cells);
    for (const auto &count : present.statistics())
      archive.shared(count.first, statistics[count.first]);
    for (const auto &error : present.time_errors())
      archive.section(error.first, [&]() { time_errors[error.first].archive(archive); });
  }

  template class MeshHistory<2>;
  template class MeshHistory<3>;
} // namespace Cautery
