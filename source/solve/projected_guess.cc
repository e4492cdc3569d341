// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/solve/projected_guess.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Cautery
{
  namespace
  {
    double dot(const double *x, const double *y, const std::size_t n)
    {
      // four chains, or the additions would wait for each other
      double      sum[4] = {0., 0., 0., 0.};
      std::size_t i      = 0;
      for (; i + 4 <= n; i += 4)
        for (unsigned int k = 0; k < 4; ++k)
          sum[k] += x[i + k] * y[i + k];
      for (; i < n; ++i)
        sum[0] += x[i] * y[i];
      return (sum[0] + sum[1]) + (sum[2] + sum[3]);
    }

    /// result += sum of factor_j column_j
    void combine(const std::vector<double> &columns,
                 const std::vector<double> &factors,
                 double                    *result,
                 const std::size_t          n)
    {
      for (unsigned int j = 0; j < factors.size(); ++j)
        {
          const double *const column = columns.data() + j * n;
          const double        factor = factors[j];
          for (std::size_t i = 0; i < n; ++i)
            result[i] += factor * column[i];
        }
    }

    void negate(std::vector<double> &factors)
    {
      for (double &factor : factors)
        factor = -factor;
    }
  } // namespace

  void ProjectedGuess::clear()
  {
    n_directions = 0;
    directions.clear();
    images.clear();
  }

  std::vector<double> ProjectedGuess::products(const std::vector<double> &columns, const Vector &x) const
  {
    const std::size_t   n = x.locally_owned_size();
    std::vector<double> result(n_directions);
    for (unsigned int j = 0; j < n_directions; ++j)
      result[j] = dot(columns.data() + j * n, x.begin(), n);
    const MPI_Comm communicator = x.get_mpi_communicator();
    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
      Utilities::MPI::sum(result, communicator, result);
    return result;
  }

  void ProjectedGuess::apply(Vector &x, Vector &residual) const
  {
    x = 0.;
    if (n_directions == 0)
      return;
    const std::size_t n       = x.locally_owned_size();
    auto              factors = products(directions, residual);
    combine(directions, factors, x.begin(), n);
    negate(factors);
    combine(images, factors, residual.begin(), n);
  }

  bool ProjectedGuess::add(const Vector &direction, const Vector &image)
  {
    const std::size_t n = direction.locally_owned_size();
    Vector            d = direction, a = image;
    const double      start = d * a;
    // twice is enough: the second round removes what rounding left of the first
    for (unsigned int round = 0; round < 2; ++round)
      {
        auto factors = products(images, d);
        negate(factors);
        combine(directions, factors, d.begin(), n);
        combine(images, factors, a.begin(), n);
      }
    const double norm_square = d * a;
    if (!(norm_square > 1e-20 * start))
      return false;
    const double scale = 1. / std::sqrt(norm_square);
    d *= scale;
    a *= scale;
    directions.insert(directions.end(), d.begin(), d.end());
    images.insert(images.end(), a.begin(), a.end());
    ++n_directions;
    return true;
  }

  void ProjectedGuess::learn(const Vector &x,
                             const Vector &image_of_x,
                             const Vector &correction,
                             const Vector &image)
  {
    if (capacity == 0)
      return;
    if (n_directions < capacity)
      {
        add(correction, image);
        return;
      }
    clear();
    add(x, image_of_x);
  }
} // namespace Cautery
