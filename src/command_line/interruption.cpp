#include "command_line/interruption.hpp"

#include <pthread.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <system_error>
#include <thread>
#include <utility>

namespace command_line {
namespace {

/// What the thread that waits shares with the run. It outlives all that is destroyed at the end of the program.
struct Shared {
  std::mutex words;
  std::string left = "nothing was written";
  std::mutex naming;
};

Shared& shared() {
  static Shared* const all = new Shared;
  return *all;
}

/// Waits for the signal. No handler: here everything may be done that a program does.
void wait_for(const sigset_t& signals) {
  int signal = 0;
  if (sigwait(&signals, &signal) != 0) return;
  const std::lock_guard<std::mutex> no_file_half_named(shared().naming);
  const std::lock_guard<std::mutex> lock(shared().words);
  std::cerr << "\nsignorini: interrupted: " << shared().left << std::endl;
  _exit(interrupted);
}

}  // namespace

void answer_interruptions() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigset_t before;
  static_cast<void>(shared());
  if (pthread_sigmask(SIG_BLOCK, &signals, &before) != 0) return;
  try {
    std::thread([signals] { wait_for(signals); }).detach();
  } catch (const std::system_error&) {
    pthread_sigmask(SIG_SETMASK, &before, nullptr);  // no room for a thread: Ctrl-C ends without a word
  }
}

void keep_in_mind(std::string words) {
  const std::lock_guard<std::mutex> lock(shared().words);
  shared().left = std::move(words);
}

Uninterrupted::Uninterrupted() : lock_(shared().naming) {}

}  // namespace command_line
