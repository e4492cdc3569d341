// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace Cautery
{
  /**
   * An HDF5 file in memory. So what touches the disk is in our hands, and HDF5 meets neither a full one nor
   * half a file. Paths are "group/subgroup/name". Errors: ExcInput where the bytes are no such file.
   */
  class Hdf5Image
  {
  public:
    Hdf5Image();
    explicit Hdf5Image(const std::string &bytes);
    ~Hdf5Image();
    Hdf5Image(const Hdf5Image &)            = delete;
    Hdf5Image &operator=(const Hdf5Image &) = delete;

    void add(const std::string &path, const std::vector<double> &numbers);
    void add(const std::string &path, const std::string &text);

    std::vector<std::string> names(const std::string &group) const; ///< in it; none where there is no group
    std::vector<double>      numbers(const std::string &path) const;
    std::string              text(const std::string &path) const;

    std::string bytes() const; ///< of the whole file

  private:
    std::int64_t file; ///< HDF5's identifier
  };
} // namespace Cautery
