// SPDX-License-Identifier: LGPL-2.1-or-later
#include "body.h"

#include <cmath>
#include <random>

namespace Cautery::Test
{
  namespace
  {
    constexpr unsigned int edge = 3; ///< small cubes

    std::mt19937 generator(5);

    double random_number(const double size)
    {
      return std::uniform_real_distribution<>(-size, size)(generator);
    }

    template <int corners>
    void add_cell(const std::array<std::uint32_t, corners> &nodes, CellMesh<corners> &mesh, Body &body)
    {
      mesh.cells.push_back(nodes);
      mesh.directions.insert(mesh.directions.end(), body.directions.begin(), body.directions.end());
      std::array<Point<3>, corners> places;
      for (int a = 0; a < corners; ++a)
        places[a] = body.nodes[nodes[a]];
      const auto points = integration_points(places, body.n_points);
      for (unsigned int q = 0; q < points.size(); ++q)
        {
          CellPoint point;
          point.nodes.assign(nodes.begin(), nodes.end());
          point.gradients.assign(points[q].gradients, points[q].gradients + corners);
          point.volume = points[q].volume;
          for (unsigned int a = 0; a < corners; ++a)
            {
              double shape = 1. / corners;
              if (points.size() == 8)
                for (unsigned int bit = 1; bit < 8; bit *= 2)
                  shape *= 1. + ((a & bit) == (q & bit) ? 1. : -1.) / std::sqrt(3.);
              point.shapes.push_back(shape);
            }
          body.points.push_back(point);
        }
    }

    /** What @p work(point, H, T - T_0) makes of each point. */
    template <typename Work>
    void for_each_point(const Body &body, const Records &values, const Work &work)
    {
      for (const CellPoint &point : body.points)
        {
          Matrix3<double> h       = {};
          double          heating = 0.;
          for (unsigned int a = 0; a < point.nodes.size(); ++a)
            {
              const double *value = &values[4 * point.nodes[a]];
              heating += point.shapes[a] * value[3];
              for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                  h(i, j) += (value[i] - values[4 * point.nodes[0] + i]) * point.gradients[a][j];
            }
          work(point, h, heating);
        }
    }

    Tensor<2, 3> tensor(const Matrix3<double> &m)
    {
      Tensor<2, 3> result;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result[i][j] = m(i, j);
      return result;
    }

    /** What a node stands for: volumes of its share of the cells, m3. */
    struct NodeShare
    {
      double stress_free = 0.; ///< and as hot as the node
      double elastic     = 0.; ///< what elasticity adds to it
      double ratio() const { return 1. + elastic / stress_free; }
    };

    std::vector<NodeShare> node_shares(const Body &body, const Records &values)
    {
      std::vector<NodeShare> shares(body.nodes.size());
      for_each_point(body, values, [&](const CellPoint &point, const auto &h, const double heating) {
        const double volume =
          determinant(tensor(h) + unit_symmetric_tensor<3>()) - std::pow(thermal_stretch(body, heating), 3);
        for (const std::uint32_t node : point.nodes)
          {
            const double stretch = thermal_stretch(body, values[4 * node + 3]);
            shares[node].stress_free += point.volume / 4. * std::pow(stretch, 3);
            shares[node].elastic += point.volume / 4. * volume;
          }
      });
      return shares;
    }
  } // namespace

