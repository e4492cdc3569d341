// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/temperature_limiter.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  namespace
  {
    /// Nodes along a path of heat; beyond, all warmer nodes of the body lend.
    constexpr unsigned int farthest = 32;
    /// Of the surplus; less is rounding.
    constexpr double nothing = 1e-15;
    /// Of the matrix's diagonal.
    constexpr double smallest_weight = 1e-6;

    double sum(const Vector &x) { return x.l1_norm(); } // none of these vectors has negative entries
  }                                                     // namespace

  Vector TemperatureLimiter::lift(const SparseMatrix &system,
                                  const Elimination  &constraints,
                                  const double        floor,
                                  Vector             &temperature)
  {
    for (auto *vector : {&weights, &lack, &surplus, &paid, &product})
      vector->reinit(temperature);
    find_neighbours(system);
    find_weights(system, constraints);

    const Vector before = temperature;
    find_balance(floor, temperature);
    for (unsigned int reach = 1; reach <= farthest && sum(lack) > nothing * sum(surplus); reach *= 2)
      {
        lend(reach, temperature);
        find_balance(floor, temperature);
      }
    share(floor, temperature);
    ++n_steps;

    Vector gain = temperature;
    gain -= before;
    gain.scale(weights);
    return gain;
  }

  void TemperatureLimiter::find_neighbours(const SparseMatrix &system)
  {
    neighbours.copy_from(system);
    const auto rows = system.local_range();
    for (auto row = rows.first; row < rows.second; ++row)
      for (auto entry = neighbours.begin(row); entry != neighbours.end(row); ++entry)
        entry->value() = entry->column() == row ? 0. : std::abs(entry->value());
    neighbours.compress(VectorOperation::insert);
    const double largest = neighbours.linfty_norm();
    if (largest > 0.)
      neighbours /= largest;
  }

  void TemperatureLimiter::find_weights(const SparseMatrix &system, const Elimination &constraints)
  {
    paid = 1.;
    constraints.keep_constrained(paid);
    product = 1.;
    product -= paid;
    system.vmult(weights, product);
    const auto rows = system.local_range();
    for (auto row = rows.first; row < rows.second; ++row)
      {
        // badly shaped cells at prescribed temperatures could make a sum negative
        double &weight = weights.begin()[row - rows.first];
        weight         = paid(row) > 0. ? 0. : std::max(weight, smallest_weight * system.diag_element(row));
      }
  }

  void TemperatureLimiter::find_balance(const double floor, const Vector &temperature)
  {
    for (unsigned int i = 0; i < temperature.locally_owned_size(); ++i)
      {
        const double excess = weights.begin()[i] * (temperature.begin()[i] - floor);
        surplus.begin()[i]  = std::max(0., excess);
        lack.begin()[i]     = std::max(0., -excess);
      }
  }

  void TemperatureLimiter::spread(const unsigned int reach, Vector &x)
  {
    for (unsigned int i = 0; i < reach; ++i)
      {
        neighbours.vmult(product, x);
        x.swap(product);
      }
  }

  /**
   * Node i asks each j that it reaches for its share of lack_i, (B_ij surplus_j) / (B surplus)_i. Who is
   * asked for more than it has pays the same part of every demand. What is paid is what is got, since B is
   * symmetric.
   */
  void TemperatureLimiter::lend(const unsigned int reach, Vector &temperature)
  {
    const unsigned int n      = temperature.locally_owned_size();
    Vector             asking = surplus;
    spread(reach, asking);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double within = asking.begin()[i];
        asking.begin()[i]   = within > 0. ? lack.begin()[i] / within : 0.;
      }
    Vector asked = asking; // of each joule of surplus
    spread(reach, asked);
    for (unsigned int j = 0; j < n; ++j)
      paid.begin()[j] = surplus.begin()[j] / std::max(1., asked.begin()[j]);
    Vector got = paid;
    spread(reach, got);
    const double *const asks = asking.begin(), *const gets = got.begin(), *const pays = paid.begin(),
                        *const is_asked = asked.begin(), *const weight = weights.begin();
    for (unsigned int i = 0; i < n; ++i)
      if (weight[i] > 0.)
        temperature.begin()[i] += (asks[i] * gets[i] - pays[i] * is_asked[i]) / weight[i];
  }

  /// What is still lacking: the same part of every surplus; or, where all together do not suffice, from
  /// outside.
  void TemperatureLimiter::share(const double floor, Vector &temperature)
  {
    const double has = sum(surplus), part = has > 0. ? std::max(0., 1. - sum(lack) / has) : 0.;
    for (unsigned int i = 0; i < temperature.locally_owned_size(); ++i)
      if (weights.begin()[i] > 0.)
        temperature.begin()[i] = floor + part * std::max(0., temperature.begin()[i] - floor);
  }
} // namespace Cautery
