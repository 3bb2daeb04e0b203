// Chapter 13 - Which body is the source, if the meshes do not match.
// Run:  make ch13     Reads: nothing     Writes: ch13_sides.results, sides.md
#include <iostream>

#include "base.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/report/shown.hpp"

namespace {

using namespace ch13;

// Who carries the forces, and by which operator, if the meshes do not match.
void sides(const ProgramOptions& run, Results& results) {
  const EdgeBlockSpec soil = soil_of(24, 26, 28, 64, 60);
  Table table({"cells of the footing", "source", "mortar [%]", "node_to_segment [%]"});
  for (const Index columns : {24, 16, 36})
    for (const char* source : {"soil", "footing"}) {
      std::vector<std::string> row = {std::to_string(columns), source};
      for (const char* gap_operator : {"mortar", "node_to_segment"}) {
        Scene scene = on_soil(soil, {2, 8, footing_modulus, columns});
        ContactSpec& contact = scene.contacts.front();
        contact.gap_operator = gap_operator;
        if (source == std::string("footing")) {
          const Side ground = contact.source;
          contact.source = std::get<Side>(contact.target);
          contact.target = ground;
        }
        const SolvedScene now = solved(scene, "the footing");
        row.push_back(percent(base_of(now).worst()));
        results.add(text(gap_operator, '_', source, '_', columns), 100 * base_of(now).worst(), "%");
      }
      table.row(row);
    }
  std::cout << table.markdown();
  write_file(run.out / "sides.md", table.markdown());
  const SolvedScene matching = shown(on_soil(coarse, {}), "the footing");  // with its plan
  results.add("overhang", static_cast<double>(matching.model.pairs.unpaired.size()), "-");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch13_sides");
  sides(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch13_sides", "Which side is the source", SIGNORINI_CHAPTER_OUT, argc, argv,
                     chapter);
}
