// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/child_process.h>
#include <cautery/base/parameters.h>
#include <cautery/space/gmsh_file.h>

#include <gmsh.h>

#include <algorithm>
#include <fstream>
#include <map>

namespace Cautery
{
  namespace
  {
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
     * gmsh takes an unknown file for a script and runs it, and reads as much as there is of a file that was
     * cut off: let through only what begins and ends as a mesh. Of .msh and .vtk gmsh itself notices a
     * missing end.
     */
    void check_is_mesh(const std::string &file_name, const std::string &name)
    {
      static const std::map<std::string, std::string> last_words = {
        {".msh", ""}, {".vtk", ""}, {".unv", "-1"}, {".bdf", "ENDDATA"}, {".mesh", "End"}};
      const std::size_t dot    = file_name.find_last_of("./");
      const auto        format = last_words.find(dot == std::string::npos ? "" : file_name.substr(dot));
      AssertThrow(format != last_words.end(),
                  ExcInput(name + ": the ending must be .msh, .vtk, .unv, .bdf or .mesh; convert other "
                                  "formats with gmsh or meshio"));

      std::ifstream file(file_name, std::ios::binary);
      AssertThrow(
        file && file.peek() != std::ifstream::traits_type::eof(),
        ExcInput(name +
                 " is missing, empty or not readable; give Mesh/File name relative to the scene's folder"));
      const auto [first, last] = first_and_last_word(file);
      AssertThrow(format->first != ".msh" || first == "$MeshFormat" || first == "$NOD" ||
                    first == "$Comments",
                  ExcInput(name + " does not begin as a gmsh mesh does, with $MeshFormat; export it again"));
      AssertThrow(
        format->second.empty() || last == format->second,
        ExcInput(name + " does not end with `" + format->second + "`: it was cut off; export it again"));
    }

    void start_gmsh()
    {
      gmsh::initialize(0, nullptr, /*readConfigFiles=*/false);
      gmsh::option::setNumber("General.Terminal", 0);
    }

    /**
     * Reads a file. Why gmsh cannot, or "": from the log, since it throws for a few errors only and keeps its
     * last error from file to file.
     */
    std::string merge(const std::string &file_name)
    {
      std::string reason;
      try
        {
          gmsh::logger::start();
          gmsh::merge(file_name);
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
      return reason;
    }

    /**
     * Some broken files make gmsh write where it may not, which ends a process or leaves it without sense:
     * a child reads first, and the program only what the child could. Why it could not, or "".
     */
    std::string fault_met_by_child(const std::string &file_name)
    {
      const auto reason = found_by_child([&]() {
        start_gmsh();
        std::string fault = merge(file_name);
        if (fault.empty())
          {
            // a cell of a node that is not there shows here
            std::vector<int>                      types;
            std::vector<std::vector<std::size_t>> tags, nodes;
            gmsh::model::mesh::getElements(types, tags, nodes);
          }
        gmsh::finalize();
        return fault;
      });
      return reason ? *reason : "it breaks gmsh: a count, number or type in it is impossible";
    }
  } // namespace

  std::string ElementBlock::kind() const
  {
    static const std::map<std::pair<unsigned int, unsigned int>, std::string> kinds = {
      {{3, 4}, "tetrahedra"},
      {{3, 5}, "pyramids"},
      {{3, 6}, "prisms"},
      {{3, 8}, "hexahedra"},
      {{2, 3}, "triangles"},
      {{2, 4}, "quadrilaterals"},
      {{1, 2}, "lines"}};

    const auto kind = kinds.find({dimension, n_corners});
    return kind == kinds.end() ? "elements of an unknown kind" : kind->second;
  }

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

  GmshFile::GmshFile(const std::string &file_name) : name("Mesh file `" + file_name + "`")
  {
    check_is_mesh(file_name, name);
    check_merged(fault_met_by_child(file_name));
    start_gmsh();
    try
      {
        check_merged(merge(file_name));
      }
    catch (...)
      {
        gmsh::finalize(); // the destructor is not called then
        throw;
      }
  }

  GmshFile::~GmshFile() { gmsh::finalize(); }

  void GmshFile::check_merged(const std::string &fault) const
  {
    AssertThrow(
      fault.empty(),
      ExcInput(name + " cannot be read (" + fault +
               "): it may be cut off or of another format; open it in gmsh and export it again as .msh"));
  }

  GmshFile::Nodes GmshFile::nodes() const
  {
    Nodes               all;
    std::vector<double> parameters;
    gmsh::model::mesh::getNodes(
      all.tags, all.places, parameters, -1, -1, false, /*returnParametricCoord=*/false);
    return all;
  }

  std::string GmshFile::group_name(const unsigned int dimension, const unsigned int group) const
  {
    std::string text;
    gmsh::model::getPhysicalName(dimension, group, text);
    return text;
  }

  /** The tag of the one physical group of an entity, 0 for none. */
  unsigned int GmshFile::group_of(const unsigned int dimension, const int entity) const
  {
    std::vector<int> groups;
    gmsh::model::getPhysicalGroupsForEntity(dimension, entity, groups);
    std::vector<std::string> texts;
    for (const int group : groups)
      texts.push_back(std::to_string(std::abs(group)) + " \"" + group_name(dimension, std::abs(group)) +
                      "\"");
    AssertThrow(
      groups.size() <= 1,
      ExcInput(name + ": the geometric entity " + std::to_string(entity) + " of dimension " +
               std::to_string(dimension) + " is in several physical groups, " + join(texts) +
               "; put it into one (in a .msh of version 2, groups must not share elementary tags)"));
    return groups.empty() ? 0 : std::abs(groups.front());
  }

  std::vector<ElementBlock> GmshFile::elements(const unsigned int dimension) const
  {
    std::vector<ElementBlock> blocks;
    gmsh::vectorpair          entities;
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
            blocks.push_back({dimension,
                              static_cast<unsigned int>(n_corners),
                              static_cast<unsigned int>(n_nodes),
                              group_of(dimension, entity.second),
                              std::move(nodes[i])});
          }
      }
    return blocks;
  }
} // namespace Cautery