  std::vector<Case> cases()
  {
    using Law                                                         = SweepChoice::Law;
    using Conduction                                                  = SweepChoice::Conduction;
    const std::vector<std::pair<std::string, Conduction>> conductions = {
      {"", Conduction::none},
      {", conduction", Conduction::reference},
      {", conduction in the deformed body", Conduction::deformed}};
    std::vector<Case> result = {
      {"conduction", {Law::none, StretchForm::none, 0, Conduction::reference}},
      {"conduction in the deformed body", {Law::none, StretchForm::none, 0, Conduction::deformed}}};
    const std::vector<std::pair<std::string, StretchForm>> forms = {
      {"", StretchForm::none}, {", linearised", StretchForm::linearised}, {", exact", StretchForm::exact}};
    for (const auto &form : forms)
      for (const auto &conduction : conductions)
        {
          const std::string heat = form.first + conduction.first;
          result.push_back({"linear" + heat, {Law::small_strain, form.second, 0, conduction.second}});
          for (const unsigned int n_fibres : {0, 1, 2, 3})
            result.push_back({"neo-Hookean, " + std::to_string(n_fibres) + " fibres" + heat,
                              {Law::neo_hookean, form.second, n_fibres, conduction.second}});
        }
    const std::vector<Case> tetrahedra = result;
    for (Case item : tetrahedra)
      if (item.choice.law == Law::neo_hookean)
        {
          item.name += ", averaged pressure";
          item.choice.averaged_pressure = true;
          result.push_back(item);
        }
    for (const int n_points : {1, 8})
      for (Case item : tetrahedra)
        {
          item.name += n_points == 1 ? ", hexahedra with one point" : ", hexahedra";
          item.choice.hexahedra = true;
          item.n_points         = n_points;
          result.push_back(item);
        }
    return result;
  }

  Body make_body(const Case &item)
  {
    generator.seed(11);
    Body body;
    body.choice   = item.choice;
    body.n_points = item.n_points;
    for (unsigned int i = 0; i <= edge; ++i)
      for (unsigned int j = 0; j <= edge; ++j)
        for (unsigned int k = 0; k <= edge; ++k)
          body.nodes.emplace_back(1. * i / edge, 1. * j / edge, 1. * k / edge);
    for (unsigned int n = 0; n < body.nodes.size(); ++n)
      if (is_inside(body, n))
        for (int d = 0; d < 3; ++d)
          body.nodes[n][d] += random_number(0.05);
    const ElasticLaw::Directions directions = {{{0.6, 0.8, 0.}}, {{0.48, -0.6, 0.64}}, {{0., 0., 1.}}};
    body.directions.assign(directions.begin(), directions.begin() + item.choice.n_fibres);
    body.tetrahedra.nodes = body.hexahedra.nodes = body.nodes;
    body.tetrahedra.n_fibres = body.hexahedra.n_fibres = item.choice.n_fibres;

    const int paths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (unsigned int i = 0; i < edge * edge * edge; ++i)
      {
        const auto node = [](const unsigned int x, const unsigned int y, const unsigned int z) {
          return (x * (edge + 1) + y) * (edge + 1) + z;
        };
        const unsigned int origin[3] = {i / (edge * edge), i / edge % edge, i % edge};
        if (item.choice.hexahedra)
          {
            HexahedraMesh::Corners corners;
            for (unsigned int a = 0; a < 8; ++a)
              corners[a] = node(origin[0] + a % 2, origin[1] + a / 2 % 2, origin[2] + a / 4);
            add_cell<8>(corners, body.hexahedra, body);
          }
        else
          for (const auto &path : paths)
            {
              unsigned int            at[3] = {origin[0], origin[1], origin[2]};
              TetrahedraMesh::Corners corners;
              for (int a = 0; a < 4; ++a)
                {
                  corners[a] = node(at[0], at[1], at[2]);
                  if (a < 3)
                    ++at[path[a]];
                }
              add_cell<4>(corners, body.tetrahedra, body);
            }
      }

    body.law.stretch = item.choice.stretch;
    if (item.choice.law == SweepChoice::Law::small_strain)
      body.law.ground = SmallStrain{lambda, mu};
    else
      body.law.ground = NeoHookean{lambda, mu};
    const std::vector<Fibres> families = {{2363.2, 0.8393, true}, {1500., 1.2, false}, {700., 0.3, true}};
    body.law.fibres.assign(families.begin(), families.begin() + item.choice.n_fibres);
    return body;
  }

  bool is_inside(const Body &body, const unsigned int node)
  {
    for (int d = 0; d < 3; ++d)
      if (body.nodes[node][d] < 1e-12 || body.nodes[node][d] > 1. - 1e-12)
        return false;
    return true;
  }

