// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/agreement.h>
#include <cautery/output/probes.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Cautery
{
  namespace
  {
    template <int dim>
    std::vector<std::optional<typename PointLocator<dim>::Location>> locate(const std::vector<Probe> &probes,
                                                                            const PointLocator<dim>  &locator)
    {
      std::vector<Point<dim>>  places;
      std::vector<std::string> names;
      for (const auto &probe : probes)
        {
          names.push_back("Output/Probe places, `" + probe.name + "`");
          places.emplace_back();
          for (unsigned int d = 0; d < dim; ++d)
            places.back()[d] = probe.place[d];
        }
      return locator.find_inside(places, names);
    }
  } // namespace

  template <int dim>
  Probes<dim>::Probes(const std::vector<Probe> &probes,
                      const PointLocator<dim>  &locator,
                      const Field<dim>         &nodes)
    : probes(probes), nodes(&nodes), locations(locate(probes, locator))
  {
  }

  template <int dim>
  void Probes<dim>::use_mesh(const Field<dim>        &new_nodes,
                             const PointLocator<dim> &locator,
                             const BoundaryMap<dim> &)
  {
    nodes     = &new_nodes;
    locations = locate(probes, locator);
  }

  template <int dim>
  double Probes<dim>::value(const unsigned int probe, const Vector &ghosted) const
  {
    const auto                          &location = *locations[probe];
    const auto                           cell     = nodes->cell(location.cell);
    std::vector<types::global_dof_index> dofs(nodes->element().n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    double result = 0.;
    for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const double weight = nodes->element().shape_value(i, location.unit);
        const double nodal  = ghosted(dofs[i]);
        if (std::abs(weight) <= 1e-8)
          continue;
        if (!std::isfinite(nodal)) // -infinity: no damage; of both signs of weight it would make nothing
          return nodal;
        result += weight * nodal;
      }
    return result;
  }

  template <int dim>
  void Probes<dim>::observe(const Snapshot<dim> &snapshot)
  {
    if (probes.empty())
      return;
    const auto          columns = nodal_columns(snapshot);
    std::vector<double> values(probes.size() * columns.size(), 0.);
    for (unsigned int c = 0; c < columns.size(); ++c)
      {
        const Vector ghosted = nodes->ghosted(columns[c].values);
        for (unsigned int p = 0; p < probes.size(); ++p)
          if (locations[p])
            values[p * columns.size() + c] = value(p, ghosted);
      }
    // one process has each probe, the others add zeros
    Utilities::MPI::sum(values, nodes->communicator(), values);
    fail_together(nodes->communicator(), [&]() {
      if (Utilities::MPI::this_mpi_process(nodes->communicator()) == 0)
        file.add(rows(snapshot.state.time, columns, values));
    });
  }

  template <int dim>
  std::string Probes<dim>::rows(const double                    time,
                                const std::vector<NodalColumn> &columns,
                                const std::vector<double>      &values) const
  {
    std::ostringstream out;
    const bool         has_damage = !columns.empty() && columns.back().name == "ln_damage";
    if (file.length() == 0)
      {
        out << "time_s,probe,x_m,y_m,z_m";
        for (const auto &column : columns)
          out << ',' << column.name;
        out << (has_damage ? ",damage\n" : "\n");
      }
    for (unsigned int p = 0; p < probes.size(); ++p)
      {
        const auto &place = probes[p].place;
        out << std::setprecision(12) << time << ',' << probes[p].name << ',' << place[0] << ',' << place[1]
            << ',' << place[2] << std::setprecision(15);
        for (unsigned int c = 0; c < columns.size(); ++c)
          out << ',' << values[p * columns.size() + c];
        if (has_damage)
          out << ',' << std::exp(values[(p + 1) * columns.size() - 1]);
        out << '\n';
      }
    return out.str();
  }

  template class Probes<2>;
  template class Probes<3>;
} // namespace Cautery
