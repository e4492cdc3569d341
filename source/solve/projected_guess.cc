// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/solve/projected_guess.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Cautery
{
  namespace
  {
    using Numbers = std::vector<double>;

    /// Of a direction, relative to the matrix's norm and the direction's square. The image errs by 1e-16 of
    /// these and orthonormalisation may add four digits: so directions are right to 1e-4.
    constexpr double least_energy = 1e-8;

    /// y += sign columns factors
    void add(const Numbers &columns, const Numbers &factors, const double sign, Vector &y)
    {
      const types::blas_int n = y.locally_owned_size(), n_columns = factors.size(), stride = 1;
      const double          one = 1.;
      if (n > 0 && n_columns > 0)
        gemv(
          "N", &n, &n_columns, &sign, columns.data(), &n, factors.data(), &stride, &one, y.begin(), &stride);
    }

    /// columns = columns combinations, these also one after the other
    void recombine(Numbers &columns, const std::vector<Numbers> &combinations, const unsigned int n_columns)
    {
      const types::blas_int n = columns.size() / n_columns, n_old = n_columns, n_new = combinations.size();
      const double          one = 1., zero = 0.;
      Numbers               factors, result;
      result.reserve(columns.capacity());
      result.resize(n * n_new);
      for (const auto &combination : combinations)
        factors.insert(factors.end(), combination.begin(), combination.end());
      if (n > 0 && n_new > 0)
        gemm("N",
             "N",
             &n,
             &n_new,
             &n_old,
             &one,
             columns.data(),
             &n,
             factors.data(),
             &n_old,
             &zero,
             result.data(),
             &n);
      columns.swap(result);
    }

    double product(const Numbers &x, const Numbers &y)
    {
      return std::inner_product(x.begin(), x.end(), y.begin(), 0.);
    }

    /// An orthonormal basis of the vectors' span, the last vector first; what is next to dependent is left
    /// out.
    std::vector<Numbers> orthonormal_basis(const std::vector<Numbers> &vectors)
    {
      std::vector<Numbers> basis;
      for (auto vector = vectors.rbegin(); vector != vectors.rend(); ++vector)
        {
          Numbers      x     = *vector;
          const double start = std::sqrt(product(x, x));
          for (unsigned int round = 0; round < 2; ++round)
            for (const auto &e : basis)
              {
                const double factor = product(e, x);
                for (std::size_t i = 0; i < x.size(); ++i)
                  x[i] -= factor * e[i];
              }
          const double norm = std::sqrt(product(x, x));
          if (!(norm > 1e-10 * start))
            continue;
          for (double &value : x)
            value /= norm;
          basis.push_back(x);
        }
      return basis;
    }
  } // namespace

  void ProjectedGuess::clear(const double matrix_norm)
  {
    norm         = matrix_norm;
    n_directions = 0;
    directions.clear();
    images.clear();
    solutions.clear();
  }

  ProjectedGuess::Coefficients ProjectedGuess::products(const Vector &x) const
  {
    Coefficients          result(n_directions, 0.);
    const types::blas_int n = x.locally_owned_size(), n_columns = n_directions, stride = 1;
    const double          one = 1., zero = 0.;
    if (n > 0 && n_columns > 0)
      gemv(
        "T", &n, &n_columns, &one, directions.data(), &n, x.begin(), &stride, &zero, result.data(), &stride);
    if (n_columns > 0)
      Utilities::MPI::sum(result, x.get_mpi_communicator(), result);
    return result;
  }

  void ProjectedGuess::apply(Vector &x, Vector &residual)
  {
    x = 0.;
    if (capacity == 0)
      return;
    if (2 * solutions.size() >= capacity)
      solutions.erase(solutions.begin());
    solutions.push_back(products(residual));
    add(directions, solutions.back(), 1., x);
    add(images, solutions.back(), -1., residual);
  }

  /// False where the direction is next to nothing, or the matrix next to blind to it (as to the rigid motions
  /// of a body that only its inertia holds): of what rounding makes, the image is not that of the direction
  /// any more, and directions made of such ones grow without bounds.
  bool ProjectedGuess::orthonormalise(Vector &direction, Vector &image, Coefficients &removed) const
  {
    // of the solution so far, and of the correction: squares of their energy norms
    const double whole = product(removed, removed), start = direction * image;
    double       square = start, last = 0.;
    // once, and again where so much went away that its rounding matters: Daniel, Gragg, Kaufman and Stewart,
    // Math. Comp. 30 (1976) 772-795
    for (unsigned int round = 0; round < 2 && square > 0. && !(square > 0.5 * last && round > 0); ++round)
      {
        const Coefficients factors = products(image);
        add(directions, factors, -1., direction);
        add(images, factors, -1., image);
        std::transform(factors.begin(), factors.end(), removed.begin(), removed.begin(), std::plus<>());
        last   = square;
        square = direction * image;
      }
    if (!(square > 1e-8 * start && square > 1e-22 * whole))
      return false;
    const double length = direction.l2_norm();
    if (!(square > least_energy * norm * length * length))
      return false;
    direction *= 1. / std::sqrt(square);
    image *= 1. / std::sqrt(square);
    removed.push_back(std::sqrt(square));
    return true;
  }

  void ProjectedGuess::learn(Vector &correction, Vector &image)
  {
    if (capacity == 0)
      return;
    if (n_directions == capacity)
      condense();
    if (!orthonormalise(correction, image, solutions.back()))
      return;
    const std::size_t n = correction.locally_owned_size();
    directions.reserve(n * capacity);
    images.reserve(n * capacity);
    directions.insert(directions.end(), correction.begin(), correction.end());
    images.insert(images.end(), image.begin(), image.end());
    ++n_directions;
    for (auto &solution : solutions)
      solution.resize(n_directions, 0.);
  }

  void ProjectedGuess::archive(Archive &archive)
  {
    Numbers sizes = {static_cast<double>(n_directions), static_cast<double>(solutions.size())}, coefficients;
    for (const auto &solution : solutions)
      coefficients.insert(coefficients.end(), solution.begin(), solution.end());
    if (!archive.own("sizes", sizes))
      return;
    archive.own("directions", directions);
    archive.own("images", images);
    archive.own("solutions", coefficients);
    if (!archive.restores())
      return;
    n_directions = sizes[0];
    solutions.clear();
    for (auto first = coefficients.begin(); solutions.size() < sizes[1]; first += n_directions)
      solutions.emplace_back(first, first + n_directions);
  }

  void ProjectedGuess::condense()
  {
    auto combinations = orthonormal_basis(solutions);
    combinations.resize(
      std::min<std::size_t>(combinations.size(), capacity - 1)); // there must be room for one more
    recombine(directions, combinations, n_directions);
    recombine(images, combinations, n_directions);
    n_directions = combinations.size();
    for (auto &solution : solutions)
      {
        Coefficients coefficients;
        for (const auto &combination : combinations)
          coefficients.push_back(product(combination, solution));
        solution = coefficients;
      }
  }
} // namespace Cautery
