// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/files.h>
#include <cautery/output/observer.h>
#include <cautery/scene/output_settings.h>
#include <cautery/space/points.h>

#include <optional>

namespace Cautery
{
  /**
   * probes.csv: a row for every output time and probe, with the quantities that are on, interpolated between
   * the nodes of the probe's cell.
   */
  template <int dim>
  class Probes : public Observer<dim>
  {
  public:
    /** Errors: ExcInput for a probe outside the body. */
    Probes(const std::vector<Probe> &probes, const PointLocator<dim> &locator, const Field<dim> &nodes);

    /** The file appears with the first row. */
    void write_to(const std::string &file_name) { file.name_it(file_name); }

    std::string name() const override { return "output: probes"; }
    void        use_mesh(const Field<dim>        &new_nodes,
                         const PointLocator<dim> &locator,
                         const BoundaryMap<dim>  &boundaries) override;
    void        observe(const Snapshot<dim> &snapshot) override;
    void        archive(Archive &archive) override { file.archive("probes", archive); }

  private:
    std::string
    rows(const double time, const std::vector<NodalColumn> &columns, const std::vector<double> &values) const;
    double value(const unsigned int probe, const Vector &ghosted) const;

    const std::vector<Probe>                                         probes;
    const Field<dim>                                                *nodes;
    std::vector<std::optional<typename PointLocator<dim>::Location>> locations;
    GrowingFile                                                      file;
  };
} // namespace Cautery
