// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes from boxes and files, what is mended and what is refused in them, and finding points. The output is
// the same on any number of processes.
#include <cautery/base/interruption.h>
#include <cautery/space/mesh.h>
#include <cautery/space/partition.h>
#include <cautery/space/points.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/timer.h>
#include <deal.II/grid/grid_generator.h>

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <random>
#include <set>
#include <sstream>

#include <sys/time.h>
#include <unistd.h>

using namespace Cautery;

namespace
{
  const MPI_Comm communicator = MPI_COMM_WORLD;

  ConditionalOStream out(std::cout, false);

  MeshSettings box(const MeshSettings::Cells  cells,
                   const std::vector<double> &subdivisions,
                   const Point<3>            &upper       = Point<3>(0.01, 0.01, 0.01),
                   const unsigned int         refinements = 0)
  {
    MeshSettings settings;
    settings.cells        = cells;
    settings.subdivisions = subdivisions;
    settings.upper        = upper;
    settings.refinements  = refinements;
    return settings;
  }

  MeshSettings file(const std::string &name)
  {
    MeshSettings settings;
    settings.shape     = MeshSettings::Shape::file;
    settings.file_name = name;
    return settings;
  }

  /** Cells, vertices, the volume of each region, the area of each surface. */
  template <int dim>
  void describe(const std::string &title, const MeshSettings &settings)
  {
    const Mesh<dim>                      mesh(settings, communicator);
    std::map<types::boundary_id, double> areas;
    for (const auto &surface : mesh.surfaces())
      areas[surface.first] = 0.;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      for (const auto f : cell->face_indices())
        if (cell->is_locally_owned() && cell->at_boundary(f))
          areas.at(cell->face(f)->boundary_id()) += cell->face(f)->measure();

    out << title << ": " << mesh.n_cells() << " cells, " << mesh.n_vertices() << " vertices" << std::endl;
    for (const auto &[id, name] : mesh.regions())
      out << "  region " << id << " \"" << name << "\" volume " << mesh.volumes().at(id) << std::endl;
    for (const auto &[id, name] : mesh.surfaces())
      out << "  surface " << id << " \"" << name << "\" area " << Utilities::MPI::sum(areas[id], communicator)
          << std::endl;
    for (const auto &note : mesh.notes())
      out << "  note: " << note << std::endl;
  }

  /** The message of the ExcInput that @p work must throw on all processes. */
  template <typename Work>
  void refused(const std::string &title, const Work &work)
  {
    std::string reason = "ACCEPTED";
    try
      {
        work();
      }
    catch (const ExcInput &exception)
      {
        reason = message_of(exception);
      }
    const bool everywhere = Utilities::MPI::min(reason == "ACCEPTED" ? 0 : 1, communicator) == 1;
    out << title << ": " << (everywhere ? "" : "NOT ON ALL PROCESSES ") << reason << std::endl;
  }

  /** Two unit cubes on each other, of 3 x 3 x 3 small cubes each; `interface` lies between them. */
  void make_two_cubes(const bool hexahedra)
  {
    namespace geo = gmsh::model::geo;
    gmsh::model::add("two cubes");
    const int        corner = geo::addPoint(0, 0, 0);
    gmsh::vectorpair line, square, lower, upper;
    geo::extrude({{0, corner}}, 1, 0, 0, line, {3}, {}, hexahedra);
    geo::extrude({line[1]}, 0, 1, 0, square, {3}, {}, hexahedra);
    geo::extrude({square[1]}, 0, 0, 1, lower, {3}, {}, hexahedra);
    geo::extrude({lower[0]}, 0, 0, 1, upper, {3}, {}, hexahedra);
    geo::synchronize();
    const auto group =
      [](const int dim, const std::vector<int> &entities, const int tag, const std::string &name) {
        gmsh::model::addPhysicalGroup(dim, entities, tag);
        gmsh::model::setPhysicalName(dim, tag, name);
      };
    group(3, {lower[1].second}, 1, "lower");
    group(3, {upper[1].second}, 7, "upper");
    group(2, {square[1].second}, 2, "bottom");
    group(2, {lower[0].second}, 3, "interface");
    gmsh::model::mesh::generate(3);
  }

