// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/description.h>

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <utility>

namespace Cautery
{
  template <int dim>
  std::string description(const Scene &scene, const Body<dim> &body, const Problem<dim> &problem)
  {
    std::ostringstream out;
    const auto        &mesh = body.mesh;
    if (!scene.title.empty())
      out << scene.title << "\n\n";
    const bool from_file = scene.mesh.shape == MeshSettings::Shape::file;
    out << "Effects on     " << join(scene.effects.on(), ", ") << '\n'
        << "Effects off    " << join(scene.effects.off(), ", ") << '\n'
        << "Mesh           "
        << (from_file ? std::filesystem::path(scene.mesh.file_name).filename().string() : "box") << ": "
        << mesh.n_cells() << ' '
        << (mesh.simplices() ? (dim == 3 ? "tetrahedra" : "triangles") :
                               (dim == 3 ? "hexahedra" : "quadrilaterals"))
        << ", " << mesh.n_vertices() << " nodes, " << mesh.volume() << (dim == 3 ? " m3" : " m2") << '\n';
    for (const auto &note : mesh.notes())
      out << "               note: " << note << '\n';
    out << "Unknowns      ";
    std::string comma;
    for (const auto &[name, number] : problem.unknowns())
      out << std::exchange(comma, ",") << ' ' << number << ' ' << name;
    out << '\n' << "Time           " << scene.time.end << " s, ";
    if (scene.time.integrator == TimeSettings::Integrator::ida)
      out << "steps chosen by IDA";
    else
      out << std::ceil(scene.time.end / scene.time.step * (1. - 1e-12)) << " steps of " << scene.time.step
          << " s";
    out << ", " << scene.output.output_times(scene.time.end).size() << " output times\n"
        << "Memory         " << std::fixed << std::setprecision(0)
        << 1e-6 * Utilities::MPI::max(Cost::peak_memory(), mesh.communicator())
        << " MB a process before the first step\n\n";
    return out.str();
  }

  template std::string description(const Scene &, const Body<2> &, const Problem<2> &);
  template std::string description(const Scene &, const Body<3> &, const Problem<3> &);
} // namespace Cautery
