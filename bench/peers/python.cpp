#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <utility>

#include "bench/peers/child.hpp"
#include "bench/peers/peer.hpp"
#include "signorini/core/errors.hpp"

namespace signorini::bench {
namespace {

/// A script that solves what it reads and writes answers, until there is nothing more to read.
class Script {
 public:
  Script(const std::string& python, const std::filesystem::path& file, const std::string& package) {
    int in[2];
    int out[2];
    if (pipe(in) != 0 || pipe(out) != 0) throw ProblemError("peers: no pipe to Python");
    for (const int end : {in[0], in[1], out[0], out[1]}) fcntl(end, F_SETFD, FD_CLOEXEC);
    process_ = fork();
    if (process_ == 0) {
      dup2(in[0], STDIN_FILENO);
      dup2(out[1], STDOUT_FILENO);
      execl(python.c_str(), python.c_str(), file.c_str(), package.c_str(), nullptr);
      _exit(127);
    }
    close(in[0]);
    close(out[1]);
    to_ = fdopen(in[1], "wb");
    from_ = fdopen(out[0], "rb");
  }
  ~Script() {
    std::fclose(to_);
    std::fclose(from_);
    waitpid(process_, nullptr, 0);
  }
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;
  Script(Script&&) = delete;
  Script& operator=(Script&&) = delete;

  Run solve(const DenseProgramme& programme, int calls) {
    const std::int64_t sizes[] = {programme.load.size(), programme.initial_gap.size(), calls};
    std::fwrite(sizes, sizeof *sizes, 3, to_);
    write(programme.stiffness.data(), programme.stiffness.size());
    write(programme.load.data(), programme.load.size());
    write(programme.A.data(), programme.A.size());
    write(programme.initial_gap.data(), programme.initial_gap.size());
    std::fflush(to_);

    Run run;
    double header[3] = {0, 0, 0};  // seconds, iterations, letters of what went wrong
    run.solution.displacement.resize(programme.load.size());
    run.solution.force.resize(programme.initial_gap.size());
    const bool complete = read(header, 3) && read(run.solution.displacement.data(), sizes[0]) &&
                          read(run.solution.force.data(), sizes[1]);
    if (complete) {
      run.failure.resize(static_cast<std::size_t>(header[2]));
      run.failure.resize(std::fread(run.failure.data(), 1, run.failure.size(), from_));
    } else {
      run.failure = "the script ended";
    }
    run.seconds = header[0];
    run.iterations = static_cast<Eigen::Index>(header[1]);
    return run;
  }

 private:
  void write(const double* data, Eigen::Index count) {
    std::fwrite(data, sizeof *data, static_cast<std::size_t>(count), to_);
  }
  bool read(double* data, Eigen::Index count) {
    const auto wanted = static_cast<std::size_t>(count);
    return std::fread(data, sizeof *data, wanted, from_) == wanted;
  }

  pid_t process_ = -1;
  std::FILE* to_ = nullptr;
  std::FILE* from_ = nullptr;
};

}  // namespace

std::vector<Peer> python_packages(const std::filesystem::path& script) {
  std::signal(SIGPIPE, SIG_IGN);  // a script that has ended is found out when it does not answer
  const std::pair<const char*, const char*> packages[] = {
      {"cvxopt", "Debian package python3-cvxopt"},
      {"highspy", "pip install highspy"},
      {"osqp", "pip install osqp"}};
  std::vector<Peer> peers;
  for (const auto& [package, source] : packages) {
    Peer peer{package, text("not installed (", source, ")"), {}};
    const std::vector<std::string> pythons = pythons_with(package);
    if (!pythons.empty()) {
      const auto running = std::make_shared<Script>(pythons[0], script, package);
      peer.missing.clear();
      peer.solve = [running](const DenseProgramme& programme, int calls) {
        return running->solve(programme, calls);
      };
    }
    peers.push_back(std::move(peer));
  }
  return peers;
}

}  // namespace signorini::bench