  void write(const std::string &name, const double version, const bool binary, const bool all = false)
  {
    gmsh::option::setNumber("Mesh.MshFileVersion", version);
    gmsh::option::setNumber("Mesh.Binary", binary);
    gmsh::option::setNumber("Mesh.SaveAll", all);
    gmsh::write(name);
  }

  void write_gmsh_files()
  {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    make_two_cubes(false);
    write("version_1.msh", 1., false);
    write("version_2.msh", 2.2, false);
    write("version_2_binary.msh", 2.2, true);
    write("version_4.msh", 4.1, false);
    write("version_4_binary.msh", 4.1, true);
    write("cubes.unv", 4.1, false);
    for (const std::string name : {"cubes.vtk", "cubes.bdf", "cubes.mesh"})
      write(name, 4.1, false);
    gmsh::model::mesh::setOrder(2);
    write("second_order.msh", 4.1, true);
    make_two_cubes(true);
    write("hexahedra.msh", 4.1, false);
    gmsh::finalize();
  }

  /** A file of version 2.2; each element is "type group nodes ...". */
  void write_small(const std::string              &name,
                   const std::vector<std::string> &nodes,
                   const std::vector<std::string> &elements)
  {
    std::ofstream text(name);
    text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << nodes.size() << '\n';
    for (unsigned int n = 0; n < nodes.size(); ++n)
      text << n + 1 << ' ' << nodes[n] << '\n';
    text << "$EndNodes\n$Elements\n" << elements.size() << '\n';
    for (unsigned int e = 0; e < elements.size(); ++e)
      {
        std::istringstream element(elements[e]);
        std::string        type, group, rest;
        element >> type >> group;
        std::getline(element, rest);
        text << e + 1 << ' ' << type << " 2 " << group << ' ' << group << rest << '\n';
      }
    text << "$EndElements\n";
  }

  void write_small_files()
  {
    const std::vector<std::string> nodes       = {"0 0 0", "1 0 0", "0 1 0", "0 0 1", "1 1 1", "5 5 5"};
    const std::string              tetrahedron = "4 1 1 2 3 4", other = "4 1 2 3 4 5";
    write_small(
      "mend.msh", nodes, {tetrahedron, "4 1 2 3 5 4", tetrahedron, "2 4 2 3 4", "2 5 1 2 3", "2 6 1 2 6"});
    write_small("split.msh",
                {"0 0 0", "1 0 0", "0 1 0", "0 0 1", "1 0 0", "0 1 0", "0 0 1", "1 1 1"},
                {tetrahedron, "4 1 5 6 7 8"});
    write_small("two groups.msh", nodes, {tetrahedron, "4 2 1 2 3 4"});
    write_small("two surfaces.msh", nodes, {tetrahedron, "2 4 1 2 3", "2 5 2 1 3"});
    write_small("flat.msh", {"0 0 0", "1 0 0", "0 1 0", "0.25 0.25 0"}, {tetrahedron});
    write_small("infinite.msh", {"0 0 0", "1 0 0", "0 1 0", "0 0 inf"}, {tetrahedron});
    write_small("overlap.msh",
                {"0 0 0", "1 0 0", "0 1 0", "0 0 1", "0 0 -1", "1 1 2"},
                {tetrahedron, "4 1 1 2 3 5", "4 1 1 2 3 6"});
    write_small("mixed.msh", nodes, {tetrahedron, "7 1 1 2 3 4 5"});
    write_small("surface.msh", nodes, {"2 1 1 2 3"});
    const std::vector<std::string> cube = {
      "0 0 0", "1 0 0", "1 1 0", "0 1 0", "0 0 1", "1 0 1", "1 1 1", "0 1 1"};
    write_small("turned.msh", cube, {"5 1 5 6 7 8 1 2 3 4"});
    write_small("dented.msh",
                {cube[0], cube[1], cube[2], cube[3], cube[4], cube[5], "0.2 0.2 0.1", cube[7]},
                {"5 1 1 2 3 4 5 6 7 8"});
    write_small("plane.msh", {"0 0 3", "2 0 3", "1.5 1 3", "0 1 3"}, {"3 1 1 2 3 4", "1 2 1 2"});
    write_small("bent.msh", {"0 0 3", "2 0 3", "1.5 1 4", "0 1 3"}, {"3 1 1 2 3 4"});
    std::ofstream("words.msh") << "SystemCall \"touch harm\";\n";
    for (const std::string name :
         {"version_2.msh", "version_4_binary.msh", "cubes.vtk", "cubes.unv", "cubes.mesh"})
      {
        std::filesystem::copy_file(name, "cut " + name);
        std::filesystem::resize_file("cut " + name, std::filesystem::file_size(name) * 6 / 10);
      }
  }

