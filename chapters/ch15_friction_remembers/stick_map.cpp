// Chapter 15 - The stick map of a push that goes to and fro.
// Run:  make ch15     Reads: nothing     Writes: ch15_stick_map.results, fig_15_3.csv, fig_15_3_edge.csv
#include <vector>

#include "partial_slip.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace ch15;

// What each place of the contact does while the push goes to and fro.
void stick_map(const ProgramOptions& run, Results& results) {
  const Pressed known = pressed_cylinder();
  Table map({"time", "x", "width", "motion"}), edge({"time", "stuck"});
  std::vector<bool> slid;
  double never_slid = 0;  // width [mm]
  remember(by_force(cylinder(push_times(6), pressing, known.push())), [&](const Model& model,
                                                                          const Step& step) {
    const std::vector<ContactStatus>& contact_status = step.solution.contact.contact_status;
    slid.resize(contact_status.size());
    never_slid = 0;
    for (std::size_t i = 0; i < contact_status.size(); ++i) {
      const auto pair = static_cast<Index>(i);
      map.row({number(step.state.time), number(model.pairs.position(pair, 0)),
               number(model.pairs.weight(pair)), to_string(contact_status[i])});
      slid[i] = slid[i] || contact_status[i] != ContactStatus::Stick;
      if (!slid[i]) never_slid += model.pairs.weight(pair);
    }
  });
  for (const double time : steps_between(1, 6, 60)) edge.row({time, known.stuck(time)});
  write_file(run.out / "fig_15_3.csv", map.csv());
  write_file(run.out / "fig_15_3_edge.csv", edge.csv());
  results.add("never_slid", never_slid, "mm");
  results.add("never_slid_exact", 2 * known.stuck(2), "mm");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch15_stick_map");
  stick_map(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch15_stick_map", "A stick map", SIGNORINI_CHAPTER_OUT, argc, argv,
                                chapter);
}
