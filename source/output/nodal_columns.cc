// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/output/nodal_columns.h>

namespace Cautery
{
  namespace
  {
    const std::string axes = "xyz";

    template <int dim, typename Value>
    NodalColumn column(const Field<dim> &nodes, const std::string &name, const Value &value)
    {
      NodalColumn result{name, nodes.vector()};
      for (unsigned int node = 0; node < nodes.owned().n_elements(); ++node)
        result.values.begin()[node] = value(node);
      return result;
    }

    template <int dim>
    void add_tensors(const Field<dim>                           &nodes,
                     const std::string                          &name,
                     const std::string                          &unit,
                     const std::vector<SymmetricTensor<2, dim>> &tensors,
                     std::vector<NodalColumn>                   &columns)
    {
      const auto add = [&](const unsigned int c, const unsigned int d) {
        columns.push_back(column(nodes, name + "_" + axes[c] + axes[d] + unit, [&](const unsigned int node) {
          return tensors[node][c][d];
        }));
      };
      for (unsigned int d = 0; d < dim; ++d)
        add(d, d);
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = c + 1; d < dim; ++d)
          add(c, d);
    }
  } // namespace

  template <int dim>
  std::vector<NodalColumn> nodal_columns(const Snapshot<dim> &snapshot)
  {
    const State             &state = snapshot.state;
    std::vector<NodalColumn> columns;
    if (state.temperature.size() > 0)
      columns.push_back({"temperature_K", state.temperature});
    if (snapshot.displacement != nullptr)
      {
        for (unsigned int c = 0; c < dim; ++c)
          columns.push_back(column(
            snapshot.nodes, std::string("displacement_") + axes[c] + "_m", [&](const unsigned int node) {
              return state.displacement.begin()[dim * node + c];
            }));
        add_tensors(snapshot.nodes, "strain", "", snapshot.mechanical->strain, columns);
        add_tensors(snapshot.nodes, "stress", "_Pa", snapshot.mechanical->stress, columns);
        columns.push_back(column(snapshot.nodes, "strain_energy_J_per_m3", [&](const unsigned int node) {
          return snapshot.mechanical->strain_energy[node];
        }));
      }
    if (state.ln_damage.size() > 0)
      columns.push_back({"ln_damage", state.ln_damage});
    return columns;
  }

  template std::vector<NodalColumn> nodal_columns(const Snapshot<2> &);
  template std::vector<NodalColumn> nodal_columns(const Snapshot<3> &);
} // namespace Cautery
