// Chapter 18 - What cannot be meant is refused, what is seldom meant is noted.
// Run:  make ch18     Reads: nothing     Writes: refusals.md
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "scenes.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

// Something that is seldom meant.
struct Mistake {
  std::string what;
  std::function<void(Scene&)> make;
};

// Mistakes to be made in the scene of the floating cylinder on a plate.
// [mistakes]
std::vector<Mistake> mistakes() {
  return {{"friction that pulls",
           [](Scene& s) {
             s.contacts[0].friction = Friction{-0.3, 0};
           }},
          {"a body that nothing holds", [](Scene& s) { s.contacts.clear(); }},
          {"the same contact twice", [](Scene& s) { s.contacts.push_back(s.contacts[0]); }},
          {"rock on the wrong side",
           [](Scene& s) {
             s.contacts[0].target = half_plane({0, 0}, {0, -1});
           }},
          {"heat without expansion",
           [](Scene& s) {
             s = heated(std::move(s));
             s.bodies[0].material.expansion = 0;
           }},
          {"an element that locks", [](Scene& s) {
             s.bodies[0].element = "q4";
             s.bodies[0].material.poisson_ratio = 0.49;
           }}};
}
// [mistakes]

// What cannot be meant is refused, in words that name the way out.
void refusals(const ProgramOptions& run) {
  std::string list;
  for (const Mistake& mistake : mistakes()) {
    Scene scene = floating(with_plate(on_rock(0)));
    mistake.make(scene);
    try {
      const Plan planned = plan(scene);
      list += "* " + mistake.what + ", and a note: *" + planned.notes.back() + "*\n";
    } catch (const ProblemError& error) {
      list += "* " + mistake.what + ": *" + error.what() + "*\n";
    }
  }
  std::cout << list;
  write_file(run.out / "refusals.md", list);
}

SolveStatus chapter(const ProgramOptions& run) {
  refusals(run);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch18_refusals", "What is refused", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
