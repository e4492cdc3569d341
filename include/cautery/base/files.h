// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/archive.h>

#include <cstdint>
#include <string>

namespace Cautery
{
  /**
   * Gives a file new content in one go: whoever reads it finds all of the old or all of the new. With @p
   * settle, which takes its time, that holds where the machine loses its power, and this and all files
   * written before are safe then. Errors: ExcRun; the old content stays.
   */
  void replace_file(const std::string &name, const std::string &content, const bool settle = false);

  /**
   * A file to which text is added. What is added is there as a whole or not at all, but for a loss of power,
   * and as soon as add() returns. Errors of all functions: ExcRun with the file's name and the reason.
   */
  class GrowingFile
  {
  public:
    GrowingFile() = default;
    ~GrowingFile() { close(); }
    GrowingFile(const GrowingFile &)            = delete;
    GrowingFile &operator=(const GrowingFile &) = delete;

    /** The file will be empty before the first text is added. */
    void name_it(const std::string &file_name) { name = file_name; }

    void add(const std::string &text);

    /** Its length; and where the archive brings back, goes on after that, what follows being cut off. Process
     * 0 has the file. Errors: ExcInput where it is missing, or shorter. */
    void archive(const std::string &what, Archive &archive);

    std::uint64_t length() const { return size; } ///< bytes

  private:
    bool open(const int flags);
    void close();
    void go_on();

    std::string   name;
    int           descriptor = -1;
    std::uint64_t size       = 0;
  };

  /** A checksum of 64 bits (CRC) of @p bytes, in hexadecimal digits. */
  std::string checksum(const std::string &bytes);

  /** All of a file. Errors: ExcInput. */
  std::string content_of(const std::string &name);
} // namespace Cautery
