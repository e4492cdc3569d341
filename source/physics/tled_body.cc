// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/tled_body.h>

namespace Cautery
{
  template <typename Number>
  template <int corners>
  TledBody<Number>::Pack<corners>::Pack(CellMesh<corners>  cell_mesh,
                                        const unsigned int lanes,
                                        const int          n_points)
    : mesh(std::move(cell_mesh)), cells(mesh, lanes, n_points)
  {
  }

  template <typename Number>
  TledBody<Number>::TledBody(const Scene             &scene,
                             const Field<3>          &nodes,
                             const TissueMap<3>      &tissues,
                             const TledNodes<Number> &records)
    : scene(scene)
    , nodes(nodes)
    , tissues(tissues)
    , records(records)
    , loops(tled_kernel<Number>(best_instruction_set()))
    , zero_temperature(tissues.tissue(0).expansion.reference_temperature)
    , scalars(records.scalars())
  {
    const bool tetrahedra = nodes.mesh().simplices();
    for (unsigned int t = 0; t < tissues.size(); ++t)
      {
        check(tissues.tissue(t));
        Share &share = shares.emplace_back();
        share.tissue = t;
        if (tetrahedra)
          share.tetrahedra = std::make_unique<Pack<4>>(cells_of<4>(t), loops.lanes, 1);
        else
          share.hexahedra = std::make_unique<Pack<8>>(
            cells_of<8>(t), loops.lanes, scene.numerics.explicit_steps.hexahedron_points);
        choose_loops(share);
      }
  }

  template <typename Number>
  void TledBody<Number>::check(const Tissue &tissue) const
  {
    const bool expands = scene.effects.coupling != Effects::Coupling::off;
    TissueElasticity(tissue, expands); // finds laws that do not fit
    AssertThrow(
      tissue.thermally_constant() && tissue.elastic.youngs_modulus.is_constant() &&
        tissue.expansion.coefficient.is_constant(),
      ExcInput("Tissues/" + tissue.name +
               " has a property that depends on temperature, which explicit loops do not know; give a "
               "number, or choose Effects/Deformation = large equilibrium and Time/Integrator = backward "
               "Euler"));
    AssertThrow(!expands || tissue.expansion.reference_temperature == zero_temperature,
                ExcInput("Tissues/" + tissue.name +
                         "/Reference temperature = " + to_text(tissue.expansion.reference_temperature) +
                         " K: explicit loops need the same one for all tissues; set " +
                         to_text(zero_temperature)));
  }

  template <typename Number>
  template <typename Work>
  void TledBody<Number>::for_each_cell(const unsigned int t, const Work &work) const
  {
    for (const auto &cell : nodes.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && tissues.index(cell->material_id()) == t)
        work(cell);
  }

  template <typename Number>
  template <int corners>
  CellMesh<corners> TledBody<Number>::cells_of(const unsigned int t) const
  {
    const Tissue                        &tissue = tissues.tissue(t);
    std::vector<types::global_dof_index> dofs(corners);
    CellMesh<corners>                    mesh;
    mesh.nodes    = records.places();
    mesh.n_fibres = scene.effects.has_deformation() ? tissue.fibres.size() : 0;
    for_each_cell(t, [&](const auto &cell) {
      cell->get_dof_indices(dofs);
      typename CellMesh<corners>::Corners corner_nodes;
      for (unsigned int corner = 0; corner < corners; ++corner)
        corner_nodes[corner] = records.local(dofs[corner]);
      mesh.cells.push_back(corner_nodes);
      if (mesh.n_fibres > 0)
        for (const FibreFamily &family : tissue.fibres)
          mesh.directions.push_back(family.unit_direction(cell->center()));
    });
    return mesh;
  }

