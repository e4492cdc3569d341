// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/mesh_file.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <unordered_map>

namespace Cautery
{
  namespace
  {
    /** gmsh keeps one global state, which must be given back whatever happens. */
    class GmshSession
    {
    public:
      GmshSession()
      {
        gmsh::initialize(0, nullptr, /*readConfigFiles=*/false);
        gmsh::option::setNumber("General.Terminal", 0);
      }
      ~GmshSession() { gmsh::finalize(); }
      GmshSession(const GmshSession &)            = delete;
      GmshSession &operator=(const GmshSession &) = delete;
    };

    /** One kind of elements of one geometric entity of the file. */
    struct ElementBlock
    {
      unsigned int             dimension;
      unsigned int             n_corners; ///< the corner nodes come first
      unsigned int             n_nodes;
      unsigned int             group; ///< tag of the physical group, 0 for none
      std::vector<std::size_t> nodes; ///< tags, element by element

      std::size_t n_elements() const { return nodes.size() / n_nodes; }
      std::string kind() const
      {
        static const std::map<std::pair<unsigned int, unsigned int>, std::string> kinds = {{{3, 4}, "tetrahedra"},
                                                                                           {{3, 5}, "pyramids"},
                                                                                           {{3, 6}, "prisms"},
                                                                                           {{3, 8}, "hexahedra"},
                                                                                           {{2, 3}, "triangles"},
                                                                                           {{2, 4}, "quadrilaterals"},
                                                                                           {{1, 2}, "lines"}};
        const auto kind = kinds.find({dimension, n_corners});
        return kind == kinds.end() ? "elements of an unknown kind" : kind->second;
      }
    };

    std::string name_of(const MeshSettings &settings)
    {
      return "Mesh file `" + settings.file_name + "`";
    }

    /** The first and the last word of a file that are not blank. */
    std::pair<std::string, std::string> first_and_last_word(std::ifstream &file)
    {
      std::pair<std::string, std::string> words;
      file >> words.first;
      file.clear();
      file.seekg(0, std::ios::end);
      file.seekg(std::max<std::streamoff>(0, file.tellg() - std::streamoff(100)));
      for (std::string word; file >> word;)
        words.second = word;
      return words;
    }

    /**
     * gmsh takes an unknown file for a script and runs it, and reads as much as there is of a file that was cut off:
     * let through only what begins and ends as a mesh. Of .msh and .vtk gmsh itself notices a missing end.
     */
    void check_is_mesh(const MeshSettings &settings)
    {
      static const std::map<std::string, std::string> last_words = {
        {".msh", ""}, {".vtk", ""}, {".unv", "-1"}, {".bdf", "ENDDATA"}, {".mesh", "End"}};
      const std::string &file_name  = settings.file_name;
      const std::size_t  dot        = file_name.find_last_of("./");
      const auto         format     = last_words.find(dot == std::string::npos ? "" : file_name.substr(dot));
      AssertThrow(format != last_words.end(),
                  ExcInput(name_of(settings) + ": the ending must be .msh, .vtk, .unv, .bdf or .mesh; convert other "
                                               "formats with gmsh or meshio"));

      std::ifstream file(file_name, std::ios::binary);
      AssertThrow(file && file.peek() != std::ifstream::traits_type::eof(),
                  ExcInput(name_of(settings) + " is missing, empty or not readable"));
      const auto [first, last] = first_and_last_word(file);
      AssertThrow(format->first != ".msh" || first == "$MeshFormat" || first == "$NOD" || first == "$Comments",
                  ExcInput(name_of(settings) + " does not begin as a gmsh mesh does, with $MeshFormat; export it again"));
      AssertThrow(format->second.empty() || last == format->second,
                  ExcInput(name_of(settings) + " does not end with `" + format->second +
                           "`: it was cut off; export it again"));
    }

    void open(const MeshSettings &settings)
    {
      std::string reason; // the log, since gmsh throws for a few errors only and keeps the last one from file to file
      try
        {
          gmsh::logger::start();
          gmsh::merge(settings.file_name);
        }
      catch (...)
        {
          reason = "gmsh gives no reason";
        }
      std::vector<std::string> messages;
      gmsh::logger::get(messages);
      gmsh::logger::stop();
      for (const auto &message : messages)
        if (message.find("Error") == 0)
          reason = message;
      AssertThrow(reason.empty(),
                  ExcInput(name_of(settings) + " cannot be read (" + reason +
                           "): it may be cut off or of another format; open it in gmsh and export it again as .msh"));
    }

