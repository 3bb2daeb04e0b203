#include "bench/peers/child.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "signorini/core/errors.hpp"

namespace signorini::bench {
namespace {

/// Programs of a name in the folders of the search path.
std::vector<std::string> found(const std::string& program) {
  std::vector<std::string> all;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = folder + '/' + program;
    if (access(file.c_str(), X_OK) == 0) all.push_back(file);
  }
  return all;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The last line of a file that says something.
std::string last_line(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t_") != std::string::npos) last = line;
  return last;
}

/// What remains of the child until its program starts. \return if it cannot be started
void become(const std::vector<std::string>& command, const std::filesystem::path& folder,
            const std::string& log, double longest) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const auto limit = static_cast<rlim_t>(std::ceil(longest));
  const rlimit seconds{limit, limit + 1};
  const int out = chdir(folder.c_str()) == 0
                      ? open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)
                      : -1;
  if (out < 0 || setrlimit(RLIMIT_CPU, &seconds) != 0) return;
  for (const char* threads : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"})
    setenv(threads, "1", 1);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  execvp(words[0], words.data());
}

}  // namespace

ChildRun run_child(const std::vector<std::string>& command, const std::filesystem::path& folder,
                   const std::string& log, double longest) {
  const pid_t process = fork();
  if (process == 0) {
    become(command, folder, log, longest);
    _exit(127);
  }
  int status = 0;
  rusage used{};
  if (process < 0 || wait4(process, &status, 0, &used) != process)
    throw ProblemError(text("peers: ", command[0], " cannot be started"));
  ChildRun run;
  run.seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  run.megabytes = static_cast<double>(used.ru_maxrss) / 1e3;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    run.failure = text("not ended after ", longest, " s");
  else if (WIFSIGNALED(status))
    run.failure = text("ended by signal ", WTERMSIG(status));
  else if (WEXITSTATUS(status) != 0)
    run.failure = text("ended with ", WEXITSTATUS(status), ": ", last_line(folder / log));
  return run;
}

bool is_program(const std::string& program) { return !found(program).empty(); }

std::vector<std::string> pythons_with(const std::string& package) {
  std::vector<std::string> able;
  for (const std::string& python : found("python3")) {
    const std::string question = "'" + python + "' -c 'import " + package + "' > /dev/null 2>&1";
    if (std::system(question.c_str()) == 0) able.push_back(python);
  }
  return able;
}

}  // namespace signorini::bench