  template <typename Number>
  void TledBody<Number>::choose_loops(Share &share)
  {
    const Tissue  &tissue  = tissues.tissue(share.tissue);
    const Effects &effects = scene.effects;
    const Lame     lame    = tissue.elastic.lame(zero_temperature);
    SweepMaterial  material;
    material.lambda       = lame.lambda;
    material.mu           = lame.mu;
    material.expansion    = tissue.expansion.coefficient.value(zero_temperature);
    material.conductivity = tissue.thermal.conductivity.value(zero_temperature);
    if (effects.has_deformation())
      for (const FibreFamily &family : tissue.fibres)
        {
          share.fibres.push_back(family.law);
          share.taut_fibres.push_back(family.law);
          share.taut_fibres.back().tension_only = false;
        }
    material.fibres   = share.fibres.data();
    material.n_fibres = share.fibres.size();

    SweepChoice choice;
    choice.hexahedra = share.hexahedra != nullptr;
    choice.n_fibres  = share.fibres.size();
    choice.law = tissue.elastic_law == Tissue::ElasticLawChoice::linear ? SweepChoice::Law::small_strain :
                                                                          SweepChoice::Law::neo_hookean;
    if (effects.coupling != Effects::Coupling::off)
      choice.stretch =
        tissue.expansion.form == ThermalExpansion::Form::exact ? StretchForm::exact : StretchForm::linearised;
    choice.averaged_pressure = scene.numerics.explicit_steps.averaged_pressure && effects.has_deformation();

    share.cells =
      share.hexahedra ? share.hexahedra->cells.sweep(material) : share.tetrahedra->cells.sweep(material);
    share.cells.hourglass = scene.numerics.explicit_steps.hourglass;
    if (choice.averaged_pressure)
      average_pressure(share, choice);

    const auto set = [&](const Part part) {
      share.sweeps[static_cast<unsigned int>(part)] = loops.find(choice);
    };
    set(Part::motion);
    if (!effects.has_heat())
      return;
    choice.conduction = effects.conduction == Effects::Conduction::deformed_body ?
                          SweepChoice::Conduction::deformed :
                          SweepChoice::Conduction::reference;
    set(Part::both);
    choice.averaged_pressure = false;
    choice.law               = SweepChoice::Law::none;
    set(Part::heat);
  }

  template <typename Number>
  void TledBody<Number>::average_pressure(Share &share, const SweepChoice &choice)
  {
    AssertThrow(
      !choice.hexahedra && choice.law == SweepChoice::Law::neo_hookean,
      ExcInput("Numerics/Explicit/Averaged pressure = on is for tetrahedra of neo-Hookean tissue, which " +
               tissues.tissue(share.tissue).name + " is not; turn it off"));
    share.averaged        = std::make_unique<Pressures>();
    Pressures &averaged   = *share.averaged;
    averaged.find_volumes = loops.find_volumes(choice);
    for (auto *numbers : {&averaged.volumes, &averaged.volume_changes, &averaged.pressures})
      *numbers = scalars.zero();
    const auto volumes = lumped_volumes(share.tetrahedra->mesh);
    std::copy(volumes.begin(), volumes.end(), averaged.volumes.begin());
    scalars.collect(averaged.volumes);
    scalars.update(averaged.volumes);

    NodePressures<Number> &step = averaged.step;
    step.n_nodes                = volumes.size();
    step.volumes                = averaged.volumes.data();
    step.volume_changes         = averaged.volume_changes.data();
    step.pressures              = averaged.pressures.data();
    step.stretch                = choice.stretch;
    step.material               = share.cells.material;
    share.cells.volume_changes  = averaged.volume_changes.data();
    share.cells.pressures       = averaged.pressures.data();
  }

  /** The pressures of the nodes of @p cells, which know the nodes' values. */
  template <typename Number>
  bool TledBody<Number>::find_pressures(Pressures &averaged, const CellSweep<Number> &cells)
  {
    const bool healthy = averaged.find_volumes(cells);
    scalars.collect(averaged.volume_changes);
    scalars.update(averaged.volume_changes);
    averaged.step.values = cells.values;
    loops.pressure(averaged.step);
    return healthy;
  }

