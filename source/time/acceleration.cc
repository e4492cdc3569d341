// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/acceleration.h>

#include <deal.II/lac/full_matrix.h>

namespace Cautery
{
  namespace
  {
    constexpr unsigned int remembered_rounds = 5;
  } // namespace

  void Acceleration::accelerate(const Vector &iterate, const Vector &residual, Vector &direction)
  {
    if (rounds.size() > remembered_rounds)
      rounds.erase(rounds.begin());
    const unsigned int  n = rounds.size();
    std::vector<Vector> turns; // the changes of direction between rounds
    for (unsigned int i = 0; i < n; ++i)
      {
        turns.push_back(i + 1 < n ? rounds[i + 1].direction : direction);
        turns.back() -= rounds[i].direction;
      }
    FullMatrix<double>     products(n, n);
    dealii::Vector<double> wanted(n), shares(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        wanted(i) = turns[i] * direction;
        for (unsigned int k = 0; k < n; ++k)
          products(i, k) = turns[i] * turns[k] * (i == k ? 1. + 1e-12 : 1.);
      }
    rounds.push_back({iterate, direction});
    if (n == 0 || products.trace() == 0.)
      return;
    products.gauss_jordan();
    products.vmult(shares, wanted);
    for (unsigned int i = 0; i < n; ++i)
      {
        turns[i] += rounds[i + 1].iterate;
        turns[i] -= rounds[i].iterate;
        direction.add(-shares(i), turns[i]);
      }
    if (!(residual * direction > 0.))
      direction = rounds.back().direction;
  }
} // namespace Cautery
