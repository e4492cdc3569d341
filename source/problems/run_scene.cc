// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/description.h>
#include <cautery/problems/run_scene.h>

#include <iomanip>
#include <sstream>

namespace Cautery
{
  RunRecord run_scene(const Scene       &scene,
                      const MPI_Comm     communicator,
                      const std::string &directory,
                      const Voice        voice,
                      const bool         resume)
  {
    if (scene.dimension == 2)
      return Simulation<2>(scene, communicator).run(directory, voice, resume);
    return Simulation<3>(scene, communicator).run(directory, voice, resume);
  }

  namespace
  {
    template <int dim>
    std::string checked(const Scene &scene, const MPI_Comm communicator)
    {
      Simulation<dim>    simulation(scene, communicator);
      std::ostringstream out;
      out << description(scene, simulation.simulated_body(), simulation.simulated_problem());
      const auto forecast = simulation.trial();
      out << std::setprecision(3) << "Forecast       about " << forecast.seconds << " s and " << std::fixed
          << std::setprecision(0) << 1e-6 * forecast.bytes << " MB, from a trial of the first "
          << forecast.after_steps << (forecast.after_steps == 1 ? " step" : " steps")
          << "\nThe scene is complete and consistent.\n";
      return out.str();
    }
  } // namespace

  std::string checked_scene(const Scene &scene, const MPI_Comm communicator)
  {
    return scene.dimension == 2 ? checked<2>(scene, communicator) : checked<3>(scene, communicator);
  }
} // namespace Cautery