  void test_boxes()
  {
    const auto     tetrahedra = MeshSettings::Cells::tetrahedra, hexahedra = MeshSettings::Cells::hexahedra;
    const Point<3> sides(1., 2., 3.);
    out << "Boxes: n^3 cubes of 6 tetrahedra, (n + 1)^3 vertices; in 2D n^2 squares of 2 triangles"
        << std::endl;
    describe<3>("6000 tetrahedra", box(tetrahedra, {10}));
    describe<3>("2 x 3 x 4 x 6 tetrahedra, sides 1, 2, 3", box(tetrahedra, {2, 3, 4}, sides));
    describe<3>("2 x 3 x 4 hexahedra", box(hexahedra, {2, 3, 4}, sides));
    describe<3>("48 tetrahedra refined twice into 64 each", box(tetrahedra, {2}, sides, 2));
    describe<2>("5 x 4 x 2 triangles", box(tetrahedra, {5, 4}, sides));
    describe<2>("5 x 4 squares refined once, the third entry ignored", box(hexahedra, {5, 4, 7}, sides, 1));

    const auto make = [](const MeshSettings &settings) { return [=]() { Mesh<3>(settings, communicator); }; };
    refused("half a subdivision", make(box(tetrahedra, {2.5})));
    refused("two subdivisions", make(box(tetrahedra, {2, 2})));
    refused("no height", make(box(tetrahedra, {2}, Point<3>(1., 1., 0.))));
    refused("too many vertices", make(box(tetrahedra, {1000})));
  }

  void test_files()
  {
    out << "Files: two unit cubes, 162 tetrahedra or 27 hexahedra each; their interface has 18 or 9 faces"
        << std::endl;
    for (const std::string name : {"version_1.msh",
                                   "version_2.msh",
                                   "version_2_binary.msh",
                                   "version_4.msh",
                                   "version_4_binary.msh",
                                   "second_order.msh",
                                   "hexahedra.msh",
                                   "cubes.unv"})
      describe<3>(name, file(name));
    out << "Files: formats whose groups gmsh does not read" << std::endl;
    for (const std::string name : {"cubes.vtk", "cubes.bdf", "cubes.mesh"})
      describe<3>(name, file(name));

    MeshSettings centimetres = file("version_2.msh"), millimetres = file("hexahedra.msh");
    centimetres.length_unit = MeshSettings::LengthUnit::centimetre;
    millimetres.length_unit = MeshSettings::LengthUnit::millimetre;
    out << "Length units: volumes 2e-6 and 2e-9" << std::scientific << std::endl;
    out << Mesh<3>(centimetres, communicator).volume() << ' ' << Mesh<3>(millimetres, communicator).volume()
        << std::fixed << std::endl;
  }

  void test_mending()
  {
    const auto read = [](const std::string &name) {
      MeshSettings settings = file(name);
      settings.refinements  = 1; // so that there are enough cells for several processes
      return settings;
    };
    out << "Mended, and each cell refined into 2^dim" << std::endl;
    describe<3>("doubled and inverted tetrahedra (1/6 and 1/3), an orphan, interior and loose faces",
                read("mend.msh"));
    describe<3>("the same two without a common face", read("split.msh"));
    describe<3>("an inverted hexahedron", read("turned.msh"));
    describe<2>("a trapezium at z = 3, area 1.75", read("plane.msh"));
    out << "Refused" << std::endl;
    for (const std::string name : {"two groups.msh",
                                   "two surfaces.msh",
                                   "flat.msh",
                                   "infinite.msh",
                                   "overlap.msh",
                                   "mixed.msh",
                                   "surface.msh",
                                   "dented.msh",
                                   "words.msh",
                                   "cut version_2.msh",
                                   "cut version_4_binary.msh",
                                   "cut cubes.vtk",
                                   "cut cubes.unv",
                                   "cut cubes.mesh",
                                   "missing.msh",
                                   "mesh.med"})
      refused(name, [&]() { Mesh<3>(file(name), communicator); });
    refused("volumes in 2D", []() { Mesh<2>(file("version_2.msh"), communicator); });
    refused("a bent surface in 2D", []() { Mesh<2>(file("bent.msh"), communicator); });
    out << "gmsh ran a script: " << std::filesystem::exists("harm") << std::endl;
  }

