// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/mesh_settings.h>

namespace Cautery
{
  void MeshSettings::parameters(Parameters &p)
  {
    p.entry(
      "Shape", shape, Choices<Shape>{{"box", Shape::box}, {"file", Shape::file}}, "A box, or a mesh file");
    p.entry(
      "Cells",
      cells,
      Choices<Cells>{{"tetrahedra", Cells::tetrahedra}, {"hexahedra", Cells::hexahedra}},
      "Cells of the box; each cell of its grid is cut into six tetrahedra (in two dimensions: triangles or "
      "quadrilaterals)");
    p.entry("Lower corner", lower, "m", "Corner of the box with the smallest coordinates");
    p.entry("Upper corner", upper, "m", "Corner of the box with the largest coordinates");
    p.entry("Subdivisions",
            subdivisions,
            "",
            "Cells of the box's grid along x, y, z",
            Bounds{1., 10000., false, false});
    p.entry("File name", file_name, "What gmsh reads, relative to the scene's folder");
    p.entry("Length unit",
            length_unit,
            Choices<LengthUnit>{
              {"m", LengthUnit::metre}, {"cm", LengthUnit::centimetre}, {"mm", LengthUnit::millimetre}},
            "Unit of the file's coordinates");
    p.entry(
      "Refinements", refinements, "How often every cell is divided, into 2^dimension", Bounds::between(0, 8));
    p.section("Adaptive", [&]() { adaptive.parameters(p); });
    if (!p.reading())
      return;
    if (shape == Shape::file && file_name.empty())
      p.reject("File name", "", "name the mesh file, or set Shape = box");
    for (const double number : subdivisions)
      if (number != static_cast<unsigned int>(number))
        p.reject("Subdivisions", to_text(number), "these are whole numbers");
  }
} // namespace Cautery