  Records random_values(const Body &body, const double size)
  {
    Records values(node_record * body.nodes.size());
    for (unsigned int i = 0; i < values.size(); ++i)
      values[i] =
        static_cast<float>(i % node_record == 3 ? random_number(30.) * size / 0.08 : random_number(size));
    return values;
  }

  Records
  affine_values(const Body &body, const Tensor<2, 3> &f, const Vector3<double> &shift, const double heating)
  {
    Records values;
    for (const Point<3> &node : body.nodes)
      {
        for (int c = 0; c < 3; ++c)
          values.push_back(f[c] * node - node[c] + shift[c]);
        values.push_back(heating);
      }
    return values;
  }

  Tensor<2, 3> rotation()
  {
    const double c = std::cos(1.1), s = std::sin(1.1), d = std::cos(0.4), e = std::sin(0.4);
    return Tensor<2, 3>({{c, -s, 0.}, {s, c, 0.}, {0., 0., 1.}}) *
           Tensor<2, 3>({{1., 0., 0.}, {0., d, -e}, {0., e, d}});
  }

  Records scalar_forces(const Body &body, const Records &values)
  {
    Records          forces(values.size(), 0.);
    const auto       shares = node_shares(body, values);
    const ElasticLaw law    = body.cell_law();
    for_each_point(body, values, [&](const CellPoint &point, const auto &h, const double heating) {
      Tensor<2, 3>       stress;
      const Tensor<2, 3> f = tensor(h) + unit_symmetric_tensor<3>();
      if (body.choice.law != SweepChoice::Law::none)
        stress = tensor(law.stress(h, body.directions, expansion * heating));
      if (body.choice.averaged_pressure)
        for (const std::uint32_t node : point.nodes)
          {
            const double ratio = shares[node].ratio();
            stress += body.lambda * std::log(ratio) / ratio / 4. * determinant(f) * transpose(invert(f));
          }
      Tensor<1, 3> slope;
      for (unsigned int a = 0; a < point.nodes.size(); ++a)
        for (int j = 0; j < 3; ++j)
          slope[j] += point.gradients[a][j] * values[4 * point.nodes[a] + 3];
      const Tensor<1, 3> flux = conductivity_tensor(body, f) * slope;
      for (unsigned int a = 0; a < point.nodes.size(); ++a)
        {
          const auto        &g = point.gradients[a].entries;
          const Tensor<1, 3> gradient({g[0], g[1], g[2]}), force = stress * gradient;
          for (int c = 0; c < 3; ++c)
            forces[4 * point.nodes[a] + c] += point.volume * force[c];
          forces[4 * point.nodes[a] + 3] += point.volume * (flux * gradient);
        }
    });
    return forces;
  }

  double energy(const Body &body, const Records &values)
  {
    double           sum = 0.;
    const ElasticLaw law = body.cell_law();
    for_each_point(body, values, [&](const CellPoint &point, const auto &h, const double heating) {
      sum += point.volume * law.energy(h, body.directions, expansion * heating);
    });
    if (body.choice.averaged_pressure)
      for (const NodeShare &share : node_shares(body, values))
        sum += share.stress_free * body.lambda / 2. * std::pow(std::log(share.ratio()), 2);
    return sum;
  }

  double thermal_stretch(const Body &body, const double heating)
  {
    switch (body.choice.stretch)
      {
      case StretchForm::linearised:
        return 1. + expansion * heating;
      case StretchForm::exact:
        return std::exp(expansion * heating);
      default:
        return 1.;
      }
  }

  Tensor<2, 3> conductivity_tensor(const Body &body, const Tensor<2, 3> &f)
  {
    switch (body.choice.conduction)
      {
      case SweepChoice::Conduction::reference:
        return conductivity * unit_symmetric_tensor<3>();
      case SweepChoice::Conduction::deformed:
        return conductivity * determinant(f) * invert(transpose(f) * f);
      default:
        return Tensor<2, 3>();
      }
  }

