#include <atomic>
#include <string>
#include <vector>

#include "addons/frontal/threads.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/scene/scene.hpp"
#include "support/cantilever.hpp"
#include "support/factors.hpp"
#include "support/hertz.hpp"
#include "support/message.hpp"
#include "support/threads.hpp"

using namespace signorini;
using Eigen::Index;
using Eigen::VectorXd;
using signorini_test::Placed;
using signorini_test::Threads;

namespace {

/// Large enough for some dozen parts.
const Placed& large() {
  static const Placed block = [] {
    BlockSpec spec;
    spec.name = "block";
    spec.cells_x = 80;
    spec.cells_y = 60;
    return signorini_test::stiffness("block", make_block(spec), find_element("q4_incompatible"),
                                     {fixed("left")});
  }();
  return block;
}

Fronts fronts_of_block() {
  return fronts_of(large().K, separator_tree(large().K, large().positions));
}

/// All numbers of a solution, of the compliance and of the stresses, one behind the other.
VectorXd numbers(const Scene& scene) {
  Ledger ledger;
  const Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  const Solution solution = solve(model, condensed, ledger);
  std::vector<double> all(
      model.programme.stiffness.valuePtr(),
      model.programme.stiffness.valuePtr() + model.programme.stiffness.nonZeros());
  const auto take = [&all](const auto& matrix) {
    all.insert(all.end(), matrix.data(), matrix.data() + matrix.size());
  };
  take(model.programme.load);
  take(condensed.problem.compliance);
  take(solution.contact.force);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    take(solution.displacements[b]);
    take(nodal_stress(body.mesh, body.element, body.material, solution.displacements[b]));
    take(cell_stress(body.mesh, body.element, body.material, solution.displacements[b]));
  }
  all.push_back(solution.certificate.worst());
  return Eigen::Map<const VectorXd>(all.data(), static_cast<Index>(all.size()));
}

}  // namespace

TEST_CASE("scenes have the same bits on any number of threads", "[threads]") {
  HertzMeshSpec spec;
  for (Index* cells : {&spec.disc_cells, &spec.disc_rows, &spec.disc_layers, &spec.plate_cells,
                       &spec.plate_rows, &spec.plate_layers})
    *cells *= 3;
  for (const Scene& scene :
       {signorini_test::cantilever("q4_incompatible", 160, 16), signorini_test::hertz(spec)}) {
    const VectorXd alone = numbers(scene);
    for (const int count : {2, 3, 8}) {
      const Threads now(count);
      CAPTURE(count);
      CHECK(numbers(scene) == alone);
    }
  }
}

TEST_CASE("the parts of a tree have each front once, subtrees and fronts above them", "[threads]") {
  const Fronts fronts = fronts_of_block();
  REQUIRE(fronts.parts.size() > 20);
  int next = 0;
  for (std::size_t k = 0; k < fronts.parts.size(); ++k) {
    const TreePart& part = fronts.parts[k];
    CHECK(part.first == next);
    REQUIRE(part.end > part.first);
    next = part.end;
    for (int number = part.first; number < part.end; ++number)
      for (const int below : fronts.front(number).separator.below)
        if (below >= 0 && below < part.first)
          CHECK(fronts.parts[static_cast<std::size_t>(fronts.part_below(part, below))].end ==
                below + 1);
    for (const int below : part.below) {
      CHECK(part.end == part.first + 1);
      CHECK(fronts.parts[static_cast<std::size_t>(below)].above == static_cast<int>(k));
    }
  }
  CHECK(next == static_cast<int>(fronts.all.size()));
}

TEST_CASE("a part comes after those below it, or after the one above it", "[threads]") {
  const std::vector<TreePart> parts = fronts_of_block().parts;
  for (const int count : {1, 2, 3, 8}) {
    const Threads now(count);
    CAPTURE(count);
    std::vector<std::atomic<int>> done(parts.size());
    std::atomic<int> wrong{0};
    up_the_tree(parts, [&](int part, int worker) {
      wrong += worker < 0 || worker >= count ? 1 : 0;
      for (const int below : parts[static_cast<std::size_t>(part)].below)
        wrong += done[static_cast<std::size_t>(below)] != 1 ? 1 : 0;
      ++done[static_cast<std::size_t>(part)];
    });
    down_the_tree(parts, [&](int part, int /*worker*/) {
      const int above = parts[static_cast<std::size_t>(part)].above;
      wrong += above >= 0 && done[static_cast<std::size_t>(above)] != 2 ? 1 : 0;
      ++done[static_cast<std::size_t>(part)];
    });
    CHECK(wrong == 0);
    for (const std::atomic<int>& times : done) CHECK(times == 2);
  }
}

TEST_CASE("of parts that fail the first is told, whichever fails first", "[threads]") {
  const std::vector<TreePart> parts = fronts_of_block().parts;
  for (const int count : {1, 2, 3, 8}) {
    const Threads now(count);
    CAPTURE(count);
    CHECK(signorini_test::problem_message([&] {
            up_the_tree(parts, [&](int part, int /*worker*/) {
              if (part >= 5 && parts[static_cast<std::size_t>(part)].below.empty())
                throw ProblemError(text("part ", part));
            });
          }) == [&] {
      std::size_t first = 5;
      while (!parts[first].below.empty()) ++first;
      return text("part ", first);
    }());
  }
}

TEST_CASE("the first unknown without resistance is named on any number of threads", "[threads]") {
  Placed loose = large();
  for (const Index unknown : {3000, 500, 7000})  // each hangs on nothing
    for (Index column = 0; column < loose.K.cols(); ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(loose.K, column); entry; ++entry)
        if (entry.row() == unknown || column == unknown) entry.valueRef() = 0;
  const auto message = [&] {
    return signorini_test::problem_message([&] {
      Ledger ledger;
      const FrontalFactor factor(loose.K, separator_tree(loose.K, loose.positions), ledger);
    });
  };
  const std::string alone = message();
  CHECK(alone.find("singular at unknown") != std::string::npos);
  for (const int count : {2, 3, 8}) {
    const Threads now(count);
    CAPTURE(count);
    CHECK(message() == alone);
  }
}

TEST_CASE("a cell that folds over itself is named on any number of threads", "[threads]") {
  for (const int count : {1, 2, 3, 8}) {
    const Threads now(count);
    Scene scene = signorini_test::cantilever("q8", 60, 12);
    Mesh& mesh = scene.bodies[0].mesh;
    for (const Index cell : {700, 300}) mesh.nodes(mesh.cells(cell, 4), 1) += 3;
    CAPTURE(count);
    CHECK(signorini_test::problem_message([&] {
            Ledger ledger;
            static_cast<void>(build(scene, ledger));
          }).find("cell 300 folds over itself") != std::string::npos);
  }
}
