// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/critical_step.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Cautery
{
  namespace
  {
    /// Sweeps for a bound that is a few percent too large.
    constexpr unsigned int n_lanczos = 24;
    /// What the differences may err: in single precision, 1 %.
    constexpr double margin = 1.02;

    /// The tridiagonal matrix's largest eigenvalue, plus @p next times the last entry of its vector.
    double bound(const std::vector<double> &diagonal, const std::vector<double> &beside, const double next)
    {
      const unsigned int       n = diagonal.size();
      LAPACKFullMatrix<double> matrix(n, n);
      matrix = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          matrix(i, i) = diagonal[i];
          if (i + 1 < n)
            matrix(i, i + 1) = matrix(i + 1, i) = beside[i];
        }
      double radius = 0.; // of Gershgorin's circles
      for (unsigned int i = 0; i < n; ++i)
        radius = std::max(radius, std::abs(diagonal[i]) + 2. * (n > 1 ? beside[std::min(i, n - 2)] : 0.));
      AssertThrow(
        std::all_of(diagonal.begin(), diagonal.end(), [](const double d) { return std::isfinite(d); }) &&
          std::all_of(beside.begin(), beside.end(), [](const double b) { return std::isfinite(b); }),
        ExcRun(
          "the stable step cannot be told, as forces are not finite: the motion has blown up or is beyond "
          "the tissue's law; load more gently, or take a smaller Time/Step"));
      if (radius == 0.)
        return next; // nothing resists: LAPACK would look for eigenvalues between 0 and 0
      dealii::Vector<double> eigenvalues;
      FullMatrix<double>     vectors;
      // what LAPACK recommends: with a coarser accuracy vectors of close values may not converge
      const double accuracy = 2. * std::numeric_limits<double>::min();
      matrix.compute_eigenvalues_symmetric(-4. * radius, 4. * radius, accuracy, eigenvalues, vectors);
      const unsigned int last = eigenvalues.size() - 1;
      return eigenvalues(last) + next * std::abs(vectors(n - 1, last));
    }
  } // namespace

  template <typename Number>
  CriticalStep<Number>::CriticalStep(TledBody<Number>          &body,
                                     TledNodes<Number>         &nodes,
                                     const Part                 part,
                                     const std::vector<double> &weights)
    : body(body)
    , nodes(nodes)
    , part(part)
    , weights(weights)
    , first(part == Part::motion ? 0 : node_record - 1)
    , n_components(part == Part::motion ? node_record - 1 : 1)
    , length(nodes.shortest_edge())
    , base_forces(nodes.zero())
    , forces(nodes.zero())
  {
  }

  /** Numbers without any order, that depend on the places only, not on how they are numbered. */
  template <typename Number>
  typename CriticalStep<Number>::Numbers CriticalStep<Number>::start() const
  {
    Numbers result;
    for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
      for (unsigned int c = 0; c < n_components; ++c)
        {
          const Point<3> place = nodes.places()[node] / length;
          const double wild = 1e4 * std::sin(12.9898 * place[0] + 78.233 * place[1] + 37.719 * place[2] + c);
          result.push_back(wild - std::floor(wild) - 0.5);
        }
    return result;
  }

  template <typename Number>
  double CriticalStep<Number>::product(const Numbers &a, const Numbers &b) const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += weights[i / n_components] * a[i] * b[i];
    return Utilities::MPI::sum(sum, nodes.communicator());
  }

  /** M^-1 K @p direction, by differences. */
  template <typename Number>
  void CriticalStep<Number>::tangent(const Numbers &direction, Numbers &result)
  {
    double largest = 0.;
    for (const double entry : direction)
      largest = std::max(largest, std::abs(entry));
    largest = Utilities::MPI::max(largest, nodes.communicator());
    // strains that neither drown in rounding nor leave the linear range; temperatures of any size
    const double size =
      (part == Part::motion ? length * std::sqrt(std::numeric_limits<Number>::epsilon()) : 1.) / largest;
    displaced = base;
    for (std::size_t i = 0; i < direction.size(); ++i)
      displaced[node_record * (i / n_components) + first + i % n_components] += size * direction[i];
    nodes.update(displaced);
    forces.fill(Number(0.));
    body.add_forces(part, displaced, forces, TledBody<Number>::SlackFibres::as_if_taut);
    nodes.collect(forces);
    for (std::size_t i = 0; i < direction.size(); ++i)
      {
        const std::size_t entry = node_record * (i / n_components) + first + i % n_components;
        result[i] =
          (static_cast<double>(forces[entry]) - base_forces[entry]) / (size * weights[i / n_components]);
      }
  }

  template <typename Number>
  double CriticalStep<Number>::largest_eigenvalue(const Records &values)
  {
    base = values;
    base_forces.fill(Number(0.));
    body.add_forces(part, base, base_forces, TledBody<Number>::SlackFibres::as_if_taut);
    nodes.collect(base_forces);

    Numbers             v = start(), before(v.size(), 0.), w(v.size());
    std::vector<double> diagonal, beside;
    double              size = std::sqrt(product(v, v));
    if (size == 0.)
      return 0.; // all nodes are held
    for (unsigned int i = 0; i < n_lanczos; ++i)
      {
        for (double &entry : v)
          entry /= size;
        tangent(v, w);
        diagonal.push_back(product(v, w));
        for (std::size_t k = 0; k < w.size(); ++k)
          w[k] -= diagonal.back() * v[k] + (i > 0 ? size : 0.) * before[k];
        before.swap(v);
        v.swap(w);
        size = std::sqrt(product(v, v));
        if (size <= 1e-10 * diagonal.front())
          break; // all eigenvalues that the start contains are found
        beside.push_back(size);
      }
    return margin * bound(diagonal, beside, size);
  }

  template <typename Number>
  double CriticalStep<Number>::steady_share() const
  {
    return part == Part::motion && body.fibres_buckle() ? std::sqrt(0.5) : 1.;
  }

  template class CriticalStep<float>;
  template class CriticalStep<double>;
} // namespace Cautery
