#include "command_line/run_monitor.hpp"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <iostream>
#include <system_error>
#include <utility>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Clock = std::chrono::steady_clock;

constexpr double quiet_time = 2;  // before the line is written [s]
constexpr int woken = SIGUSR1;  // ends the monitor

/// What the run says of itself; of one process there is one.
struct RunStatus {
  std::mutex guard;  // of what follows
  std::string doing;
  std::string kept = "nothing was written";
  bool shown = false;     // whether the line stands on the terminal
  double due = quiet_time;  // when it is written anew, after the begin [s]
  std::vector<std::function<void()>> last;
  std::timed_mutex files;  // are being written
  std::atomic<bool> ended{false};
  const Clock::time_point begin = Clock::now();

  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }
};

RunStatus& run_status() {
  static RunStatus all;
  return all;
}

/// Adds a signal unless the program was told to ignore it.
void add(sigset_t& signals, int signal) {
  struct sigaction action = {};
  if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
    sigaddset(&signals, signal);
}

/// Writes the line anew if that is due and something is being done.
void show() {
  RunStatus& run = run_status();
  const double now = run.seconds();
  if (run.doing.empty() || now < run.due || *erase_line() == 0) return;
  std::cerr << erase_line() + run.doing + number(now, ": %.0f s so far") << std::flush;
  run.due = std::floor(now) + 1;
  run.shown = true;
}

int waited(const sigset_t& signals, long milliseconds) {
  const timespec time{milliseconds / 1000, milliseconds % 1000 * 1000000};
  return sigtimedwait(&signals, nullptr, &time);
}

/// Ends the program as the signal would have, with a word.
void interrupt(const sigset_t& signals, int signal) {
  RunStatus& run = run_status();
  while (!run.files.try_lock_for(std::chrono::milliseconds(100)))
    if (waited(signals, 0) > 0) break;
  const std::lock_guard<std::mutex> lock(run.guard);  // to the end: nothing is said after the word
  std::cerr << text(erase_line(), "signorini: interrupted after ", number(run.seconds(), "%.1f s"),
                    run.doing.empty() ? "" : " (" + run.doing + ')', "; ", run.kept, '\n')
            << std::flush;
  for (const auto& last : run.last) last();
  std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  raise(signal);
}

}  // namespace

RunMonitor::RunMonitor() {
  sigemptyset(&signals_);
  sigaddset(&signals_, woken);
  add(signals_, SIGINT);
  add(signals_, SIGTERM);
  static_cast<void>(run_status());
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  try {
    thread_ = std::thread([this] { watch(); });
  } catch (const std::system_error&) {
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
}

RunMonitor::~RunMonitor() {
  if (!thread_.joinable()) return;
  run_status().ended = true;
  pthread_kill(thread_.native_handle(), woken);
  thread_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void RunMonitor::watch() {
  while (!run_status().ended) {
    const int signal = waited(signals_, 100);
    if (signal < 0) {
      const std::lock_guard<std::mutex> lock(run_status().guard);
      show();
    }
    if (signal == SIGINT || signal == SIGTERM) interrupt(signals_, signal);
  }
}

void Progress::say(const std::string& what) const {
  RunStatus& run = run_status();
  const std::lock_guard<std::mutex> lock(run.guard);
  run.doing = what;
  if (std::exchange(run.shown, false)) std::cerr << erase_line() << std::flush;
  show();
}

Uninterrupted::Uninterrupted() { run_status().files.lock(); }
Uninterrupted::~Uninterrupted() { run_status().files.unlock(); }

void set_kept(const std::string& what) {
  const std::lock_guard<std::mutex> lock(run_status().guard);
  run_status().kept = what;
}

void do_last(std::function<void()> last) {
  const std::lock_guard<std::mutex> lock(run_status().guard);
  run_status().last.push_back(std::move(last));
}

const char* erase_line() { return isatty(STDERR_FILENO) == 1 ? "\r\033[K" : ""; }

}  // namespace command_line
