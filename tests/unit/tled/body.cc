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

    /** What @p work(shape, H, directions, thermal strain, corners) makes of each cell. */
    template <typename Work>
    void for_each_cell(const Body &body, const Records &values, const Work &work)
    {
      for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
        {
          const auto             &corners = body.mesh.cells[cell];
          std::array<Point<3>, 4> points;
          for (int a = 0; a < 4; ++a)
            points[a] = body.mesh.nodes[corners[a]];
          const TetrahedronShape shape(points);
          Matrix3<double>        h    = {};
          double                 mean = 0.;
          for (int a = 0; a < 4; ++a)
            {
              mean += values[4 * corners[a] + 3] / 4.;
              for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                  h(i, j) +=
                    (values[4 * corners[a] + i] - values[4 * corners[0] + i]) * shape.gradients[a][j];
            }
          const auto first = body.mesh.directions.begin() + body.mesh.n_fibres * cell;
          work(
            shape, h, ElasticLaw::Directions(first, first + body.mesh.n_fibres), expansion * mean, corners);
        }
    }
  } // namespace

  std::vector<Case> cases()
  {
    using Law                = SweepChoice::Law;
    std::vector<Case> result = {{"conduction", {Law::none, StretchForm::none, 0, true}}};
    const std::vector<std::pair<std::string, StretchForm>> forms = {
      {"", StretchForm::none}, {", linearised", StretchForm::linearised}, {", exact", StretchForm::exact}};
    for (const auto &form : forms)
      for (const bool conduction : {false, true})
        {
          const std::string heat = form.first + (conduction ? ", conduction" : "");
          result.push_back({"linear" + heat, {Law::small_strain, form.second, 0, conduction}});
          for (const unsigned int n_fibres : {0, 1, 2, 3})
            result.push_back({"neo-Hookean, " + std::to_string(n_fibres) + " fibres" + heat,
                              {Law::neo_hookean, form.second, n_fibres, conduction}});
        }
    return result;
  }

  Body make_body(const Case &item)
  {
    generator.seed(11);
    Body body;
    body.choice = item.choice;
    for (unsigned int i = 0; i <= edge; ++i)
      for (unsigned int j = 0; j <= edge; ++j)
        for (unsigned int k = 0; k <= edge; ++k)
          body.mesh.nodes.emplace_back(1. * i / edge, 1. * j / edge, 1. * k / edge);
    for (unsigned int n = 0; n < body.mesh.nodes.size(); ++n)
      if (is_inside(body, n))
        for (int d = 0; d < 3; ++d)
          body.mesh.nodes[n][d] += random_number(0.05);

    const int paths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (unsigned int i = 0; i < edge * edge * edge; ++i)
      for (const auto &path : paths)
        {
          unsigned int            at[3] = {i / (edge * edge), i / edge % edge, i % edge};
          TetrahedraMesh::Corners corners;
          for (int a = 0; a < 4; ++a)
            {
              corners[a] = (at[0] * (edge + 1) + at[1]) * (edge + 1) + at[2];
              if (a < 3)
                ++at[path[a]];
            }
          body.mesh.cells.push_back(corners);
        }

    body.mesh.n_fibres                  = item.choice.n_fibres;
    const Vector3<double> directions[3] = {{{0.6, 0.8, 0.}}, {{0.48, -0.6, 0.64}}, {{0., 0., 1.}}};
    for (unsigned int cell = 0; cell < body.mesh.cells.size(); ++cell)
      for (unsigned int f = 0; f < item.choice.n_fibres; ++f)
        body.mesh.directions.push_back(directions[f]);

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
      if (body.mesh.nodes[node][d] < 1e-12 || body.mesh.nodes[node][d] > 1. - 1e-12)
        return false;
    return true;
  }

  Records random_values(const Body &body, const double size)
  {
    Records values(node_record * body.mesh.nodes.size());
    for (unsigned int i = 0; i < values.size(); ++i)
      values[i] =
        static_cast<float>(i % node_record == 3 ? random_number(30.) * size / 0.08 : random_number(size));
    return values;
  }

  Records
  affine_values(const Body &body, const Tensor<2, 3> &f, const Vector3<double> &shift, const double heating)
  {
    Records values;
    for (const Point<3> &node : body.mesh.nodes)
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
    Records forces(values.size(), 0.);
    for_each_cell(
      body,
      values,
      [&](const auto &shape, const auto &h, const auto &a, const double strain, const auto &corners) {
        Matrix3<double> stress = {};
        if (body.choice.law != SweepChoice::Law::none)
          stress = body.law.stress(h, a, strain);
        Vector3<double> slope = {};
        if (body.choice.conduction)
          for (int corner = 0; corner < 4; ++corner)
            for (int j = 0; j < 3; ++j)
              slope[j] += shape.gradients[corner][j] * values[4 * corners[corner] + 3];
        for (int corner = 0; corner < 4; ++corner)
          {
            const Vector3<double> force = stress * shape.gradients[corner];
            for (int c = 0; c < 3; ++c)
              forces[4 * corners[corner] + c] += shape.volume * force[c];
            forces[4 * corners[corner] + 3] +=
              shape.volume * conductivity * dot(slope, shape.gradients[corner]);
          }
      });
    return forces;
  }

  double energy(const Body &body, const Records &values)
  {
    double sum = 0.;
    for_each_cell(
      body, values, [&](const auto &shape, const auto &h, const auto &a, const double strain, const auto &) {
        sum += shape.volume * body.law.energy(h, a, strain);
      });
    return sum;
  }

  Tensor<2, 3> textbook_first_stress(const Body &body, const Tensor<2, 3> &f, const double heating)
  {
    const double       s = body.choice.stretch == StretchForm::none       ? 1. :
                           body.choice.stretch == StretchForm::linearised ? 1. + expansion * heating :
                                                                            std::exp(expansion * heating);
    const Tensor<2, 3> c = transpose(f) * f, identity = unit_symmetric_tensor<3>();
    const double       j      = determinant(f) / (s * s * s);
    Tensor<2, 3>       stress = s * s * s * (lambda * std::log(j) - mu) * invert(c) + s * mu * identity;
    for (unsigned int i = 0; i < body.law.fibres.size(); ++i)
      {
        const Fibres      &fibres = body.law.fibres[i];
        const auto        &v      = body.mesh.directions[i].entries;
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
    template <typename Number>
    bool run(const Body &body, const Records &values, const InstructionSet instruction_set, Records &forces)
    {
      const TledKernel<Number>     kernel = tled_kernel<Number>(instruction_set);
      const TledTetrahedra<Number> cells(body.mesh, kernel.lanes);
      AlignedVector<Number>        x(values.size()), f(values.size());
      std::copy(values.begin(), values.end(), x.begin());
      TetrahedraSweep<Number> sweep = cells.sweep(body.material());
      sweep.values                  = x.data();
      sweep.forces                  = f.data();
      const bool healthy            = kernel.find(body.choice)(sweep);
      forces.assign(f.begin(), f.end());
      return healthy;
    }
  } // namespace

  template <typename Number>
  Records lane_forces(const Body &body, const Records &values, const InstructionSet instruction_set)
  {
    Records forces;
    AssertThrow(run<Number>(body, values, instruction_set, forces), ExcInternalError());
    return forces;
  }

  template <typename Number>
  bool is_healthy(const Body &body, const Records &values, const InstructionSet instruction_set)
  {
    Records forces;
    return run<Number>(body, values, instruction_set, forces);
  }

  template Records lane_forces<float>(const Body &, const Records &, const InstructionSet);
  template Records lane_forces<double>(const Body &, const Records &, const InstructionSet);
  template bool    is_healthy<float>(const Body &, const Records &, const InstructionSet);
  template bool    is_healthy<double>(const Body &, const Records &, const InstructionSet);
} // namespace Cautery::Test
