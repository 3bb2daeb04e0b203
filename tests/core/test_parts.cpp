#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/core/parts.hpp"
#include "support/message.hpp"
#include "support/threads.hpp"

using namespace signorini;
using Eigen::Index;
using signorini_test::Threads;

TEST_CASE("every part is done once, on any number of threads", "[parts]") {
  for (const int count : {1, 2, 3, 8}) {
    const Threads now(count);
    CAPTURE(count);
    for (const Index parts : {0, 1, 2, 1000}) {
      std::vector<std::atomic<int>> done(at(parts));
      for_parts(parts, [&](Index part) { ++done[at(part)]; });
      for (const std::atomic<int>& times : done) CHECK(times == 1);
    }
    std::vector<std::atomic<int>> done(10);
    for_ranges(10, 4, [&](Index begin, Index end) {
      CHECK(end - begin <= 4);
      for (Index k = begin; k < end; ++k) ++done[at(k)];
    });
    for (const std::atomic<int>& times : done) CHECK(times == 1);
  }
}

TEST_CASE("parts are done on as many threads as are set, which is one if nobody sets them",
          "[parts]") {
  const auto threads_of = [] {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    std::atomic<int> waiting{threads()};
    for_parts(threads(), [&](Index) {
      --waiting;
      while (waiting > 0) std::this_thread::yield();  // nobody takes two parts
      const std::lock_guard<std::mutex> lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
    return seen;
  };
  CHECK(threads() == 1);
  CHECK(threads_of() == std::set<std::thread::id>{std::this_thread::get_id()});
  const Threads now(3);
  CHECK(threads_of().size() == 3);
}

TEST_CASE("parts of a part are done one after another on its thread", "[parts]") {
  const Threads now(2);
  CHECK(free_threads() == 2);
  for_parts(4, [](Index) {
    CHECK(free_threads() == 1);
    const std::thread::id outer = std::this_thread::get_id();
    int next = 0;
    for_parts(5, [&](Index part) {
      CHECK(std::this_thread::get_id() == outer);
      CHECK(part == next++);
    });
  });
  CHECK(free_threads() == 2);
}

TEST_CASE("what a part throws reaches the caller, of several parts that of the first", "[parts]") {
  for (const int count : {1, 2, 3, 8}) {
    const Threads now(count);
    CAPTURE(count);
    CHECK(signorini_test::problem_message([] {
            for_parts(100, [](Index part) {
              if (part == 99) throw std::runtime_error("the last one");
              if (part % 10 == 7) throw ProblemError("part " + std::to_string(part));
            });
          }) == "part 7");
    CHECK(free_threads() == count);  // the next loop has all threads again
  }
}

TEST_CASE("of two parts that fail the first is told, whichever fails earlier", "[parts]") {
  const auto rest = [] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
  for (const Index early : {0, 1}) {
    const Threads now(2);
    CAPTURE(early);
    std::atomic<int> begun{0};
    std::atomic<bool> failed{false};
    CHECK(signorini_test::problem_message([&] {
            for_parts(2, [&](Index part) {
              ++begun;
              for (int k = 0; k < 1000 && begun < 2; ++k) rest();  // both have been handed out
              if (part == early) {
                failed = true;
                throw ProblemError(part == 0 ? "the first" : "the second");
              }
              for (int k = 0; k < 1000 && !failed; ++k) rest();
              for (int k = 0; k < 20; ++k) rest();  // until the early one has been caught
              throw ProblemError(part == 0 ? "the first" : "the second");
            });
          }) == "the first");
  }
}

TEST_CASE("a number of threads below one is refused", "[parts]") {
  CHECK_THROWS_AS(set_threads(0), std::invalid_argument);
  CHECK(threads() == 1);
}
