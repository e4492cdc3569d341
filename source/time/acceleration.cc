// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/acceleration.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>

namespace Cautery
{
  namespace
  {
    constexpr unsigned int remembered_rounds = 5;
    constexpr double       regularisation    = 1e-12;
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
    rounds.push_back({iterate, direction});
    // turns become shorter by orders of magnitude: each in units of its own length
    std::vector<double> lengths;
    for (const auto &turn : turns)
      lengths.push_back(turn.l2_norm());
    if (n == 0 || *std::min_element(lengths.begin(), lengths.end()) == 0.)
      return;
    FullMatrix<double>     products(n, n);
    dealii::Vector<double> wanted(n), shares(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        wanted(i) = turns[i] * direction / lengths[i];
        for (unsigned int k = 0; k < n; ++k)
          products(i, k) = turns[i] * turns[k] / (lengths[i] * lengths[k]) + (i == k ? regularisation : 0.);
      }
    products.gauss_jordan();
    products.vmult(shares, wanted);
    for (unsigned int i = 0; i < n; ++i)
      {
        turns[i] += rounds[i + 1].iterate;
        turns[i] -= rounds[i].iterate;
        direction.add(-shares(i) / lengths[i], turns[i]);
      }
    if (!(residual * direction > 0.))
      direction = rounds.back().direction;
  }
} // namespace Cautery