  Tensor<2, 3> textbook_first_stress(const Body &body, const Tensor<2, 3> &f, const double heating)
  {
    const double       s = thermal_stretch(body, heating);
    const Tensor<2, 3> c = transpose(f) * f, identity = unit_symmetric_tensor<3>();
    const double       j      = determinant(f) / (s * s * s);
    Tensor<2, 3>       stress = s * s * s * (lambda * std::log(j) - mu) * invert(c) + s * mu * identity;
    for (unsigned int i = 0; i < body.law.fibres.size(); ++i)
      {
        const Fibres      &fibres = body.law.fibres[i];
        const auto        &v      = body.directions[i].entries;
        const Tensor<1, 3> a({v[0], v[1], v[2]});
        const double       stretch = a * (c * a) / (s * s) - 1.;
        if (stretch > 0. || !fibres.tension_only)
          stress += 2. * s * fibres.stiffness * stretch * std::exp(fibres.stiffening * stretch * stretch) *
                    outer_product(a, a);
      }
    return f * stress;
  }

  namespace
  {
    /** Calls the kernel; returns what it returned. */
    template <typename Number, int corners>
    bool run(const Body              &body,
             const CellMesh<corners> &mesh,
             const Records           &values,
             const InstructionSet     instruction_set,
             const double             hourglass,
             Records                 &forces)
    {
      const std::size_t                n      = body.nodes.size();
      const TledKernel<Number>         kernel = tled_kernel<Number>(instruction_set);
      const TledCells<corners, Number> cells(mesh, kernel.lanes, body.n_points);
      AlignedVector<Number>            x(node_record * n), f(node_record * n), changes(n), pressures(n);
      std::copy(values.begin(), values.end(), x.begin());
      CellSweep<Number> sweep = cells.sweep(body.material());
      sweep.values            = x.data();
      sweep.forces            = f.data();
      sweep.hourglass         = hourglass;
      sweep.volume_changes    = changes.data();
      sweep.pressures         = pressures.data();
      bool found_healthy      = true;
      if (body.choice.averaged_pressure)
        {
          const std::vector<double> lumped = lumped_volumes(mesh);
          AlignedVector<Number>     volumes(n);
          std::copy(lumped.begin(), lumped.end(), volumes.begin());
          found_healthy = kernel.find_volumes(body.choice)(sweep);
          kernel.pressure({n,
                           x.data(),
                           volumes.data(),
                           changes.data(),
                           pressures.data(),
                           body.choice.stretch,
                           sweep.material});
        }
      const bool healthy = kernel.find(body.choice)(sweep);
      AssertThrow(healthy == found_healthy || !body.choice.averaged_pressure, ExcInternalError());
      forces.assign(f.begin(), f.end());
      return healthy;
    }

    template <typename Number>
    bool run(const Body          &body,
             const Records       &values,
             const InstructionSet instruction_set,
             const double         hourglass,
             Records             &forces)
    {
      return body.choice.hexahedra ?
               run<Number>(body, body.hexahedra, values, instruction_set, hourglass, forces) :
               run<Number>(body, body.tetrahedra, values, instruction_set, hourglass, forces);
    }
  } // namespace

  template <typename Number>
  Records lane_forces(const Body          &body,
                      const Records       &values,
                      const InstructionSet instruction_set,
                      const double         hourglass)
  {
    Records forces;
    AssertThrow(run<Number>(body, values, instruction_set, hourglass, forces), ExcInternalError());
    return forces;
  }

  template <typename Number>
  bool is_healthy(const Body &body, const Records &values, const InstructionSet instruction_set)
  {
    Records forces;
    return run<Number>(body, values, instruction_set, 0., forces);
  }

  template Records lane_forces<float>(const Body &, const Records &, const InstructionSet, const double);
  template Records lane_forces<double>(const Body &, const Records &, const InstructionSet, const double);
  template bool    is_healthy<float>(const Body &, const Records &, const InstructionSet);
  template bool    is_healthy<double>(const Body &, const Records &, const InstructionSet);
} // namespace Cautery::Test
