// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * One kind of elements of one geometric entity of a mesh file.
   */
  struct ElementBlock
  {
    unsigned int             dimension;
    unsigned int             n_corners; ///< the corner nodes come first
    unsigned int             n_nodes;
    unsigned int             group; ///< tag of the physical group, 0 for none
    std::vector<std::size_t> nodes; ///< tags, element by element

    std::size_t n_elements() const { return nodes.size() / n_nodes; }
    std::string kind() const; ///< "tetrahedra"
  };

  /** "120 triangles, 14 prisms" */
  std::string count_text(const std::vector<ElementBlock> &blocks);

  /**
   * A mesh file opened through gmsh's interface, whose one global state is given back at the end: only one at
   * a time. Formats: .msh (versions 1, 2 and 4, ASCII and binary), .unv, and without groups .vtk, .bdf and
   * .mesh. (Debian's gmsh 4.8 cannot read .inp and .su2 and is built without .med.)
   */
  class GmshFile
  {
  public:
    /** Errors: ExcInput for a file that is missing, of no known format, unreadable or cut off. */
    explicit GmshFile(const std::string &file_name);
    ~GmshFile();
    GmshFile(const GmshFile &)            = delete;
    GmshFile &operator=(const GmshFile &) = delete;

    struct Nodes
    {
      std::vector<std::size_t> tags;
      std::vector<double>      places; ///< x, y, z of each, in the file's unit
    };

    Nodes       nodes() const;
    std::string group_name(const unsigned int dimension, const unsigned int group) const; ///< "" for none

    /** Errors: ExcInput for an entity in several physical groups. */
    std::vector<ElementBlock> elements(const unsigned int dimension) const;

    /** What messages begin with. */
    const std::string &label() const { return name; }

  private:
    /** Errors: ExcInput if @p fault says anything. */
    void         check_merged(const std::string &fault) const;
    unsigned int group_of(const unsigned int dimension, const int entity) const;

    const std::string name;
  };
} // namespace Cautery
