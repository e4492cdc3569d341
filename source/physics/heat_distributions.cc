// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/heat_distributions.h>

#include <deal.II/fe/fe_values.h>

namespace Cautery
{
  namespace
  {
    /// Adds the heat that one cell receives, for each of its nodes (W), to the nodes of the body.
    template <int dim>
    class NodalSum
    {
    public:
      NodalSum(const Field<dim> &field, const TissueMap<dim> &tissues, Vector &load, Vector *relaxed)
        : tissues(tissues), load(load), relaxed(relaxed), dofs(field.element().n_dofs_per_cell())
      {
      }

      void add(const typename DoFHandler<dim>::active_cell_iterator &cell, dealii::Vector<double> &heat)
      {
        cell->get_dof_indices(dofs);
        load.add(dofs, heat);
        if (relaxed == nullptr)
          return;
        heat *= tissues[cell->material_id()].thermal.relaxation_time;
        relaxed->add(dofs, heat);
      }

    private:
      const TissueMap<dim>                &tissues;
      Vector                              &load;
      Vector                              *relaxed;
      std::vector<types::global_dof_index> dofs;
    };

    /// Adds the integral over a cell or face of @p density times each shape function.
    template <typename Values, typename Density>
    void integrate(const Values &values, const Density &density, dealii::Vector<double> &heat)
    {
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const double here = density(in_space(values.quadrature_point(q))) * values.JxW(q);
          for (const unsigned int i : values.dof_indices())
            heat(i) += here * values.shape_value(i, q);
        }
    }

    template <int dim>
    HeatDistribution points(const PointSources      &source,
                            const std::string       &name,
                            const Field<dim>        &field,
                            const TissueMap<dim>    &tissues,
                            const PointLocator<dim> &locator)
    {
      std::vector<Point<dim>> places;
      for (const auto &place : source.places)
        {
          places.emplace_back();
          for (unsigned int d = 0; d < dim; ++d)
            places.back()[d] = place[d];
        }
      const std::vector<std::string> names(places.size(), "Heat sources/" + name + "/Places");
      return {[&field, &tissues, found = locator.find_inside(places, names)](
                const double, Vector &load, Vector *relaxed) {
        NodalSum<dim>          sum(field, tissues, load, relaxed);
        dealii::Vector<double> heat(field.element().n_dofs_per_cell());
        for (const auto &location : found)
          if (location)
            {
              for (unsigned int i = 0; i < heat.size(); ++i)
                heat(i) = field.element().shape_value(i, location->unit);
              sum.add(field.cell(location->cell), heat);
            }
      }};
    }

    /// Of @p density(place, time), in W/m^3, in @p regions.
    template <int dim, typename Density>
    HeatDistribution volume(const Density                      &density,
                            const std::set<types::material_id> &regions,
                            const Field<dim>                   &field,
                            const TissueMap<dim>               &tissues)
    {
      return {[density, regions, &field, &tissues](const double time, Vector &load, Vector *relaxed) {
        FEValues<dim>          values(field.mapping(),
                             field.element(),
                             field.cell_quadrature(),
                             update_values | update_quadrature_points | update_JxW_values);
        NodalSum<dim>          sum(field, tissues, load, relaxed);
        dealii::Vector<double> heat(field.element().n_dofs_per_cell());
        for (const auto &cell : field.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned() && regions.count(cell->material_id()) == 1)
            {
              values.reinit(cell);
              heat = 0.;
              integrate(
                values, [&](const Point<3> &place) { return density(place, time); }, heat);
              sum.add(cell, heat);
            }
      }};
    }
  } // namespace

  template <int dim>
  HeatDistribution source_distribution(const HeatSource        &source,
                                       const Field<dim>        &field,
                                       const TissueMap<dim>    &tissues,
                                       const PointLocator<dim> &locator)
  {
    const auto in_regions = [&](const auto &density, const std::vector<std::string> &regions) {
      return volume<dim>(density,
                         field.mesh().region_ids(regions, "Heat sources/" + source.name + "/Regions"),
                         field,
                         tissues);
    };
    return std::visit(
      [&](const auto &shape) -> HeatDistribution {
        using Shape = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Shape, PointSources>)
          return points<dim>(shape, source.name, field, tissues, locator);
        else if constexpr (std::is_same_v<Shape, UniformSource>)
          return in_regions([](const Point<3> &, const double) { return 1.; }, shape.regions);
        else if constexpr (std::is_same_v<Shape, ExpressionSource>)
          {
            HeatDistribution distribution =
              in_regions([&shape](const Point<3> &place,
                                  const double    time) { return shape.distribution.value(place, time); },
                         {"all"});
            distribution.changes = shape.distribution.depends_on_time();
            return distribution;
          }
        else
          return in_regions(
            [&shape](const Point<3> &place, const double) { return shape.density(place, dim); }, {"all"});
      },
      source.source);
  }

  template <int dim>
  HeatDistribution surface_distribution(const Boundary                     &boundary,
                                        const std::set<types::boundary_id> &surfaces,
                                        const Field<dim>                   &field,
                                        const TissueMap<dim>               &tissues)
  {
    const bool        convection = boundary.thermal == Boundary::Thermal::convection;
    const Expression &expression = convection ? boundary.ambient_temperature : boundary.flux;
    const Expression  factor     = convection ? boundary.transfer_coefficient : Expression(1.);
    const auto        assemble =
      [&expression, factor, surfaces, &field, &tissues](const double time, Vector &load, Vector *relaxed) {
        FEFaceValues<dim>      values(field.mapping(),
                                 field.element(),
                                 field.face_quadrature(),
                                 update_values | update_quadrature_points | update_JxW_values);
        NodalSum<dim>          sum(field, tissues, load, relaxed);
        dealii::Vector<double> heat(field.element().n_dofs_per_cell());
        for (const auto &cell : field.dof_handler().active_cell_iterators())
          {
            if (!cell->is_locally_owned() || !cell->at_boundary())
              continue;
            heat = 0.;
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() && surfaces.count(face->boundary_id()) == 1)
                {
                  values.reinit(cell, face);
                  integrate(
                    values,
                    [&](const Point<3> &place) {
                      return factor.value(place, 0.) * expression.value(place, time);
                    },
                    heat);
                }
            sum.add(cell, heat);
          }
      };
    return {assemble, expression.depends_on_time()};
  }

  template HeatDistribution
  source_distribution(const HeatSource &, const Field<2> &, const TissueMap<2> &, const PointLocator<2> &);
  template HeatDistribution
  source_distribution(const HeatSource &, const Field<3> &, const TissueMap<3> &, const PointLocator<3> &);
  template HeatDistribution surface_distribution(const Boundary &,
                                                 const std::set<types::boundary_id> &,
                                                 const Field<2> &,
                                                 const TissueMap<2> &);
  template HeatDistribution surface_distribution(const Boundary &,
                                                 const std::set<types::boundary_id> &,
                                                 const Field<3> &,
                                                 const TissueMap<3> &);
} // namespace Cautery
