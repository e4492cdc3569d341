// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/output/extremes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  void Extremes::observe(const State &state, const unsigned int dimension)
  {
    if (state.temperature.size() > 0)
      {
        const auto [least, most] = std::minmax_element(state.temperature.begin(), state.temperature.end());
        hottest_now              = *most;
        temperature_max          = std::max(temperature_max, *most);
        temperature_min          = std::min(temperature_min, *least);
      }
    const double *const u = state.displacement.size() > 0 ? state.displacement.begin() : nullptr;
    if (u != nullptr)
      for (unsigned int i = 0; i < state.displacement.locally_owned_size(); i += dimension)
        {
          double square = 0.;
          for (unsigned int c = 0; c < dimension; ++c)
            square += u[i + c] * u[i + c];
          displacement_max = std::max(displacement_max, std::sqrt(square));
        }
    if (state.ln_damage.size() > 0)
      ln_damage_max =
        std::max(ln_damage_max, *std::max_element(state.ln_damage.begin(), state.ln_damage.end()));
  }

  void Extremes::archive(Archive &archive)
  {
    archive.shared("temperature max", temperature_max);
    archive.shared("temperature min", temperature_min);
    archive.shared("displacement max", displacement_max);
    archive.shared("ln damage max", ln_damage_max);
    archive.shared("hottest now", hottest_now);
  }

  Extremes Extremes::reduced(const MPI_Comm communicator) const
  {
    Extremes all         = *this;
    all.temperature_max  = Utilities::MPI::max(temperature_max, communicator);
    all.temperature_min  = Utilities::MPI::min(temperature_min, communicator);
    all.displacement_max = Utilities::MPI::max(displacement_max, communicator);
    all.ln_damage_max    = Utilities::MPI::max(ln_damage_max, communicator);
    all.hottest_now      = Utilities::MPI::max(hottest_now, communicator);
    return all;
  }
} // namespace Cautery
