// Chapter 21 - What the way of the rows of A costs, compared with the factor, on a square body and on the beam.
// Run:  make ch21     Reads: nothing     Writes: ch21.results
#include <set>
#include <vector>

#include "addons/frontal/separator_tree.hpp"
#include "scenes.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"

namespace {

using namespace ch21;

/// Multiplications for the compliance of all rows of A over those for the factor, front by front: H and what it
/// hands up, then H^T H; and the dense elimination of the own unknowns.
double price_of_compliance(const Model& model) {
  const SeparatorTree tree = separator_tree(model.programme.stiffness, unknown_positions(model));
  const std::vector<Separator>& separators = tree.separators;
  const Eigen::SparseMatrix<double> A = model.programme.A;  // by columns
  std::vector<int> place(tree.order.size());
  for (std::size_t k = 0; k < place.size(); ++k)
    place[static_cast<std::size_t>(tree.order[k])] = static_cast<int>(k);
  std::vector<std::set<int>> boundary(separators.size());
  std::vector<std::set<Eigen::Index>> rows(separators.size());
  double compliance = 0;
  double factor = 0;
  for (std::size_t s = 0; s < separators.size(); ++s) {
    const int end = separators[s].first + separators[s].own;
    for (const int below : separators[s].below) {
      if (below < 0) continue;
      const std::size_t part = static_cast<std::size_t>(below);
      boundary[s].insert(boundary[part].lower_bound(end), boundary[part].end());
      rows[s].insert(rows[part].begin(), rows[part].end());
    }
    for (int k = separators[s].first; k < end; ++k) {
      const int unknown = tree.order[static_cast<std::size_t>(k)];
      for (Eigen::SparseMatrix<double>::InnerIterator entry(A, unknown); entry; ++entry)
        rows[s].insert(entry.row());
      for (Eigen::SparseMatrix<double>::InnerIterator entry(model.programme.stiffness, unknown);
           entry; ++entry)
        if (const int other = place[static_cast<std::size_t>(entry.row())]; other >= end)
          boundary[s].insert(other);
    }
    // [price]
    const double own = separators[s].own;
    const double rim = static_cast<double>(boundary[s].size());
    const double carried = static_cast<double>(rows[s].size());
    factor += own * own * own / 6 + own * own * rim / 2 + own * rim * rim / 2;
    compliance += carried * (own * own / 2 + own * rim) + own * carried * carried / 2;
    // [price]
  }
  return compliance / factor;
}

/// The same as a solution counts it while it works: additions and divisions, too. The plain solve is no part of it.
double counted_price(const Scene& scene) {
  const SolvedScene run = solved(scene, "the square");
  const auto counted = [&](const char* phase, const char* what) {
    return static_cast<double>(run.solution.ledger.counted(phase, what));
  };
  return (counted("condensation", "operations") -
          counted("condensation", "operations of one solve")) /
         counted("factor/numeric", "operations");
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch21");
  results.headline("price_square", 100 * counted_price(square(24)), "operations of the solver");
  results.add("price_square", 100 * price_of_compliance(built(square(24))), "%");
  for (const Index cells : {10, 40})
    results.add(text("price_beam_", 10 * cells),
                100 * price_of_compliance(built(cantilever(cells, "q4"))), "%");
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch21", "The price of rows", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
