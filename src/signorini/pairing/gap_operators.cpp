// # Three gap operators
//
// A gap operator turns two boundaries into pairs, each with one gap. It decides where the contact
// forces live, and how a force on the source reaches the nodes of the target.
//
// - node_to_segment: at every node of the source. Simple; a uniform pressure arrives as jumps.
// - gauss_points: at points of every side, as in the second paper. Often more forces than can be
//   determined.
// - mortar: means over edges, with a weight function per node. A uniform pressure arrives uniform.
//
// Chapters 9 and 10 derive them, chapter 11 compares them on the cylinder of Hertz. A fourth one
// needs a function and its name in the table.

#include "signorini/contact/gap_operators.hpp"

#include "signorini/pairing/register.hpp"

namespace signorini {

// The table: one line per function that returns a member.
#define SIGNORINI_GAP_OPERATORS node_to_segment(), gauss_points(), mortar()

namespace gap_operator {
GapOperator SIGNORINI_GAP_OPERATORS;  // declares them
}

// Contact with a rigid obstacle needs none of them. So a program gets the three if it is linked with
// this folder, see [registered.cpp](registered.cpp).
void register_gap_operators() {
  using namespace gap_operator;
  static const std::vector<GapOperator> family = {SIGNORINI_GAP_OPERATORS};
  for (const GapOperator& member : family) add_gap_operator(member);
}

}  // namespace signorini