  void test_names()
  {
    const Mesh<3> mesh(file("version_2.msh"), communicator);
    const auto    print = [](const auto &ids) {
      for (const auto id : ids)
        out << ' ' << id;
      out << std::endl;
    };
    out << "Names: 1 7, 7, 0 2, 2" << std::endl;
    print(mesh.region_ids({"all"}, "Who asks"));
    print(mesh.region_ids({"upper", "7"}, "Who asks"));
    print(mesh.surface_ids({"all"}, "Who asks"));
    print(mesh.surface_ids({"bottom"}, "Who asks"));
    refused("region", [&]() { mesh.region_ids({"lower", "liver"}, "Who asks"); });
    refused("interior surface", [&]() { mesh.surface_ids({"interface"}, "Who asks"); });
  }

  /** Are @p place's coordinates in the corners' basis all positive (a tetrahedron contains it)? */
  bool is_in_tetrahedron(const Triangulation<3>::active_cell_iterator &cell, const Point<3> &place)
  {
    const auto volume = [](const Point<3> &a, const Point<3> &b, const Point<3> &c, const Point<3> &d) {
      return (b - a) * cross_product_3d(c - a, d - a) / 6.;
    };
    for (unsigned int v = 0; v < 4; ++v)
      {
        std::array<Point<3>, 4> corners = {
          {cell->vertex(0), cell->vertex(1), cell->vertex(2), cell->vertex(3)}};
        corners[v] = place;
        if (volume(corners[0], corners[1], corners[2], corners[3]) < -1e-9 * cell->measure())
          return false;
      }
    return true;
  }

  /** How many places have not exactly one owner, and how many are in a wrong cell or at a wrong unit place.
   */
  template <int dim>
  void count_wrong(const std::string &title, const Mesh<dim> &mesh, const std::vector<Point<dim>> &places)
  {
    const auto                results = PointLocator<dim>(mesh).find(places);
    std::vector<unsigned int> owners(places.size());
    unsigned int              wrong = 0, outside = 0;
    Tensor<1, dim>            centers;
    for (unsigned int p = 0; p < places.size(); ++p)
      {
        outside += results[p].outside;
        if (const auto &location = results[p].location)
          {
            owners[p] = 1;
            centers += location->cell->center();
            const auto back  = mesh.mapping().transform_unit_to_real_cell(location->cell, location->unit);
            bool       right = location->cell->is_locally_owned() && back.distance(places[p]) < 1e-8;
            if constexpr (dim == 3)
              right = right && (!mesh.simplices() || is_in_tetrahedron(location->cell, places[p]));
            wrong += !right;
          }
      }
    std::vector<unsigned int> all_owners(places.size());
    Utilities::MPI::sum(owners, communicator, all_owners);
    const auto with_one = std::count(all_owners.begin(), all_owners.end(), 1u);
    out << title << ": " << places.size() << " places, " << with_one << " with one owner, " << outside
        << " outside, " << Utilities::MPI::sum(wrong, communicator) << " wrong; sum of the cells' centres "
        << Utilities::MPI::sum(centers, communicator) << std::endl;
  }

  template <int dim>
  std::vector<Point<dim>> random_places(const unsigned int n, const Point<3> &sides)
  {
    std::mt19937            random(1);
    std::vector<Point<dim>> places(n);
    for (auto &place : places)
      for (unsigned int d = 0; d < dim; ++d)
        place[d] = sides[d] * (random() + 0.5) / 4294967296.;
    return places;
  }

  /** The nodes of a box of @p n^3 cubes, and the points half way between them: on edges, faces and diagonals.
   */
  std::vector<Point<3>> nodes_and_middles(const unsigned int n, const Point<3> &sides)
  {
    std::vector<Point<3>> places;
    for (unsigned int i = 0; i <= 2 * n; ++i)
      for (unsigned int j = 0; j <= 2 * n; ++j)
        for (unsigned int k = 0; k <= 2 * n; ++k)
          places.emplace_back(sides[0] * i / (2 * n), sides[1] * j / (2 * n), sides[2] * k / (2 * n));
    return places;
  }

