// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/files.h>
#include <cautery/output/observer.h>
#include <cautery/scene/scene.h>
#include <cautery/space/assignment.h>

namespace Cautery
{
  /**
   * reactions.csv: a row for every output time and support with the force that it exerts on the body. A node
   * where supports meet counts for one of them, in the order in which they hold it, so that the rows add up.
   */
  template <int dim>
  class Reactions : public Observer<dim>
  {
  public:
    Reactions(const Scene &scene, const Field<dim> &nodes, const BoundaryMap<dim> &boundaries);

    /** The file appears with the first row. */
    void write_to(const std::string &file_name) { file.name_it(file_name); }

    std::string name() const override { return "output: reactions"; }
    void        use_mesh(const Field<dim>        &new_nodes,
                         const PointLocator<dim> &locator,
                         const BoundaryMap<dim>  &boundaries) override;
    void        observe(const Snapshot<dim> &snapshot) override;
    void        archive(Archive &archive) override { file.archive("reactions", archive); }

  private:
    struct Support
    {
      std::string                          name;
      std::vector<types::global_dof_index> nodes; ///< the process's own
    };
    void find(const BoundaryMap<dim> &boundaries);
    void add(const std::string &name, const std::set<types::global_dof_index> &held);

    const Scene                      &scene;
    const Field<dim>                 *nodes;
    std::vector<Support>              supports;
    std::set<types::global_dof_index> taken;
    GrowingFile                       file;
  };
} // namespace Cautery