  template <typename Number>
  bool TledBody<Number>::add_forces(const Part        part,
                                    const Records    &values,
                                    Records          &forces,
                                    const SlackFibres slack)
  {
    bool healthy = true;
    for (Share &share : shares)
      {
        CellSweep<Number> cells = share.cells;
        cells.values            = values.data();
        cells.forces            = forces.data();
        if (slack == SlackFibres::as_if_taut)
          cells.material.fibres = share.taut_fibres.data();
        if (share.averaged && part != Part::heat)
          healthy = find_pressures(*share.averaged, cells) && healthy;
        healthy = share.sweeps[static_cast<unsigned int>(part)](cells) && healthy;
      }
    return healthy;
  }

  template <typename Number>
  bool TledBody<Number>::fibres_buckle() const
  {
    if (!scene.effects.has_deformation())
      return false;
    for (unsigned int t = 0; t < tissues.size(); ++t)
      for (const FibreFamily &family : tissues.tissue(t).fibres)
        if (family.law.tension_only)
          return true;
    return false;
  }

  template <typename Number>
  template <int corners>
  std::optional<InvertedCell> TledBody<Number>::inverted(const Pack<corners> &pack,
                                                         const unsigned int   t,
                                                         const Records       &values,
                                                         const double         most) const
  {
    const auto found = pack.cells.inverted_cell(values.data(), most);
    if (!found)
      return {};
    InvertedCell result{0, Point<3>(), found->jacobian};
    std::size_t  next = 0;
    for_each_cell(t, [&](const auto &cell) {
      if (next++ == found->cell)
        {
          result.cell  = cell_number<3>(cell);
          result.place = cell->center();
        }
    });
    return result;
  }

  template <typename Number>
  std::optional<InvertedCell> TledBody<Number>::inverted(const Records &values, const double most) const
  {
    std::optional<InvertedCell> own;
    for (const Share &share : shares)
      {
        const auto found = share.hexahedra ? inverted(*share.hexahedra, share.tissue, values, most) :
                                             inverted(*share.tetrahedra, share.tissue, values, most);
        if (found && !(own && own->jacobian <= found->jacobian))
          own = found;
      }
    return worst_of_all(own, nodes.communicator());
  }

  template <typename Number>
  std::vector<double> TledBody<Number>::masses() const
  {
    std::vector<double> result(records.n_all(), 0.);
    for (const Share &share : shares)
      {
        const double density = tissues.tissue(share.tissue).thermal.density;
        const auto   volumes =
          share.hexahedra ? lumped_volumes(share.hexahedra->mesh) : lumped_volumes(share.tetrahedra->mesh);
        for (std::size_t node = 0; node < result.size(); ++node)
          result[node] += density * volumes[node];
      }
    return result;
  }

  namespace
  {
    /** Adds V |grad N|^2 of the cells, each corner the same. */
    template <int corners>
    void add_stiffnesses(const CellMesh<corners> &mesh, const double modulus, std::vector<double> &sums)
    {
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        {
          double sum = 0.;
          for (const auto &point : integration_points(corner_places(mesh, cell), corners))
            for (const auto &gradient : point.gradients)
              sum += point.volume * dot(gradient, gradient);
          for (const auto node : mesh.cells[cell])
            sums[node] += modulus * sum / corners;
        }
    }
  } // namespace

  template <typename Number>
  std::vector<double> TledBody<Number>::stiffnesses() const
  {
    std::vector<double> result(records.n_all(), 0.);
    for (const Share &share : shares)
      {
        const auto &material = share.cells.material;
        double      modulus  = material.lambda + 2. * material.mu;
        for (const Fibres &family : share.fibres)
          modulus += 4. * family.stiffness;
        if (share.hexahedra)
          add_stiffnesses(share.hexahedra->mesh, modulus, result);
        else
          add_stiffnesses(share.tetrahedra->mesh, modulus, result);
      }
    return result;
  }

  template class TledBody<float>;
  template class TledBody<double>;
} // namespace Cautery