    /** The tag of the one physical group of an entity, 0 for none. */
    unsigned int group_of(const int dimension, const int entity, const MeshSettings &settings)
    {
      std::vector<int> groups;
      gmsh::model::getPhysicalGroupsForEntity(dimension, entity, groups);
      std::vector<std::string> texts;
      for (const int group : groups)
        {
          std::string name;
          gmsh::model::getPhysicalName(dimension, std::abs(group), name);
          texts.push_back(std::to_string(std::abs(group)) + " \"" + name + "\"");
        }
      AssertThrow(groups.size() <= 1,
                  ExcInput(name_of(settings) + ": the geometric entity " + std::to_string(entity) + " of dimension " +
                           std::to_string(dimension) + " is in several physical groups, " + join(texts) +
                           "; put it into one (in a .msh of version 2, groups must not share elementary tags)"));
      return groups.empty() ? 0 : std::abs(groups.front());
    }

    std::vector<ElementBlock> read_elements(const int dimension, const MeshSettings &settings)
    {
      std::vector<ElementBlock>  blocks;
      gmsh::vectorpair           entities;
      gmsh::model::getEntities(entities, dimension);
      for (const auto &entity : entities)
        {
          std::vector<int>                      types;
          std::vector<std::vector<std::size_t>> tags, nodes;
          gmsh::model::mesh::getElements(types, tags, nodes, dimension, entity.second);
          for (unsigned int i = 0; i < types.size(); ++i)
            {
              std::string         name;
              int                 element_dimension, order, n_nodes, n_corners;
              std::vector<double> places;
              gmsh::model::mesh::getElementProperties(
                types[i], name, element_dimension, order, n_nodes, places, n_corners);
              blocks.push_back({static_cast<unsigned int>(dimension),
                                static_cast<unsigned int>(n_corners),
                                static_cast<unsigned int>(n_nodes),
                                group_of(dimension, entity.second, settings),
                                std::move(nodes[i])});
            }
        }
      return blocks;
    }

    /** "120 triangles, 14 prisms" */
    std::string count_text(const std::vector<ElementBlock> &blocks)
    {
      std::map<std::string, std::size_t> counts;
      for (const auto &block : blocks)
        counts[block.kind()] += block.n_elements();
      std::vector<std::string> texts;
      for (const auto &count : counts)
        texts.push_back(std::to_string(count.second) + " " + count.first);
      return texts.empty() ? "none smaller" : join(texts);
    }

    template <int dim>
    void check_kinds(const std::vector<ElementBlock> &cells, const MeshSettings &settings)
    {
      const std::string wanted = (dim == 3 ? "tetrahedra or hexahedra" : "triangles or quadrilaterals");
      if (dim == 2)
        {
          const auto volumes = read_elements(3, settings);
          AssertThrow(volumes.empty(),
                      ExcInput(name_of(settings) + " has volume cells (" + count_text(volumes) +
                               "), but the scene is two-dimensional; set the dimension to 3"));
        }
      AssertThrow(!cells.empty(),
                  ExcInput(name_of(settings) + " has no cells of dimension " + std::to_string(dim) + ", only " +
                           count_text(read_elements(dim - 1, settings)) + "; export its " + wanted));
      for (const auto &block : cells)
        AssertThrow(block.kind() == cells.front().kind() &&
                      (block.n_corners == dim + 1 || block.n_corners == GeometryInfo<dim>::vertices_per_cell),
                    ExcInput(name_of(settings) + " has " + count_text(cells) + "; all cells must be " + wanted));
    }