  void test_points()
  {
    const Point<3> sides(0.7, 1.1, 0.3);
    out << "Points: all found once, none wrong, the same cells on any number of processes" << std::endl;
    for (const auto cells : {MeshSettings::Cells::tetrahedra, MeshSettings::Cells::hexahedra})
      {
        const Mesh<3> mesh(box(cells, {5}, sides), communicator);
        const Mesh<3> refined(box(cells, {3}, sides, 1), communicator);
        const Mesh<2> plane(box(cells, {5}, sides), communicator);
        count_wrong("at random", mesh, random_places<3>(1000, sides));
        count_wrong("nodes and middles", mesh, nodes_and_middles(5, sides));
        count_wrong("at random, refined", refined, random_places<3>(1000, sides));
        count_wrong("nodes and middles, refined", refined, nodes_and_middles(6, sides));
        count_wrong("at random in 2D", plane, random_places<2>(1000, sides));
      }
    const auto   places  = random_places<2>(1000, Point<3>(2., 1., 0.));
    unsigned int outside = 0;
    for (const auto &place : places)
      outside += (place[0] > 2. - 0.5 * place[1]);
    out << "In the trapezium " << outside << " of 1000 must be outside" << std::endl;
    MeshSettings trapezium = file("plane.msh");
    trapezium.refinements  = 2;
    count_wrong("trapezium", Mesh<2>(trapezium, communicator), places);

    const Mesh<3> mesh(box(MeshSettings::Cells::tetrahedra, {5}, sides), communicator);
    refused("outside", [&]() {
      PointLocator<3>(mesh).find_inside({Point<3>(0.1, 0.1, 0.1), Point<3>(0.7, 1.1, 0.5)},
                                        {"Probe `root`", "Probe `tip`"});
    });
    refused("not a number", [&]() {
      PointLocator<3>(mesh).find_inside({Point<3>(0., 0., std::numeric_limits<double>::quiet_NaN())},
                                        {"Probe `tip`"});
    });
  }

  /// Signals that come at any time while a mesh is cut: each reaches whom it is for, and the cut is done.
  void test_signals()
  {
    out << "\nSIGTERM while METIS cuts a mesh" << std::endl;
    Triangulation<3> mesh;
    GridGenerator::subdivided_hyper_cube(mesh, 16);
    struct sigaction now = {};
    now.sa_handler       = [](const int) { std::raise(SIGTERM); };
    sigaction(SIGALRM, &now, nullptr);
    unsigned int asked = 0, obeyed_at_once = 0, parts = 0;
    for (unsigned int milliseconds = 1; milliseconds <= 30; ++milliseconds)
      {
        Interruption    interruption;
        const itimerval after{{0, 0}, {0, 1000 * milliseconds}};
        setitimer(ITIMER_REAL, &after, nullptr);
        partition(mesh, 4);
        // the timer may be slower than METIS, and the signal come to another thread
        const Timer clock;
        while (interruption.wish() != Interruption::Wish::stop && clock.wall_time() < 10.)
          ;
        asked += clock.wall_time() < 10.;
        struct sigaction second = {};
        sigaction(SIGTERM, nullptr, &second);
        obeyed_at_once += second.sa_handler == SIG_DFL;
        std::set<types::subdomain_id> found;
        for (const auto &cell : mesh.active_cell_iterators())
          found.insert(cell->subdomain_id());
        parts += found.size();
      }
    out << "of 30 runs asked to stop: " << asked << ", a second signal would end: " << obeyed_at_once
        << ", parts in all: " << parts << std::endl;
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                       is_root = Utilities::MPI::this_mpi_process(communicator) == 0;
  out.set_condition(is_root);
  out << std::fixed << std::setprecision(6);

  // files are called by their plain names, so that messages are the same wherever the test runs
  const std::string directory = Utilities::MPI::broadcast(
    communicator,
    (std::filesystem::temp_directory_path() / ("cautery_mesh_" + std::to_string(getpid()))).string(),
    0);
  std::filesystem::create_directories(directory);
  std::filesystem::current_path(directory);
  if (is_root)
    {
      write_gmsh_files();
      write_small_files();
    }
  MPI_Barrier(communicator);

  test_boxes();
  test_files();
  test_mending();
  test_names();
  test_points();
  test_signals();

  MPI_Barrier(communicator);
  std::filesystem::current_path("/");
  if (is_root)
    std::filesystem::remove_all(directory);
}
