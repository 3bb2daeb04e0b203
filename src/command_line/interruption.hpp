// Ctrl-C: an end with a word on what was kept.
#pragma once
#include <mutex>
#include <string>

namespace command_line {

/// The exit code of a run that was interrupted, as shells have it: 128 and the number of the signal.
inline constexpr int interrupted = 130;

/// Lets an interrupted run say what it leaves, and end with `interrupted`. The first thing that main() does: a thread waits for the
/// signal, which this thread and all that it starts leave to it. What is ignored already, as of a run in the background, stays so.
void answer_interruptions();

/// \param words  what is left if the run is interrupted from now on, as "nothing was written"
void keep_in_mind(std::string words);

/// Puts an interruption off while it lives: files get their names then.
class Uninterrupted {
 public:
  Uninterrupted();

 private:
  std::unique_lock<std::mutex> lock_;
};

}  // namespace command_line
