// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/archive.h>
#include <cautery/scene/scene.h>
#include <cautery/space/field.h>

namespace Cautery
{
  class Hdf5Image;

  /**
   * checkpoint.h5, the file from which a run goes on: an Archive of all processes, and which run it belongs
   * to.
   *
   * It is replaced in one go and bears a checksum, so that it is whole or refused. HDF5 begins at byte 512,
   * after a line of text. What belongs to nodes stands in an order that does not depend on the number of
   * processes.
   */
  template <int dim>
  class Checkpoint
  {
  public:
    /** Arguments must live as long as it. Errors: ExcInput where the mesh file cannot be read any more. */
    Checkpoint(const std::string &directory, const Scene &scene, const Field<dim> &nodes);

    const std::string &file_name() const { return file; }

    /** The mesh has been adapted: @p nodes are in the place of those so far. */
    void use(const Field<dim> &nodes);

    /** Collective. Errors: ExcRun; the last checkpoint is unharmed then. */
    void write(const Archive &archive);

    /** Of an adaptive mesh, the cells at that time: see Mesh. Collective. Errors: as for `read`. */
    std::vector<CellNumber> cells() const;

    /**
     * An archive that brings back. The nodes must be those of that time. Collective. Errors: ExcInput where
     * there is no checkpoint, or one that is damaged or of another version, scene or mesh.
     */
    Archive read();

    /** A run that is done needs it no more. */
    void remove() const;

  private:
    using Numbers = std::vector<double>;
    using Pieces  = std::vector<Numbers>; ///< one of each process

    void                       find_places();
    Numbers                    in_file_order(const Pieces &pieces) const;
    Pieces                     by_process(const Numbers &numbers) const;
    void                       describe(Hdf5Image &image) const;
    void                       check_belongs(const Hdf5Image &image) const;
    std::unique_ptr<Hdf5Image> open() const;
    std::string                checked_image() const;
    void add(Hdf5Image &image, const std::string &name, const Archive::Kind kind, const Pieces &pieces) const;
    Pieces pieces_of(const Hdf5Image *image, const std::string &name, const Archive::Kind kind) const;

    const std::string  file;
    const Scene       &scene;
    const MPI_Comm     communicator;
    const unsigned int n_processes;
    const bool         first; ///< the process that reads and writes
    const Field<dim>  *nodes;
    std::string        mesh; ///< checksum of its file, if it has one

    bool places_found = false;
    // on the first process, once they are needed
    std::vector<std::size_t> n_nodes; ///< of each process
    std::vector<std::size_t> places;  ///< in the file, of the nodes of one process after the other
  };
} // namespace Cautery
