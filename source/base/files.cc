// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/files.h>
#include <cautery/base/parameters.h>

#include <boost/crc.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace Cautery
{
  namespace
  {
    [[noreturn]] void fail_to_write(const std::string &name)
    {
      const std::string reason = std::strerror(errno);
      throw ExcRun("cannot write " + name + ": " + reason);
    }

    /// False with errno set where not all could be written.
    bool write_all(const int descriptor, const std::string &bytes)
    {
      for (std::size_t done = 0; done < bytes.size();)
        {
          const ssize_t n = ::write(descriptor, bytes.data() + done, bytes.size() - done);
          if (n < 0 && errno != EINTR)
            return false;
          done += n > 0 ? n : 0;
        }
      return true;
    }

    /// The renaming itself.
    void settle_folder_of(const std::string &name)
    {
      const auto folder     = std::filesystem::absolute(name).parent_path().string();
      const int  descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (descriptor < 0)
        return;
      ::fsync(descriptor);
      ::close(descriptor);
    }
  } // namespace

  void replace_file(const std::string &name, const std::string &content, const bool settle)
  {
    const std::string part       = name + ".part";
    const int         descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0)
      fail_to_write(name);
    const bool written = write_all(descriptor, content) && (!settle || ::syncfs(descriptor) == 0);
    int        reason  = errno;
    const bool closed  = ::close(descriptor) == 0;
    if (written && closed && std::rename(part.c_str(), name.c_str()) == 0)
      {
        if (settle)
          settle_folder_of(name);
        return;
      }
    if (written)
      reason = errno;
    ::unlink(part.c_str());
    errno = reason;
    fail_to_write(name);
  }

  bool GrowingFile::open(const int flags)
  {
    close();
    descriptor = ::open(name.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | flags, 0666);
    return descriptor >= 0;
  }

  void GrowingFile::close()
  {
    if (descriptor >= 0)
      ::close(descriptor);
    descriptor = -1;
  }

  void GrowingFile::add(const std::string &text)
  {
    if (descriptor < 0 && !open(O_CREAT | O_TRUNC))
      fail_to_write(name);
    if (!write_all(descriptor, text))
      {
        const int reason = errno;
        const int cut    = ::ftruncate(descriptor, size); // no half a row
        (void)cut;
        errno = reason;
        fail_to_write(name);
      }
    size += text.size();
  }

  void GrowingFile::archive(const std::string &what, Archive &archive)
  {
    archive.shared("length of " + what, size);
    if (archive.restores() && !name.empty() && size > 0)
      go_on();
  }

  void GrowingFile::go_on()
  {
    struct stat status;
    AssertThrow(open(0) && ::fstat(descriptor, &status) == 0,
                ExcInput("cannot go on with " + name + ": " + std::strerror(errno)));
    AssertThrow(static_cast<std::uint64_t>(status.st_size) >= size,
                ExcInput(name + " has lost its end: it had " + std::to_string(size) +
                         " bytes when the checkpoint was written, and has " + std::to_string(status.st_size) +
                         "; put back the file that belongs to it"));
    AssertThrow(::ftruncate(descriptor, size) == 0,
                ExcInput("cannot go on with " + name + ": " + std::strerror(errno)));
  }

  std::string checksum(const std::string &bytes)
  {
    // the polynomial of ECMA-182
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~std::uint64_t(0), ~std::uint64_t(0), true, true> sum;
    sum.process_bytes(bytes.data(), bytes.size());
    std::ostringstream text;
    text << std::hex << std::setw(16) << std::setfill('0') << sum.checksum();
    return text.str();
  }

  std::string content_of(const std::string &name)
  {
    std::ifstream file(name, std::ios::binary);
    AssertThrow(file && !std::filesystem::is_directory(name), ExcInput("`" + name + "` cannot be read"));
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
  }
} // namespace Cautery
