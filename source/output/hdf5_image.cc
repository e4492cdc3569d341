// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/parameters.h>
#include <cautery/output/hdf5_image.h>

#include <hdf5.h>

namespace Cautery
{
  namespace
  {
    static_assert(sizeof(hid_t) == sizeof(std::int64_t), "HDF5's identifiers have 64 bits");

    /// Memory is taken in pieces of this many bytes.
    constexpr std::size_t increment = 1 << 20;

    void check(const std::int64_t status)
    {
      AssertThrow(status >= 0, ExcInput("HDF5 cannot read or write what it should"));
    }

    /// Closes what HDF5 has opened.
    class Handle
    {
    public:
      Handle(const hid_t id, herr_t (*const close)(hid_t)) : id(id), close(close) { check(id); }
      ~Handle() { close(id); }
      Handle(const Handle &)            = delete;
      Handle &operator=(const Handle &) = delete;
              operator hid_t() const { return id; }

    private:
      const hid_t id;
      herr_t (*const close)(hid_t);
    };

    hid_t access_in_memory()
    {
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it would print errors besides returning them
      const hid_t  access = H5Pcreate(H5P_FILE_ACCESS);
      const herr_t status = H5Pset_fapl_core(access, increment, false);
      return status < 0 ? status : access;
    }

    void
    write(const hid_t file, const std::string &path, const hid_t type, const hsize_t size, const void *data)
    {
      const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
      check(H5Pset_create_intermediate_group(links, 1));
      const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
      const Handle set(H5Dcreate2(file, path.c_str(), type, space, links, H5P_DEFAULT, H5P_DEFAULT),
                       H5Dclose);
      if (size > 0)
        check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
    }

    /// @p make_room(size) returns where the data go.
    template <typename MakeRoom>
    void read(const hid_t file, const std::string &path, const hid_t type, const MakeRoom &make_room)
    {
      const Handle   set(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
      const Handle   space(H5Dget_space(set), H5Sclose);
      const hssize_t size = H5Sget_simple_extent_npoints(space);
      check(size);
      void *const data = make_room(size);
      if (size > 0)
        check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
    }
  } // namespace

  Hdf5Image::Hdf5Image()
  {
    const Handle access(access_in_memory(), H5Pclose);
    file = H5Fcreate("image", H5F_ACC_TRUNC, H5P_DEFAULT, access);
    check(file);
  }

  Hdf5Image::Hdf5Image(const std::string &bytes)
  {
    const Handle access(access_in_memory(), H5Pclose);
    check(H5Pset_file_image(access, const_cast<char *>(bytes.data()), bytes.size())); // which copies it
    file = H5Fopen("image", H5F_ACC_RDONLY, access);
    check(file);
  }

  Hdf5Image::~Hdf5Image() { H5Fclose(file); }

  void Hdf5Image::add(const std::string &path, const std::vector<double> &numbers)
  {
    write(file, path, H5T_NATIVE_DOUBLE, numbers.size(), numbers.data());
  }

  void Hdf5Image::add(const std::string &path, const std::string &text)
  {
    write(file, path, H5T_NATIVE_CHAR, text.size(), text.data());
  }

  std::vector<std::string> Hdf5Image::names(const std::string &group) const
  {
    std::vector<std::string> result;
    if (!(H5Lexists(file, group.c_str(), H5P_DEFAULT) > 0))
      return result;
    const Handle inside(H5Gopen2(file, group.c_str(), H5P_DEFAULT), H5Gclose);
    H5G_info_t   info;
    check(H5Gget_info(inside, &info));
    for (hsize_t i = 0; i < info.nlinks; ++i)
      {
        const auto name_of = [&](char *name, const std::size_t size) {
          const ssize_t length =
            H5Lget_name_by_idx(inside, ".", H5_INDEX_NAME, H5_ITER_INC, i, name, size, H5P_DEFAULT);
          check(length);
          return static_cast<std::size_t>(length);
        };
        std::string name(name_of(nullptr, 0), '\0');
        name_of(name.data(), name.size() + 1);
        result.push_back(name);
      }
    return result;
  }

  std::vector<double> Hdf5Image::numbers(const std::string &path) const
  {
    std::vector<double> result;
    read(file, path, H5T_NATIVE_DOUBLE, [&result](const std::size_t size) {
      result.resize(size);
      return result.data();
    });
    return result;
  }

  std::string Hdf5Image::text(const std::string &path) const
  {
    std::string result;
    read(file, path, H5T_NATIVE_CHAR, [&result](const std::size_t size) {
      result.resize(size);
      return &result[0];
    });
    return result;
  }

  std::string Hdf5Image::bytes() const
  {
    check(H5Fflush(file, H5F_SCOPE_LOCAL));
    const ssize_t size = H5Fget_file_image(file, nullptr, 0);
    check(size);
    std::string result(size, '\0');
    check(H5Fget_file_image(file, result.data(), size));
    return result;
  }
} // namespace Cautery