    /** Numbers the corner nodes of @p cells in the file's order; the map goes from gmsh's tags to vertices. */
    template <int dim>
    std::unordered_map<std::size_t, unsigned int>
    read_vertices(PlainMesh<dim> &mesh, const std::vector<ElementBlock> &cells, const MeshSettings &settings)
    {
      std::vector<std::size_t> tags;
      std::vector<double>      places, parameters;
      gmsh::model::mesh::getNodes(tags, places, parameters, -1, -1, false, /*returnParametricCoord=*/false);

      enum class Use : unsigned char
      {
        none,
        middle,
        corner
      };
      std::unordered_map<std::size_t, Use> uses(2 * tags.size());
      for (const auto &block : cells)
        for (std::size_t n = 0; n < block.nodes.size(); ++n)
          {
            Use &use = uses[block.nodes[n]];
            use      = std::max(use, n % block.n_nodes < block.n_corners ? Use::corner : Use::middle);
          }

      static const std::map<MeshSettings::LengthUnit, double> metres = {{MeshSettings::LengthUnit::metre, 1.},
                                                                        {MeshSettings::LengthUnit::centimetre, 1e-2},
                                                                        {MeshSettings::LengthUnit::millimetre, 1e-3}};
      const double                                  scale = metres.at(settings.length_unit);
      std::unordered_map<std::size_t, unsigned int> vertex_of(2 * tags.size());
      double       lowest_z = std::numeric_limits<double>::infinity(), highest_z = -lowest_z, highest = 0.;
      unsigned int n_orphans = 0, n_middle = 0;
      for (std::size_t n = 0; n < tags.size(); ++n)
        {
          const auto use = uses.find(tags[n]);
          if (use == uses.end() || use->second == Use::middle)
            {
              ++(use == uses.end() ? n_orphans : n_middle);
              continue;
            }
          vertex_of[tags[n]] = mesh.vertices.size();
          Point<dim> vertex;
          for (unsigned int d = 0; d < dim; ++d)
            {
              vertex[d] = scale * places[3 * n + d];
              highest   = std::max(highest, std::abs(places[3 * n + d]));
            }
          mesh.vertices.push_back(vertex);
          lowest_z  = std::min(lowest_z, places[3 * n + 2]);
          highest_z = std::max(highest_z, places[3 * n + 2]);
        }
      AssertThrow(dim == 3 || highest_z - lowest_z <= 1e-9 * highest,
                  ExcInput(name_of(settings) + " is a surface in space, z = " + to_text(lowest_z) + " to " +
                           to_text(highest_z) + "; a two-dimensional mesh must lie in a plane of constant z"));
      if (n_middle > 0)
        mesh.notes.push_back(std::to_string(n_middle) + " nodes within second-order cells dropped: cells are linear");
      if (n_orphans > 0)
        mesh.notes.push_back(std::to_string(n_orphans) + " nodes that belong to no cell dropped");
      return vertex_of;
    }

    /** gmsh goes round a quadrilateral, deal.II goes row by row. */
    template <int structdim>
    void reorder(std::vector<unsigned int> &vertices)
    {
      if (vertices.size() == GeometryInfo<structdim>::vertices_per_cell)
        for (unsigned int v = 3; v < vertices.size(); v += 4)
          std::swap(vertices[v - 1], vertices[v]);
    }

    /** Elements with a node that is no vertex are left out and counted: faces that touch no cell. */
    template <int structdim>
    std::size_t append(std::vector<CellData<structdim>>                    &elements,
                       const std::vector<ElementBlock>                     &blocks,
                       const std::unordered_map<std::size_t, unsigned int> &vertex_of)
    {
      std::size_t left_out = 0;
      for (const auto &block : blocks)
        for (std::size_t e = 0; e < block.n_elements(); ++e)
          {
            CellData<structdim> element(block.n_corners);
            bool                complete = true;
            for (unsigned int v = 0; v < block.n_corners && complete; ++v)
              {
                const auto vertex = vertex_of.find(block.nodes[e * block.n_nodes + v]);
                complete          = (vertex != vertex_of.end());
                if (complete)
                  element.vertices[v] = vertex->second;
              }
            if (!complete)
              {
                ++left_out;
                continue;
              }
            reorder<structdim>(element.vertices);
            element.material_id = block.group; // of faces this is the boundary id: a union
            elements.push_back(std::move(element));
          }
      return left_out;
    }

    template <typename Id>
    std::map<Id, std::string> names_of(const std::vector<ElementBlock> &blocks)
    {
      std::map<Id, std::string> names;
      for (const auto &block : blocks)
        {
          std::string &name = names[block.group];
          if (block.group != 0 && name.empty())
            gmsh::model::getPhysicalName(block.dimension, block.group, name);
        }
      return names;
    }
  } // namespace

  template <int dim>
  PlainMesh<dim> read_mesh_file(const MeshSettings &settings)
  {
    check_is_mesh(settings);
    const GmshSession session;
    open(settings);

    PlainMesh<dim> mesh;
    const auto     cells = read_elements(dim, settings);
    check_kinds<dim>(cells, settings);
    const auto vertex_of = read_vertices(mesh, cells, settings);

    const std::size_t without_nodes = append(mesh.cells, cells, vertex_of);
    AssertThrow(without_nodes == 0,
                ExcInput(name_of(settings) + ": " + std::to_string(without_nodes) +
                         " cells refer to nodes that the file does not have; it may be cut off, export it again"));

    auto faces = read_elements(dim - 1, settings);
    faces.erase(std::remove_if(faces.begin(), faces.end(), [](const auto &block) { return block.group == 0; }),
                faces.end());
    const std::size_t loose_faces = append(mesh.faces, faces, vertex_of);
    if (loose_faces > 0)
      mesh.notes.push_back(std::to_string(loose_faces) + " faces of physical surfaces ignored: they touch no cell");

    mesh.regions  = names_of<types::material_id>(cells);
    mesh.surfaces = names_of<types::boundary_id>(faces);
    return mesh;
  }

  template PlainMesh<2> read_mesh_file(const MeshSettings &);
  template PlainMesh<3> read_mesh_file(const MeshSettings &);
} // namespace Cautery
