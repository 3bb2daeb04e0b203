// Solves random scenes whose forces may not be determined, and counts how often notes and truth agree.
// Run:  shared_forces FIRST COUNT
// COUNT scenes are to be solved. Ends with 1 if less than 99 % of what is not determined is named, or more than 5 % is named in vain.
#include "support/shared_forces.hpp"

#include <iostream>

using namespace signorini_test;

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "shared_forces FIRST COUNT\n";
    return 2;
  }
  const SharedForceCounts counts = compare_shared_forces(std::stoull(argv[1]), std::stoi(argv[2]));
  for (const std::string& wrong : counts.wrong) std::cout << wrong << '\n';
  std::cout << counts.solved << " solved, " << counts.unsolved << " not; forces not determined in "
            << counts.open << " scenes, " << counts.missed << " of them without a note, "
            << counts.in_vain << " notes in vain; " << counts.pairs << " pairs, "
            << counts.pairs_missed << " not named, " << counts.pairs_in_vain << " in vain\n";
  const bool good =
      100 * counts.missed <= counts.open && 20 * counts.in_vain <= counts.solved - counts.open;
  return good ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "shared_forces: " << error.what() << '\n';
  return 1;
}
