// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/agreement.h>
#include <cautery/base/files.h>
#include <cautery/base/version.h>
#include <cautery/output/checkpoint.h>
#include <cautery/output/hdf5_image.h>
#include <cautery/space/node_numbers.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <sstream>
#include <utility>

namespace Cautery
{
  namespace
  {
    using Kind = Archive::Kind;

    std::string own_group(const unsigned int process) { return "own/" + std::to_string(process); }

    constexpr std::size_t header_size = 512; // HDF5 finds its own beginning there
    const std::string     greeting    = "cautery checkpoint";

    /// What stands before @p image: if that is cut short or changed, another one would.
    std::string header(const std::string &image)
    {
      std::string text = greeting + ": from byte " + std::to_string(header_size) + " on HDF5 of " +
                         std::to_string(image.size()) + " bytes with the CRC-64 " + checksum(image) + "\n";
      text.resize(header_size, '\0');
      return text;
    }

    /// The first lines in which two scenes differ.
    std::string difference(const std::string &before, const std::string &now)
    {
      std::istringstream one(before), other(now);
      std::string        line_before, line_now;
      bool               more = true;
      while (more && line_before == line_now)
        {
          const bool more_before = static_cast<bool>(std::getline(one, line_before));
          const bool more_now    = static_cast<bool>(std::getline(other, line_now));
          more                   = more_before && more_now;
        }
      return "it had `" + Utilities::trim(line_before) + "` where now is `" + Utilities::trim(line_now) + "`";
    }

    std::vector<double> joined(const std::vector<std::vector<double>> &pieces)
    {
      std::vector<double> all;
      for (const auto &piece : pieces)
        all.insert(all.end(), piece.begin(), piece.end());
      return all;
    }

    std::vector<double> scatter(const MPI_Comm communicator, const std::vector<std::vector<double>> &pieces)
    {
      std::map<unsigned int, std::vector<double>> parcels;
      for (unsigned int process = 0; process < pieces.size(); ++process)
        parcels[process] = pieces[process];
      return Utilities::MPI::some_to_some(communicator, parcels).at(0);
    }
  } // namespace

  template <int dim>
  Checkpoint<dim>::Checkpoint(const std::string &directory, const Scene &scene, const Field<dim> &nodes)
    : file(directory + "/checkpoint.h5")
    , scene(scene)
    , communicator(nodes.communicator())
    , n_processes(Utilities::MPI::n_mpi_processes(communicator))
    , first(Utilities::MPI::this_mpi_process(communicator) == 0)
    , nodes(&nodes)
  {
    if (scene.mesh.shape == MeshSettings::Shape::file)
      fail_together(communicator, [this]() {
        if (first)
          mesh = checksum(content_of(this->scene.mesh.file_name));
      });
  }

  template <int dim>
  void Checkpoint<dim>::use(const Field<dim> &next)
  {
    nodes        = &next;
    places_found = false;
    n_nodes.clear();
  }

