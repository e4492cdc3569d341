// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/child_process.h>
#include <cautery/base/exceptions.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace Cautery
{
  namespace
  {
    bool write_all(const int end, const std::string &text)
    {
      std::size_t written = 0;
      while (written < text.size())
        {
          const ssize_t n = write(end, text.data() + written, text.size() - written);
          if (n < 0 && errno != EINTR)
            return false;
          written += n > 0 ? n : 0;
        }
      return true;
    }

    std::string read_all(const int end)
    {
      std::string            text;
      std::array<char, 4096> part;
      for (ssize_t n = 1; n > 0 || (n < 0 && errno == EINTR);)
        if ((n = read(end, part.data(), part.size())) > 0)
          text.append(part.data(), n);
      return text;
    }

    [[noreturn]] void be_child(const std::function<std::string()> &work, const int answer)
    {
      for (const int fault : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL})
        std::signal(fault, SIG_DFL); // the program tells of it
      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, STDOUT_FILENO);
      dup2(nowhere, STDERR_FILENO);
      bool done = false;
      try
        {
          done = write_all(answer, work());
        }
      catch (...)
        {
          // as if it had ended there
        }
      _exit(done ? EXIT_SUCCESS : EXIT_FAILURE);
    }

    bool ended_well(const pid_t child)
    {
      int   status = EXIT_FAILURE;
      pid_t ended  = child;
      do
        ended = waitpid(child, &status, 0);
      while (ended < 0 && errno == EINTR);
      return ended == child && WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
    }
  } // namespace

  std::optional<std::string> found_by_child(const std::function<std::string()> &work)
  {
    std::array<int, 2> ends;
    AssertThrow(pipe(ends.data()) == 0,
                ExcRun(std::string("there is no pipe for a child process: ") + std::strerror(errno)));
    // before there is a child, so that none meets it unprepared
    sigset_t stops, before;
    sigemptyset(&stops);
    for (const int signal : {SIGTERM, SIGINT, SIGUSR1})
      sigaddset(&stops, signal);
    pthread_sigmask(SIG_BLOCK, &stops, &before);
    const pid_t child = fork();
    if (child == 0)
      be_child(work, ends[1]);
    const int error = errno;
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    close(ends[1]);
    const std::string text = child > 0 ? read_all(ends[0]) : "";
    close(ends[0]);
    AssertThrow(child > 0, ExcRun(std::string("there can be no child process: ") + std::strerror(error)));
    return ended_well(child) ? std::optional<std::string>(text) : std::nullopt;
  }
} // namespace Cautery
