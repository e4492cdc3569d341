// SPDX-License-Identifier: LGPL-2.1-or-later
// Equilibrium in large deformation: large GROUP. Exit status 0 if all is right.
#include "large.h"

namespace Verification
{
  const std::vector<Element> elements = {{"tetrahedra of degree 1", true, 1},
                                         {"tetrahedra of degree 2", true, 2},
                                         {"hexahedra of degree 1", false, 1},
                                         {"hexahedra of degree 2", false, 2}};

  std::vector<Override> joined(const std::vector<std::vector<Override>> &lists)
  {
    std::vector<Override> result;
    for (const auto &list : lists)
      result.insert(result.end(), list.begin(), list.end());
    return result;
  }

  const std::vector<Override> two_families = {{"Tissues/tissue/Elastic law", "neo-Hookean"},
                                              {"Tissues/tissue/Fibre families", "one, two"},
                                              {"Tissues/tissue/one/Fibre direction", "0.73; 0.68; 0"},
                                              {"Tissues/tissue/two/Fibre direction", "0.73; -0.68; 0"}};

  const std::vector<Variant> laws = {{"linear", {{"Tissues/tissue/Elastic law", "linear"}}},
                                     {"neo-Hookean", {{"Tissues/tissue/Elastic law", "neo-Hookean"}}},
                                     {"with fibres", two_families},
                                     {"with fibres that resist compression",
                                      joined({two_families,
                                              {{"Tissues/tissue/one/Fibres in tension only", "off"},
                                               {"Tissues/tissue/two/Fibres in tension only", "off"}}})}};

  const std::vector<Override> warm = {{"Effects/Heat", "Fourier"},
                                      {"Effects/Coupling", "expansion"},
                                      {"Initial state/Temperature", "340"},
                                      {"Tissues/tissue/Thermal expansion coefficient", "2e-3"}};

  const std::vector<Variant> heats = {
    {"", {}},
    {", heated, linearised", joined({warm, {{"Tissues/tissue/Thermal stretch", "linearised"}}})},
    {", heated, exact", joined({warm, {{"Tissues/tissue/Thermal stretch", "exact"}}})}};

  double difference(const Outcome &one, const Outcome &other)
  {
    const std::string             end = to_text(one.summary.at("end_time_s"));
    std::map<std::string, double> largest, apart;
    for (const auto &[place, row] : one.probes)
      for (const auto &[column, value] : row)
        {
          if (place.first != end)
            continue;
          const std::string kind = column.substr(0, column.find('_'));
          largest[kind]          = std::max(largest[kind], std::abs(value));
          apart[kind]            = std::max(apart[kind], std::abs(value - other.end(place.second, column)));
        }
    double result = largest.empty() ? std::numeric_limits<double>::infinity() : 0.;
    for (const auto &[kind, value] : apart)
      if (kind == "displacement" || kind == "stress")
        result = std::max(result, value / largest[kind]);
    return result;
  }

  std::vector<Override> bent_cube(const Element &element, const Tensor<2, 3> &rotation)
  {
    static unsigned int n_meshes = 0;
    const std::string   name     = std::filesystem::absolute("cube_" + std::to_string(++n_meshes) + ".msh");
    const unsigned int  n        = element.degree == 1 ? 3 : 2;
    BlockMesh{
      element.tetrahedra, {{n, n, n}}, 0.2, [&](const Point<3> &unit) { return Point<3>(rotation * unit); }}
      .write(name);
    return {{"Mesh/Shape", "file"},
            {"Mesh/File name", name},
            {"Numerics/Element degree", std::to_string(element.degree)}};
  }
} // namespace Verification

int main(int argc, char **argv)
{
  using namespace Verification;
  return run_group(argc,
                   argv,
                   {{"tangent", tangent},
                    {"order", order},
                    {"homogeneous", homogeneous},
                    {"limits", limits},
                    {"cook", cook},
                    {"relaxation", relaxation},
                    {"motion", motion},
                    {"vibration", vibration}});
}
