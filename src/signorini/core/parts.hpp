// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Work in parts that do not wait for each other, on as many threads as a program allows.
///
/// Sums of doubles depend on their order: 1e16 + 1 - 1e16 is 0, and 1e16 - 1e16 + 1 is 1. So the work says what its parts are
/// and in which order their results are added up, and the number of threads says only who does which part. Three cells on one
/// thread and on two have the same sum, bit for bit: the parts are the cells, and their results are added as (a + b) + c
/// whichever is ready first.
///
/// A program has one thread unless it asks for more.
#pragma once
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {

/// The number that a program has set, behind threads() and set_threads().
inline std::atomic<int> number_of_threads{1};
/// Whether this thread works on a part: parts in a part are done one after another.
inline thread_local bool in_a_part = false;

/// \return on how many threads the parts of a loop are done
inline int threads() { return number_of_threads; }
/// Sets the number for all that follows.
/// \param count  1 or more
/// \throws std::invalid_argument if it is less
inline void set_threads(int count) {
  require_argument(count >= 1, "set_threads: need at least 1, got ", count);
  number_of_threads = count;
}

/// \return on how many threads a loop that begins here can be done
inline int free_threads() { return in_a_part ? 1 : threads(); }

/// Calls work() on several threads at a time, of which this one is the first. Where the system has no more threads it is
/// called by those that there are.
/// \param count  how many times at most, threads() or fewer
/// \param work   takes what is there to do until nothing is left; must not throw
template <typename Work>
void on_threads(int count, Work&& work) {
  std::vector<std::thread> others;
  const auto marked = [&work] {
    const bool before = std::exchange(in_a_part, true);
    work();
    in_a_part = before;
  };
  try {
    while (static_cast<int>(others.size()) + 1 < count) others.emplace_back(marked);
  } catch (const std::system_error&) {  // no more of them
  }
  marked();
  for (std::thread& other : others) other.join();
}

/// Does the parts 0 to count - 1 of a work, each once, on threads(). Those that are handed out first have smaller numbers.
/// \param count  number of parts
/// \param work   gets the number of a part; parts must not write to the same place
/// \throws what a part throws; of several the one with the least number, as on one thread
template <typename Work>
void for_parts(Eigen::Index count, Work&& work) {
  const int workers = static_cast<int>(std::min<Eigen::Index>(free_threads(), count));
  if (workers <= 1) {
    for (Eigen::Index part = 0; part < count; ++part) work(part);
    return;
  }
  std::atomic<Eigen::Index> next{0};
  std::mutex failing;
  Eigen::Index failed = count;
  std::exception_ptr error;
  on_threads(workers, [&] {
    for (Eigen::Index part = next++; part < count; part = next++) {
      try {
        work(part);
      } catch (...) {
        next = count;  // what comes later need not be done
        const std::lock_guard<std::mutex> lock(failing);
        if (part < failed) error = std::current_exception();
        failed = std::min(failed, part);
      }
    }
  });
  if (error) std::rethrow_exception(error);
}

/// Does a loop in parts of neighbouring numbers.
/// \param count  numbers of the loop: 0 to count - 1
/// \param size   of a part, at least 1; the last may be smaller
/// \param work   gets the first number of a part and the one behind its last
/// \throws as for_parts()
template <typename Work>
void for_ranges(Eigen::Index count, Eigen::Index size, Work&& work) {
  for_parts((count + size - 1) / size,
            [&](Eigen::Index part) { work(part * size, std::min(count, (part + 1) * size)); });
}

}  // namespace signorini
