// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs the program again and again without loading its libraries each time: 0.3 s become 0.1 s. Each line of
// standard input is a case, {"folder": working directory, "seconds": of computing at most, "words": the
// program's arguments}; each is answered by a line, "exit STATUS" or "signal NUMBER". What it says goes to
// FOLDER.stdout and FOLDER.stderr.
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

/// main() of the program, which is compiled under this name here.
int cautery_main(int argc, char **argv);

namespace
{
  using Json = nlohmann::json;

  void redirect(const int stream, const std::string &file_name)
  {
    const int file = open(file_name.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file < 0 || dup2(file, stream) < 0)
      _exit(126);
    close(file);
  }

  void limit(const int resource, const rlim_t largest)
  {
    const rlimit both = {largest, largest};
    setrlimit(static_cast<__rlimit_resource>(resource), &both);
  }

  [[noreturn]] void run(const Json &job)
  {
    const std::string folder  = job.at("folder");
    const unsigned    seconds = job.at("seconds");
    limit(RLIMIT_CPU, seconds);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 100000000);
    alarm(20 * seconds); // one that waits for ever computes nothing
    redirect(STDIN_FILENO, "/dev/null");
    redirect(STDOUT_FILENO, folder + ".stdout");
    redirect(STDERR_FILENO, folder + ".stderr");
    if (chdir(folder.c_str()) != 0)
      _exit(126);
    std::vector<std::string> words = job.at("words");
    words.insert(words.begin(), "cautery");
    std::vector<char *> arguments;
    for (auto &word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::exit(cautery_main(words.size(), arguments.data()));
  }
} // namespace

int main()
{
  for (std::string line; std::getline(std::cin, line);)
    {
      const Json  job   = Json::parse(line);
      const pid_t child = fork();
      if (child == 0)
        run(job);
      int status = 0;
      if (child < 0 || waitpid(child, &status, 0) < 0)
        return 1;
      if (WIFEXITED(status))
        std::cout << "exit " << WEXITSTATUS(status) << std::endl;
      else
        std::cout << "signal " << WTERMSIG(status) << std::endl;
    }
  return 0;
}
