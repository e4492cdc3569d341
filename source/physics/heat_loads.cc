// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/heat_loads.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  template <int dim>
  HeatLoads<dim>::HeatLoads(const Scene             &scene,
                            const Field<dim>        &field,
                            const TissueMap<dim>    &tissues,
                            const BoundaryMap<dim>  &boundaries,
                            const PointLocator<dim> &locator)
    : field(field)
    , non_fourier(scene.effects.heat == Effects::Heat::non_fourier)
    , jumps(scene.effects.source_jumps == Effects::Jumps::consistent)
  {
    if (scene.effects.heat_sources)
      add_sources(scene, tissues, locator);
    add_surfaces(scene.boundaries, tissues, boundaries);
  }

  namespace
  {
    /// Adds the shape functions at @p place, times @p factor, to the nodes of @p cell.
    template <int dim>
    void add_at_point(const typename DoFHandler<dim>::active_cell_iterator &cell,
                      const Point<dim>                                     &unit,
                      const double                                          factor,
                      Vector                                               &load)
    {
      const FiniteElement<dim>            &fe = cell->get_fe();
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      std::vector<double>                  values(dofs.size());
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        values[i] = factor * fe.shape_value(i, unit);
      load.add(dofs, values);
    }
  } // namespace

  template <int dim>
  auto HeatLoads<dim>::points(const PointSources      &source,
                              const std::string       &name,
                              const TissueMap<dim>    &tissues,
                              const PointLocator<dim> &locator) const -> Assemble
  {
    std::vector<Point<dim>> places;
    for (const auto &place : source.places)
      {
        places.emplace_back();
        for (unsigned int d = 0; d < dim; ++d)
          places.back()[d] = place[d];
      }
    const auto found = locator.find_inside(places, "Heat sources/" + name + "/Places");
    return [this, found, &tissues](const double, Vector &load, Vector *relaxed) {
      for (const auto &location : found)
        if (location)
          {
            const auto cell = field.cell(location->cell);
            add_at_point<dim>(cell, location->unit, 1., load);
            if (relaxed != nullptr)
              add_at_point<dim>(
                cell, location->unit, tissues[cell->material_id()].thermal.relaxation_time, *relaxed);
          }
    };
  }

  template <int dim>
  template <typename Density>
  auto HeatLoads<dim>::volume(const Density                      &density,
                              const std::set<types::material_id> &regions,
                              const TissueMap<dim>               &tissues) const -> Assemble
  {
    return [this, density, regions, &tissues](const double time, Vector &load, Vector *relaxed) {
      FEValues<dim>                        values(field.mapping(),
                           field.element(),
                           field.cell_quadrature(),
                           update_values | update_quadrature_points | update_JxW_values);
      dealii::Vector<double>               local(field.element().n_dofs_per_cell());
      std::vector<types::global_dof_index> dofs(local.size());
      for (const auto &cell : field.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && regions.count(cell->material_id()) == 1)
          {
            values.reinit(cell);
            local = 0.;
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const double heat = density(in_space<dim>(values.quadrature_point(q)), time) * values.JxW(q);
                for (const unsigned int i : values.dof_indices())
                  local(i) += heat * values.shape_value(i, q);
              }
            cell->get_dof_indices(dofs);
            load.add(dofs, local);
            if (relaxed != nullptr)
              {
                local *= tissues[cell->material_id()].thermal.relaxation_time;
                relaxed->add(dofs, local);
              }
          }
    };
  }

  template <int dim>
  void HeatLoads<dim>::add_sources(const Scene             &scene,
                                   const TissueMap<dim>    &tissues,
                                   const PointLocator<dim> &locator)
  {
    const auto everywhere = field.mesh().region_ids({"all"});
    for (const auto &source : scene.heat_sources)
      {
        Item item;
        item.source = &source;
        if (const auto *shape = std::get_if<PointSources>(&source.source))
          item.assemble = points(*shape, source.name, tissues, locator);
        else if (const auto *shape = std::get_if<ExpressionSource>(&source.source))
          {
            item.changes = shape->distribution.depends_on_time();
            item.assemble =
              volume([shape](const Point<3> &place,
                             const double    time) { return shape->distribution.value(place, time); },
                     everywhere,
                     tissues);
          }
        else
          item.assemble = std::visit(
            [&](const auto &shape) -> Assemble {
              using Shape = std::decay_t<decltype(shape)>;
              if constexpr (std::is_same_v<Shape, UniformSource>)
                return volume([](const Point<3> &, const double) { return 1.; },
                              field.mesh().region_ids(shape.regions),
                              tissues);
              else if constexpr (std::is_same_v<Shape, GaussianSource> ||
                                 std::is_same_v<Shape, MicrowaveAntenna>)
                return volume(
                  [&shape](const Point<3> &place, const double) { return shape.density(place, dim); },
                  everywhere,
                  tissues);
              else
                return {};
            },
            source.source);
        add_item(std::move(item));
      }
  }

  template <int dim>
  void HeatLoads<dim>::add_surfaces(const std::vector<Boundary> &list,
                                    const TissueMap<dim>        &tissues,
                                    const BoundaryMap<dim>      &map)
  {
    for (unsigned int b = 0; b < list.size(); ++b)
      {
        const Boundary &boundary   = list[b];
        const bool      convection = boundary.thermal == Boundary::Thermal::convection;
        if (!convection && boundary.thermal != Boundary::Thermal::flux)
          continue;
        const Expression &expression = convection ? boundary.ambient_temperature : boundary.flux;
        const double      factor     = convection ? boundary.transfer_coefficient : 1.;
        const auto        surfaces   = map.surfaces(b);
        Item              item;
        item.changes = expression.depends_on_time();
        item.assemble =
          [this, &expression, factor, surfaces, &tissues](const double time, Vector &load, Vector *relaxed) {
            FEFaceValues<dim>                    values(field.mapping(),
                                     field.element(),
                                     field.face_quadrature(),
                                     update_values | update_quadrature_points | update_JxW_values);
            dealii::Vector<double>               local(field.element().n_dofs_per_cell());
            std::vector<types::global_dof_index> dofs(local.size());
            for (const auto &cell : field.dof_handler().active_cell_iterators())
              {
                if (!cell->is_locally_owned() || !cell->at_boundary())
                  continue;
                local = 0.;
                for (const unsigned int face : cell->face_indices())
                  if (cell->face(face)->at_boundary() && surfaces.count(cell->face(face)->boundary_id()) == 1)
                    {
                      values.reinit(cell, face);
                      for (const unsigned int q : values.quadrature_point_indices())
                        {
                          const double heat =
                            factor * expression.value(in_space<dim>(values.quadrature_point(q)), time) *
                            values.JxW(q);
                          for (const unsigned int i : values.dof_indices())
                            local(i) += heat * values.shape_value(i, q);
                        }
                    }
                cell->get_dof_indices(dofs);
                load.add(dofs, local);
                if (relaxed != nullptr)
                  {
                    local *= tissues[cell->material_id()].thermal.relaxation_time;
                    relaxed->add(dofs, local);
                  }
              }
          };
        add_item(std::move(item));
      }
  }

  template <int dim>
  void HeatLoads<dim>::add_item(Item item)
  {
    item.load = field.vector();
    if (non_fourier)
      item.relaxed = field.vector();
    assemble_now(item, 0., item.load, non_fourier ? &item.relaxed : nullptr);
    item.sum = item.load.mean_value() * item.load.size();
    if (non_fourier && item.sum != 0.)
      item.delay = item.relaxed.mean_value() * item.relaxed.size() / item.sum;
    items.push_back(std::move(item));
  }

  template <int dim>
  void HeatLoads<dim>::assemble_now(const Item &item, const double time, Vector &load, Vector *relaxed) const
  {
    load = 0.;
    if (relaxed != nullptr)
      *relaxed = 0.;
    item.assemble(time, load, relaxed);
    load.compress(VectorOperation::add);
    if (relaxed != nullptr)
      relaxed->compress(VectorOperation::add);
  }

  template <int dim>
  double HeatLoads<dim>::mean_amplitude(const Item &item, const Step &step) const
  {
    if (item.source == nullptr)
      return 1.;
    return item.source->amplitude(step.to) * item.source->schedule.share(step.from, step.to);
  }

  namespace
  {
    /// On until and including @p time: what holds just before a switch.
    bool active_before(const Schedule &schedule, const double time)
    {
      for (unsigned int i = 0; i < schedule.on.size(); ++i)
        if (schedule.on[i] < time && (i >= schedule.off.size() || time <= schedule.off[i]))
          return true;
      return false;
    }
  } // namespace

  template <int dim>
  std::pair<double, double> HeatLoads<dim>::end_amplitudes(const Item &item, const Step &step) const
  {
    if (item.source == nullptr)
      return {1., 1.};
    const auto  &schedule = item.source->schedule;
    const double share    = schedule.share(step.from, step.to);
    // Taking the state just before each time makes the differences telescope: every jump counts exactly once.
    return {item.source->amplitude(step.from) * (jumps ? active_before(schedule, step.from) : share),
            item.source->amplitude(step.to) * (jumps ? active_before(schedule, step.to) : share)};
  }

  template <int dim>
  void HeatLoads<dim>::add_rate(const Item &item, const Step &step, Vector &force) const
  {
    const auto [start, end] = end_amplitudes(item, step);
    const double before     = start / step.length();
    const double after      = end / step.length();
    if (!item.changes)
      {
        if (after != before)
          force.add(after - before, item.relaxed);
        return;
      }
    Vector load    = field.vector();
    Vector relaxed = field.vector();
    assemble_now(item, step.to, load, &relaxed);
    force.add(after, relaxed);
    assemble_now(item, step.from, load, &relaxed);
    force.add(-before, relaxed);
  }

  template <int dim>
  void HeatLoads<dim>::add(const Step &step, Vector &force) const
  {
    for (const auto &item : items)
      {
        const double amplitude = mean_amplitude(item, step);
        if (item.changes)
          {
            Vector load = field.vector();
            assemble_now(item, step.to, load, nullptr);
            force.add(amplitude, load);
          }
        else if (amplitude != 0.)
          force.add(amplitude, item.load);
        if (non_fourier)
          add_rate(item, step, force);
      }
  }

  template <int dim>
  void HeatLoads<dim>::add_at(const double time, const double within, Vector &force) const
  {
    // central differences of a smooth amplitude: error 1e-10 relative, far below any tolerance in time
    const double h = 1e-5 * std::max(1., std::abs(time));
    for (const auto &item : items)
      {
        const bool active = item.source == nullptr || item.source->schedule.active(within);
        const auto value  = [&](const double t) {
          return item.source == nullptr ? 1. : item.source->amplitude(t);
        };
        if (!active)
          continue;
        if (!item.changes)
          {
            force.add(value(time), item.load);
            if (non_fourier)
              force.add((value(time + h) - value(time - h)) / (2. * h), item.relaxed);
            continue;
          }
        Vector load    = field.vector();
        Vector relaxed = non_fourier ? field.vector() : Vector();
        assemble_now(item, time, load, nullptr);
        force.add(value(time), load);
        for (const double side : {-1., 1.})
          if (non_fourier)
            {
              assemble_now(item, time + side * h, load, &relaxed);
              force.add(side * value(time + side * h) / (2. * h), relaxed);
            }
      }
  }

  template <int dim>
  void HeatLoads<dim>::add_surfaces_at(const double time, Vector &force) const
  {
    Vector load = field.vector();
    for (const auto &item : items)
      if (item.source == nullptr)
        {
          assemble_now(item, time, load, nullptr);
          force += load;
        }
  }

  template <int dim>
  void HeatLoads<dim>::add_jump(const double time, Vector &force) const
  {
    if (!non_fourier || !jumps)
      return;
    for (const auto &item : items)
      if (item.source != nullptr)
        {
          const double jump = item.source->amplitude(time) * (item.source->schedule.active(time) -
                                                              active_before(item.source->schedule, time));
          if (jump == 0.)
            continue;
          if (!item.changes)
            {
              force.add(jump, item.relaxed);
              continue;
            }
          Vector load    = field.vector();
          Vector relaxed = field.vector();
          assemble_now(item, time, load, &relaxed);
          force.add(jump, relaxed);
        }
  }

  template <int dim>
  std::vector<double> HeatLoads<dim>::switching_times(const double end) const
  {
    std::vector<double> times;
    for (const auto &item : items)
      if (item.source != nullptr)
        for (const double time : item.source->schedule.switching_times())
          if (time > 0. && time < end)
            times.push_back(time);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
  }

  template <int dim>
  void HeatLoads<dim>::record(const Step &step, Vector &nodal_heat, Received &received)
  {
    for (auto &item : items)
      {
        double amplitude = mean_amplitude(item, step);
        if (item.source != nullptr && non_fourier && !(jumps && item.changes))
          {
            // A source acts as s with tau s' + s = a + tau a': other than a where its jumps are neglected,
            // and after a switch inside a step, of which a holds the share and a' the whole jump.
            const auto [before, after] = end_amplitudes(item, step);
            const double decay         = item.delay / step.length();
            item.effective = (decay * (item.effective + after - before) + amplitude) / (1. + decay);
            amplitude      = item.effective;
          }
        double heat = amplitude * step.length();
        if (item.changes)
          {
            Vector load = field.vector();
            assemble_now(item, step.to, load, nullptr);
            nodal_heat.add(heat, load);
            heat *= load.mean_value() * load.size();
          }
        else
          {
            nodal_heat.add(heat, item.load);
            heat *= item.sum;
          }
        (item.source != nullptr ? received.sources : received.surfaces) += heat;
      }
  }

  template class HeatLoads<2>;
  template class HeatLoads<3>;
} // namespace Cautery