  template <int dim>
  void Checkpoint<dim>::find_places()
  {
    if (std::exchange(places_found, true))
      return;
    const auto pieces = Utilities::MPI::gather(communicator, node_numbers(*nodes));
    if (!first)
      return;
    std::vector<CellNumber> all;
    for (const auto &piece : pieces)
      {
        n_nodes.push_back(piece.size());
        all.insert(all.end(), piece.begin(), piece.end());
      }
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&all](const std::size_t a, const std::size_t b) {
      return all[a] < all[b];
    });
    places.resize(order.size());
    for (std::size_t place = 0; place < order.size(); ++place)
      places[order[place]] = place;
  }

  template <int dim>
  typename Checkpoint<dim>::Numbers Checkpoint<dim>::in_file_order(const Pieces &pieces) const
  {
    const Numbers     all    = joined(pieces);
    const std::size_t n_each = all.size() / places.size();
    Numbers           result(all.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      std::copy_n(all.begin() + n_each * i, n_each, result.begin() + n_each * places[i]);
    return result;
  }

  template <int dim>
  typename Checkpoint<dim>::Pieces Checkpoint<dim>::by_process(const Numbers &numbers) const
  {
    const std::size_t n_each = numbers.size() / places.size();
    Pieces            pieces(n_processes);
    auto              place = places.begin();
    for (unsigned int process = 0; process < n_processes; ++process)
      for (std::size_t i = 0; i < n_nodes[process]; ++i, ++place)
        pieces[process].insert(
          pieces[process].end(), numbers.begin() + n_each * *place, numbers.begin() + n_each * (*place + 1));
    return pieces;
  }

  template <int dim>
  void Checkpoint<dim>::write(const Archive &archive)
  {
    find_places();
    Hdf5Image image;
    if (first)
      describe(image);
    for (const auto &[name, entry] : archive.entries())
      {
        const Pieces pieces = entry.kind == Kind::shared ?
                                Pieces{entry.numbers} :
                                Utilities::MPI::gather(communicator, entry.numbers);
        if (first)
          add(image, name, entry.kind, pieces);
      }
    fail_together(communicator, [&]() {
      if (!first)
        return;
      const std::string bytes = image.bytes();
      replace_file(file, header(bytes) + bytes, true);
    });
  }

  template <int dim>
  void Checkpoint<dim>::describe(Hdf5Image &image) const
  {
    image.add("about/program", std::string(version));
    image.add("about/scene", scene.identity);
    image.add("about/mesh", mesh);
    image.add("about/processes", Numbers{static_cast<double>(n_processes)});
    if (scene.mesh.adaptive.is_on())
      {
        const auto cells = nodes->mesh().cells_of_all();
        image.add("about/cells", Numbers(cells.begin(), cells.end()));
      }
  }

  template <int dim>
  void
  Checkpoint<dim>::add(Hdf5Image &image, const std::string &name, const Kind kind, const Pieces &pieces) const
  {
    if (kind == Kind::shared)
      image.add("shared/" + name, pieces.front());
    else if (kind == Kind::nodal)
      image.add("nodal/" + name, in_file_order(pieces));
    else if (kind == Kind::summed)
      image.add("summed/" + name, joined(pieces));
    else
      for (unsigned int process = 0; process < n_processes; ++process)
        image.add(own_group(process) + "/" + name, pieces[process]);
  }

  template <int dim>
  void Checkpoint<dim>::check_belongs(const Hdf5Image &image) const
  {
    const std::string else_run = ", or run without --resume";
    const std::string program  = image.text("about/program");
    AssertThrow(program == version,
                ExcInput(file + " was written by cautery " + program + ", and this is cautery " + version +
                         "; resume with the program that wrote it" + else_run));
    const std::string of_scene = image.text("about/scene");
    AssertThrow(of_scene == scene.identity,
                ExcInput(file + " belongs to another scene: " + difference(of_scene, scene.identity) +
                         "; resume with that scene" + else_run));
    AssertThrow(image.text("about/mesh") == mesh,
                ExcInput("the mesh file " + scene.mesh.file_name + " is not what it was when " + file +
                         " was written; put that one back" + else_run));
  }

  /// The image in the file, checked as far as that can be without looking into it.
  template <int dim>
  std::string Checkpoint<dim>::checked_image() const
  {
    AssertThrow(std::filesystem::exists(file),
                ExcInput("there is no " + file +
                         " to resume from (a run that is done removes it); run without --resume"));
    std::string content = content_of(file);
    AssertThrow(content.compare(0, greeting.size(), greeting) == 0,
                ExcInput(file + " is no checkpoint; run without --resume"));
    std::string image = content.substr(std::min(header_size, content.size()));
    AssertThrow(content.substr(0, header_size) == header(image),
                ExcInput(file + " is damaged or cut short (" + std::to_string(content.size()) +
                         " bytes); put back a copy of it that is whole, or run without --resume"));
    return image;
  }

  /// On the first process.
  template <int dim>
  std::unique_ptr<Hdf5Image> Checkpoint<dim>::open() const
  {
    std::unique_ptr<Hdf5Image> image;
    fail_together(communicator, [&]() {
      if (!first)
        return;
      image = std::make_unique<Hdf5Image>(checked_image());
      check_belongs(*image);
    });
    return image;
  }

  template <int dim>
  std::vector<CellNumber> Checkpoint<dim>::cells() const
  {
    const auto image = open();
    Numbers    cells;
    fail_together(communicator, [&]() {
      if (first)
        cells = image->numbers("about/cells");
    });
    return std::vector<CellNumber>(cells.begin(), cells.end());
  }

  template <int dim>
  Archive Checkpoint<dim>::read()
  {
    find_places();
    const auto image = open();
    using Names      = std::vector<std::string>;
    std::map<Kind, Names> names;
    unsigned int          n_then = 0;
    if (first)
      {
        n_then = image->numbers("about/processes").at(0);
        names  = {{Kind::shared, image->names("shared")},
                  {Kind::nodal, image->names("nodal")},
                  {Kind::summed, image->names("summed")},
                  {Kind::own, n_then == n_processes ? image->names(own_group(0)) : Names()}};
      }
    for (const Kind kind : {Kind::shared, Kind::nodal, Kind::summed, Kind::own})
      names[kind] = Utilities::MPI::broadcast(communicator, names[kind]);

    Archive::Entries entries;
    for (const auto &[kind, of_kind] : names)
      for (const auto &name : of_kind)
        entries[name] = {kind, scatter(communicator, pieces_of(image.get(), name, kind))};
    return Archive(std::move(entries));
  }

  /// Of an entry, what each process gets; nothing but on the first.
  template <int dim>
  typename Checkpoint<dim>::Pieces
  Checkpoint<dim>::pieces_of(const Hdf5Image *image, const std::string &name, const Kind kind) const
  {
    if (!first)
      return {};
    if (kind == Kind::shared)
      return Pieces(n_processes, image->numbers("shared/" + name));
    if (kind == Kind::nodal)
      return by_process(image->numbers("nodal/" + name));
    Pieces pieces(n_processes);
    if (kind == Kind::summed)
      {
        const Numbers shares = image->numbers("summed/" + name);
        for (unsigned int process = 0; process < n_processes; ++process)
          pieces[process] = {shares.size() == n_processes ? shares[process] :
                             process == 0 ? std::accumulate(shares.begin(), shares.end(), 0.) :
                                            0.};
      }
    else
      for (unsigned int process = 0; process < n_processes; ++process)
        pieces[process] = image->numbers(own_group(process) + "/" + name);
    return pieces;
  }

  template <int dim>
  void Checkpoint<dim>::remove() const
  {
    std::error_code error;
    if (first)
      std::filesystem::remove(file, error);
  }

  template class Checkpoint<2>;
  template class Checkpoint<3>;
} // namespace Cautery
