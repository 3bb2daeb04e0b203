#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <sstream>

#include "addons/equations/bonds.hpp"
#include "addons/frontal/frontal_factor.hpp"
#include "addons/prediction/prediction.hpp"
#include "catch_compat.hpp"
#include "signorini/core/bytes.hpp"
#include "signorini/core/index.hpp"
#include "meshes/block.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"
#include "signorini/solvers/lemke.hpp"
#include "support/cantilever.hpp"
#include "support/effect_examples.hpp"
#include "support/hertz.hpp"
#include "support/paths.hpp"
#include "support/stack.hpp"
#include "support/two_bodies.hpp"

using namespace signorini;
using namespace signorini_test;
using Eigen::Index;

namespace {

/// A square that is fixed at its top and pressed down onto a rigid plane.
Scene pressed_block() {
  Scene scene = two_blocks(named_block("square", {0, 0}, {2, 2}, 20, 20),
                           named_block("other", {0, 5}, {1, 1}, 1, 1));
  scene.bodies.pop_back();
  scene.bodies[0].supports = {prescribed("top", Axis::Y, -0.01), symmetric("left")};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

/// So many of them side by side, which nothing connects.
Scene row_of_blocks(int count) {
  Scene scene = pressed_block();
  const Body first = scene.bodies[0];
  scene.bodies.clear();
  scene.contacts.clear();
  for (int k = 0; k < count; ++k) {
    scene.bodies.push_back(first);
    scene.bodies.back().mesh =
        named_block("square " + std::to_string(k), {3.0 * k, 0}, {2, 2}, 20, 20);
    scene.contacts.push_back(
        {{"bottom", scene.bodies.back().mesh.name}, half_plane({0, 0}, {0, 1})});
  }
  return scene;
}

/// Two blocks, of which only contact holds the upper one.
Scene floating_block() {
  Scene scene = two_blocks(named_block("lower", {0, 0}, {4, 2}, 24, 12),
                           named_block("upper", {1, 2}, {2, 2}, 16, 16));
  scene.bodies[1].supports = {symmetric("left")};
  scene.bodies[1].loads.edges = {{"top", 3, {}}};
  return scene;
}

Scene frictional_blocks() {
  Scene scene = floating_block();
  scene.bodies[1].supports.clear();
  scene.contacts[0].friction = Friction{0.3, 0};
  return scene;
}

/// Loose blocks on each other, of which the lowest is held and the highest pressed.
Scene tower(int count) {
  Scene scene = pressed_block();
  const Body first = scene.bodies[0];
  scene.bodies.clear();
  scene.contacts.clear();
  for (int k = 0; k < count; ++k) {
    const std::string name = "block " + std::to_string(k);
    scene.bodies.push_back(first);
    scene.bodies.back().mesh = named_block(name, {0, 2.0 * k}, {2, 2}, 20, 20);
    scene.bodies.back().supports = {symmetric("left")};
    if (k > 0)
      scene.contacts.push_back({{"bottom", name}, Side{"top", scene.bodies[at(k - 1)].mesh.name}});
  }
  scene.bodies.front().supports = {fixed("bottom")};
  scene.bodies.back().loads.edges = {{"top", 3, {}}};
  return scene;
}

Scene without_contact() {
  Scene scene = cantilever("q8", 20, 4);
  scene.contacts.clear();
  return scene;
}

Scene frictional_cantilever() {
  Scene scene = cantilever("q4_incompatible", 100, 10);
  scene.contacts[0].friction = Friction{0.2, 0.1};
  return scene;
}

const std::map<std::string, std::function<Scene()>>& scenes() {
  static const std::map<std::string, std::function<Scene()>> all = {
      {"block", pressed_block},
      {"cantilever", [] { return cantilever("q4_incompatible", 100, 10); }},
      {"cantilever of q8", [] { return cantilever("q8", 40, 4); }},
      {"Hertz", [] { return hertz(); }},
      {"floating", floating_block},
      {"floating, friction", frictional_blocks},
      {"cantilever, friction", frictional_cantilever},
      {"tower", [] { return tower(8); }},
      {"without contact", without_contact},
      {"four blocks", [] { return row_of_blocks(4); }}};
  return all;
}

double all_operations(const std::function<double(const char*)>& in) {
  return in("factor/numeric") + in("condensation") + in("refinement");
}

}  // namespace

TEST_CASE("what is said to be exact is so, and the operations of a run are within a tenth",
          "[prediction]") {
  for (const auto& [name, scene] : scenes()) {
    CAPTURE(name);
    const Plan planned = plan(scene());
    const Prediction prediction = predict(planned);
    const Solution solution = solve(scene());
    REQUIRE(solution.contact.report.status == SolveStatus::Solved);
    int exact = 0;
    for (const ComparedFigure& figure : compare(prediction, {solution.ledger})) {
      CAPTURE(figure.predicted.phase, figure.predicted.what);
      if (figure.predicted.certainty == Certainty::Exact) {
        CHECK(figure.measured == figure.predicted.amount);
        ++exact;
      }
      CHECK(figure.measured.has_value());
    }
    CHECK(exact == 13);
    const double predicted =
        all_operations([&](const char* phase) { return prediction.amount(phase, "operations"); });
    const double measured = all_operations([&](const char* phase) {
      return static_cast<double>(solution.ledger.counted(phase, "operations"));
    });
    CHECK(predicted == Approx(measured).epsilon(0.1));
  }
}

TEST_CASE("a run that begins with the order of its forecast finds none, and has the same bits", "[prediction]") {
  for (const auto& [name, scene] : scenes()) {
    CAPTURE(name);
    Plan planned = plan(scene());
    const Prediction prediction = predict(planned);
    CHECK(prediction.taken.counted("factor/ordering", "orders") == 1);
    const auto solved = [&](Ledger ledger) {
      const Model model = build(planned, ledger);
      const Condensed condensed = condense(model, ledger);
      return solve(model, condensed, std::move(ledger));
    };
    const Solution finds = solved({});
    planned.order = prediction.order;
    const Solution begins = solved(prediction.taken);
    CHECK(finds.ledger.counted("factor/ordering", "orders") == 1);
    CHECK(begins.ledger.counted("factor/ordering", "orders") == 1);
    CHECK(begins.contact.force == finds.contact.force);
    CHECK(begins.displacements == finds.displacements);
  }
  Plan other = plan(pressed_block());
  other.backend = sparse_cholesky();
  const Prediction prediction = predict(other);
  CHECK_FALSE(prediction.order.has_value());
  CHECK(prediction.taken.entries().empty());
}

TEST_CASE("bodies that nothing connects cost as many solves as there are, each of its own part",
          "[prediction][separate]") {
  const auto refinement = [](const Solution& solution, const char* what) {
    return static_cast<double>(solution.ledger.counted("refinement", what));
  };
  const Solution alone = solve(row_of_blocks(1));
  for (const int count : {2, 16, 64}) {
    CAPTURE(count);
    const Scene scene = row_of_blocks(count);
    const Prediction prediction = predict(plan(scene));
    const Solution solution = solve(scene);
    REQUIRE(solution.contact.report.status == SolveStatus::Solved);
    CHECK(refinement(solution, "solves") == count * refinement(alone, "solves"));
    CHECK(prediction.amount("refinement", "solves") ==
          Approx(refinement(solution, "solves")).epsilon(0.5));
    CHECK(refinement(solution, "operations") <= 1.5 * count * refinement(alone, "operations"));
    CHECK(prediction.amount("refinement", "operations") ==
          Approx(refinement(solution, "operations")).epsilon(0.5));
    const Eigen::Index pairs = alone.contact.force.size();
    for (int k = 0; k < count; ++k)
      CHECK((solution.contact.force.segment(k * pairs, pairs) - alone.contact.force)
                .cwiseAbs()
                .maxCoeff() <= 1e-13 * alone.contact.force.maxCoeff());
  }
}

TEST_CASE("many bodies are predicted by their entries", "[prediction]") {
  const Scene scene = stack(26, 0);
  const Prediction prediction = predict(plan(scene));
  const Solution solution = solve(scene);
  REQUIRE(solution.contact.report.status == SolveStatus::Solved);
  for (const char* what : {"solves", "operations"})
    CHECK(prediction.amount("refinement", what) ==
          static_cast<double>(solution.ledger.counted("refinement", what)));
  CHECK(prediction.amount("condensation", "bytes") == 0);
  CHECK(prediction.amount("condensation", "operations") ==
        static_cast<double>(solution.ledger.counted("condensation", "operations")));
}

TEST_CASE("the figures that are said to be exact are so whatever effect is on", "[prediction]") {
  for (const auto& [name, example] : effect_examples()) {
    CAPTURE(name);
    Ledger ledger;
    const Prediction prediction = predict(plan(example.with));
    static_cast<void>(condense(build(example.with, ledger), ledger));
    int exact = 0;
    for (const ComparedFigure& figure : compare(prediction, {ledger})) {
      if (figure.predicted.certainty != Certainty::Exact) continue;
      CAPTURE(figure.predicted.phase, figure.predicted.what);
      CHECK(figure.measured == figure.predicted.amount);
      ++exact;
    }
    // Under finite strain each iteration has a factor, so that what one takes is not all of it.
    CHECK(exact == (name == "finite strain" ? 5 : 13));
  }
}

// A plan has no numbers of K yet, and so none to measure springs by: in Pa and m they are large ones.
TEST_CASE("elastic ties are predicted in any units", "[prediction][springs]") {
  const double unit = GENERATE(1.0, 1e6);
  Scene scene = two_blocks(named_block("lower", {0, 0}, {4, 2}, 8, 4),
                           named_block("upper", {0, 2}, {4, 2}, 8, 4));
  for (Body& body : scene.bodies) body.material.youngs_modulus = 1000 * unit;
  scene.bodies[1].loads.edges = {{"top", unit, {}}};
  scene.contacts.clear();
  auto bonds = std::make_shared<Bonds>();
  Tie& tie = bonds->ties.emplace_back();
  tie.sides = {{"bottom", "upper"}, Side{"top", "lower"}};
  tie.stiffness = Eigen::Vector2d(200 * unit, 200 * unit);
  scene.bonds = bonds;
  const Prediction prediction = predict(plan(scene));
  CHECK(prediction.amount("assembly", "unknowns") > 0);
}

TEST_CASE("a path is predicted with all its steps, and its ledgers add up to what is exact",
          "[prediction][steps]") {
  const Scene one = signorini_test::slab(1, {});
  const Scene many = signorini_test::slab(4, {1, -1});
  const Prediction prediction = predict(plan(many));
  std::vector<Ledger> ledgers;
  const PathEnd end = solve_steps(
      many, [&](const Model&, const Step& step) { ledgers.push_back(step.solution.ledger); });
  REQUIRE(end.status == SolveStatus::Solved);
  const double steps = static_cast<double>(many.path->times.size());
  REQUIRE(static_cast<double>(ledgers.size()) == steps);
  int exact = 0;
  double solves = 0, all = 0, later = 0;
  for (const ComparedFigure& figure : compare(prediction, ledgers)) {
    CAPTURE(figure.predicted.phase, figure.predicted.what);
    if (figure.predicted.phase == "refinement" && figure.predicted.what == "solves")
      solves = *figure.measured;
    CHECK(figure.measured.has_value());
    if (figure.predicted.phase == "all phases") all = *figure.measured;
    if (figure.predicted.phase == "a later step") later = *figure.measured;
    if (figure.predicted.certainty != Certainty::Exact) continue;
    CHECK(figure.measured == figure.predicted.amount);
    ++exact;
  }
  CHECK(exact == 13);
  double begun = 0;  // seconds of the first step
  for (const LedgerEntry& entry : ledgers.front().entries())
    if (entry.path.find('/') == std::string::npos) begun += entry.seconds;
  CHECK(begun > 0);
  CHECK(all == Approx(begun + (steps - 1) * later));
  double counted = 0;
  for (const Ledger& ledger : ledgers)
    counted += static_cast<double>(ledger.counted("refinement", "solves"));
  CHECK(solves == counted);
  CHECK(solves > steps);
  const Prediction first = predict(plan(one));
  CHECK(prediction.amount("refinement", "solves") == steps * first.amount("refinement", "solves"));
  CHECK(prediction.amount("a later step", "seconds") > 0);
  CHECK(first.amount("a later step", "seconds") == 0);
  Scene smooth_one = one;  // held and smooth: iterations are known beforehand
  Scene smooth_many = many;
  for (Scene* scene : {&smooth_one, &smooth_many}) {
    scene->contacts[0].friction.reset();
    scene->bodies[0].supports.push_back(fixed("left"));
    scene->solver = Scene().solver;
  }
  const double iterations = predict(plan(smooth_one)).amount("contact", "iterations");
  CHECK(iterations > 0);
  CHECK(predict(plan(smooth_many)).amount("contact", "iterations") == steps * iterations);
}

TEST_CASE("iterations that depend on the numbers are not predicted, and the whole only from below",
          "[prediction]") {
  const auto predicted = [](const Scene& scene, const std::string& phase, const std::string& what) {
    const Prediction prediction = predict(plan(scene));
    for (const PredictedFigure& figure : prediction.figures)
      if (figure.phase == phase && figure.what == what) return figure;
    return PredictedFigure();
  };
  Scene other = pressed_block();
  other.solver = lemke();
  for (const Scene& scene : {floating_block(), frictional_cantilever(), other}) {
    for (const char* what : {"iterations", "seconds"}) {
      CHECK(predicted(scene, "contact", what).certainty == Certainty::Unknown);
      CHECK(std::isnan(predicted(scene, "contact", what).amount));
    }
    const double round = predicted(scene, "contact", "seconds of one iteration").amount;
    CHECK(round > 0);
    CHECK(predicted(scene, "all phases", "seconds").certainty == Certainty::AtLeast);
    CHECK(predicted(scene, "all phases", "seconds").amount > 0);
    CHECK_FALSE(predict(plan(scene)).unknown.empty());
    std::ostringstream out;
    out << predict(plan(scene));
    CHECK_THAT(out.str(), ContainsSubstring("iterations not known, seconds of one iteration") &&
                              ContainsSubstring("seconds at least"));
  }
  CHECK(predicted(pressed_block(), "contact", "iterations").amount == 5);
  CHECK(predicted(pressed_block(), "contact", "seconds").certainty == Certainty::Estimate);
  CHECK(predicted(pressed_block(), "all phases", "seconds").certainty == Certainty::Estimate);
  CHECK(predict(plan(pressed_block())).unknown.empty());
  const Solution solution = solve(frictional_cantilever());
  for (const ComparedFigure& figure :
       compare(predict(plan(frictional_cantilever())), {solution.ledger}))
    if (figure.predicted.what == "seconds of one iteration")
      CHECK(figure.measured ==
            solution.ledger.seconds("contact") /
                static_cast<double>(solution.ledger.counted("contact", "iterations")));
}

TEST_CASE("the ledger, which a prediction is set against, counts what the matrices have",
          "[prediction]") {
  for (const auto& [name, scene] : scenes()) {
    CAPTURE(name);
    Ledger ledger;
    const Scene now = scene();
    const Model model = build(now, ledger);
    const Condensed condensed = condense(model, ledger);
    const auto is = [&](const char* phase, const char* what, Index amount) {
      CAPTURE(phase, what);
      CHECK(ledger.counted(phase, what) == amount);
      CHECK(predict(plan(now)).amount(phase, what) == static_cast<double>(amount));
    };
    const QuadraticProgramme& programme = model.programme;
    is("assembly", "unknowns", programme.load.size());
    is("assembly", "pairs", static_cast<Index>(model.pairs.node.size()));
    is("assembly", "rows", programme.initial_gap.size());
    is("assembly", "stiffness entries", programme.stiffness.nonZeros());
    is("factor/numeric", "nonzeros", condensed.factor.nonzeros());
    // A solve multiplies and adds with every entry below the diagonal twice, and divides by each pivot twice.
    is("condensation", "operations of one solve",
       4 * condensed.factor.nonzeros() - 2 * condensed.factor.size());
  }
}

TEST_CASE("each effect says how many rows it takes, and the bytes of all are those of A",
          "[prediction]") {
  const Plan planned = plan(frictional_cantilever());
  Ledger ledger;
  const Model model = build(planned, ledger);
  const auto bytes = [&](const std::string& words) {
    for (const std::string& line : planned.on)
      if (const std::size_t at = line.find(words); at != std::string::npos)
        return std::stoll(line.substr(at + words.size()));
    return 0LL;
  };
  const long long contact = bytes("; contact takes 100 rows of A, ");
  const long long friction = bytes("; friction takes 100 rows of A, ");
  CHECK(contact > 0);
  CHECK(friction > 0);
  CHECK(contact + friction + 4 == bytes_of(model.programme.A));  // 4: where the first row begins
  for (const std::string& line : plan(without_contact()).on)
    CHECK(line.find("rows of A") == std::string::npos);
}

TEST_CASE("no row costs no byte and no operation but those of one linear solve", "[prediction]") {
  const Prediction prediction = predict(plan(without_contact()));
  CHECK(prediction.amount("condensation", "bytes") == 0);
  CHECK(prediction.amount("condensation", "stack bytes") == 0);
  CHECK(prediction.amount("condensation", "operations") ==
        prediction.amount("condensation", "operations of one solve"));
  CHECK(prediction.amount("contact", "iterations") == 0);
  CHECK(prediction.method.find("one linear solve") == 0);
}

TEST_CASE("the operations of a front are those of its columns", "[prediction]") {
  for (const Index own : {0, 1, 2, 7, 64, 65})
    for (const Index rim : {0, 1, 5, 40}) {
      double sum = 0;
      for (Index below = rim; below < own + rim; ++below)
        sum += static_cast<double>(below + below * (below + 1));  // divisions, then half a square
      CHECK(elimination_operations(own, rim) == sum);
    }
}

TEST_CASE("the loads of a body add up to what a plan says", "[prediction]") {
  Scene scene = floating_block();
  scene.bodies[1].loads.edges = {{"top", 3, {}}, {"right", 0, [](const Eigen::Vector2d& x) {
                                                    return Eigen::Vector2d(x.y(), 0);
                                                  }}};
  scene.bodies[0].loads.body_force = [](const Eigen::Vector2d&) {
    return Eigen::Vector2d(0, -0.5);
  };
  const Prediction prediction = predict(plan(scene));
  const BodySummary& lower = prediction.bodies[0];
  const BodySummary& upper = prediction.bodies[1];
  CHECK(lower.force.x() == 0);
  CHECK(lower.force.y() == Approx(-4).epsilon(1e-13));
  CHECK(lower.moment == Approx(-8).epsilon(1e-13));    // 4 across, middle at x = 2
  CHECK(upper.force.x() == Approx(6).epsilon(1e-13));  // y from 2 to 4
  CHECK(upper.force.y() == Approx(-6).epsilon(1e-13));
  const double of_right = -(64.0 - 8.0) / 3;  // -y y over the side
  CHECK(upper.moment == Approx(-12 + of_right).epsilon(1e-13));
}

TEST_CASE("loose pieces of a body are counted", "[prediction]") {
  Scene scene = pressed_block();
  Mesh& mesh = scene.bodies[0].mesh;
  Mesh other = named_block("other", {3, 0}, {1, 2}, 2, 2);
  const Index first = mesh.n_nodes();
  mesh.nodes.conservativeResize(first + other.n_nodes(), 2);
  mesh.nodes.bottomRows(other.n_nodes()) = other.nodes;
  mesh.cells.conservativeResize(mesh.n_cells() + other.n_cells(), 4);
  mesh.cells.bottomRows(other.n_cells()) = (other.cells.array() + first).matrix();
  CHECK(pieces(named_block("one", {0, 0}, {1, 1}, 3, 3)).size() == 1);
  CHECK(pieces(mesh).size() == 2);
}

TEST_CASE("what was measured stands beside what was predicted", "[prediction]") {
  std::ostringstream out;
  out << std::vector<ComparedFigure>{
      {{Frequency::Once, "factor/numeric", "operations", 100, Certainty::Estimate}, 250.0},
      {{Frequency::Once, "assembly", "stack bytes", 3e6, Certainty::Exact}, 2.5e6},
      {{Frequency::Once, "contact", "seconds", 7, Certainty::Estimate}, {}}};
  const auto row = [&](const char* phase) {
    std::istringstream lines(out.str());
    for (std::string line; std::getline(lines, line);)
      if (line.rfind(phase, 0) == 0) return line;
    return std::string();
  };
  CHECK_THAT(row("factor/numeric"), ContainsSubstring(" 100         250  about"));
  CHECK_THAT(row("assembly"), ContainsSubstring(" 3 MB      2.5 MB  exact"));
  CHECK_THAT(row("contact"), ContainsSubstring(" 7 s           -  about"));
}

TEST_CASE("a prediction and what became of it are printed", "[prediction]") {
  const Prediction prediction = predict(plan(pressed_block()));
  std::ostringstream out;
  out << prediction << compare(prediction, {solve(pressed_block()).ledger});
  for (const char* word : {"body 'square': 1 piece", "once", "per load step", "per iteration",
                           "about", "predicted    measured  trust", "exact"}) {
    CAPTURE(word, out.str());
    CHECK(out.str().find(word) != std::string::npos);
  }
}
