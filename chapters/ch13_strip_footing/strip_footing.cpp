// Chapter 13 - The rigid strip footing (Lin et al., sec. 3.3).
// Run:  make ch13     Reads: nothing     Writes: ch13.results, nodes.md, meshes.md, edge.md, sides.md,
//                                                domain.md, thickness.md, plate.md, data of figures 13.1 to 13.4
#include <cmath>
#include <tuple>

#include "drawings.hpp"
#include "studies.hpp"

namespace {

using namespace ch13;

// 1. Three meshes: that of the paper in number of nodes, and two for a soil that is wider and deeper.
// [meshes]
const EdgeBlockSpec coarse = soil_of(7, 9, 5, /*grading*/ 4, /*far*/ 15);
const EdgeBlockSpec medium = soil_of(30, 40, 34, 64, 60);
const EdgeBlockSpec fine = soil_of(60, 72, 66, 64, 60);
// [meshes]

// 2. Forces of the nodes against (46), node by node.
void nodal_forces(const ProgramOptions& run, Results& results) {
  Table nodes({"x [m]", "force [kN/m]", "(46) [kN/m]", "deviation [%]"});
  Table meshes({"nodes", "W = H [m]", "elastic footing [%]", "rigid footing [%]", "corner node [%]",
                "next to it [%]"});
  for (const auto& [soil, rows] : {std::pair(coarse, 4), {medium, 12}, {fine, 16}}) {
    const SolvedScene now = settle(soil, {2, rows});
    const Base base = base_of(now);
    const VectorXd off = base.deviation();
    const Index n = off.size(), all = soil.n_nodes() + n * (rows + 1);
    const double rigid = rigid_base(soil).worst();
    meshes.row({std::to_string(all), number(soil.depth), percent(base.worst()), percent(rigid),
                percent(off(n - 1)), percent(off(n - 2))});
    const double resultant = std::abs(base.force.sum() / (q * a) - 1);
    if (resultant > 1e-12) throw NotSolved("the forces do not add up to the load");
    const std::string name = text("fig_13_2", soil.depth == coarse.depth ? "_142" : "", ".csv");
    write_file(run.out / name, table_of({{"x", base.position},
                                         {"pressure", base.pressure() / q},
                                         {"from_edge", a - base.piece.array()},
                                         {"deviation", 100 * off}})
                                   .csv("rel 1e-6 abs 1e-6"));
    results.add(text("worst_", all), 100 * base.worst(), "%");
    results.add(text("worst_rigid_", all), 100 * rigid, "%");
    results.add(text("corner_", all), 100 * off(n - 1), "%");
    if (soil.depth != coarse.depth) continue;
    for (Index k = 0; k < n; ++k)
      nodes.row({number(base.position(k), "%.3f"), number(base.force(k), "%.4f"),
                 number(base.share(k), "%.4f"), percent(off(k))});
    results.add("corner_pressure", now.solution.pressure.maxCoeff() / q, "q");
    results.add("settlement", 1000 * base.settlement, "mm");
  }
  write_file(run.out / "nodes.md", nodes.markdown());
  write_file(run.out / "meshes.md", meshes.markdown());
}

// 3. A stiffer and stiffer footing against the one that cannot deform, on the same soil.
void stiff_footing(Results& results) {
  // [stiff]
  const Base rigid = rigid_base(coarse);
  for (int power = 0; power <= 12; power += 3) {
    FootingSpec spec;
    spec.modulus = soil_modulus * std::pow(10, power);
    const SolvedScene now = settle(coarse, spec);
    const double off = (base_of(now).force - rigid.force).norm() / rigid.force.norm();
    results.add(text("stiff_", power), off, "-", power < 9 ? Repeats::Yes : Repeats::No);
    // [stiff]
    if (power >= 3 && std::abs(off * std::pow(10, power) - 1.32) > 0.01)
      throw NotSolved("the footing does not become rigid as one over its modulus");
  }
}

// 4. Halving every cell: the pressure of the corner has no limit, its share of the force has one.
void refine_the_edge(const ProgramOptions& run, Results& results) {
  Table table({"cells under", "nodes", "worst, x ≤ 0.8 a [%]", "corner force [%]", "corner",
               "next to it", "standard, corner", "standard, next to it"});
  for (const Index k : {1, 2, 4, 8}) {
    const EdgeBlockSpec soil = soil_of(8 * k, 10 * k, 9 * k, 4, 60);
    const Base base = rigid_base(soil);
    const Index n = base.force.size();
    const VectorXd dual = base.pressure() / q, standard = standard_pressure(base) / q;
    const double corner = base.deviation()(n - 1);
    table.row({std::to_string(8 * k), std::to_string(soil.n_nodes()), percent(base.worst()),
               percent(corner), number(dual(n - 1), "%.1f"), number(dual(n - 2), "%.1f"),
               number(standard(n - 1), "%.1f"), number(standard(n - 2), "%.2f")});
    results.add(text("edge_pressure_", k), dual(n - 1), "q");
    results.add(text("edge_force_", k), 100 * corner, "%");
    results.add(text("edge_worst_", k), 100 * base.worst(), "%");
  }
  write_file(run.out / "edge.md", table.markdown());
}

// 5. Who carries the forces, and by which operator, if the meshes do not match.
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
  write_file(run.out / "sides.md", table.markdown());
  const SolvedScene matching = settle(coarse, {});
  results.add("overhang", static_cast<double>(matching.model.pairs.unpaired.size()), "-");
}

// 6. The paper's points of integration, two on every edge, that carry forces of their own. The corner node
// hears only of the last two: what they may carry follows from the forces of the last two nodes.
// [points]
void points(Results& results) {
  Scene scene = on_soil(coarse, {});
  scene.contacts.front().gap_operator = "gauss_points";
  scene.solver = "quasi_active_set";  // does not mind gaps that depend on each other
  const SolvedScene now = solved(scene, "the footing on points");
  const Base nodal = base_of(settle(coarse, {})), base = base_of(now);
  const Index n = nodal.force.size();
  const double outer = (1 + std::sqrt(1 / 3.0)) / 2, inner = 1 - outer;  // places on the edge
  const double corner = nodal.force(n - 1), next = nodal.force(n - 2);
  const double most = corner / outer;  // the inner point carries nothing
  const double least = (outer * corner - inner * next) / (outer * outer - inner * inner);
  // [points]
  const double weight = nodal.width(n - 1);  // of a point: half of the edge
  const double there = now.solution.pressure.maxCoeff() * weight;
  if ((base.force - nodal.force).norm() > 1e-12 * nodal.force.norm() || there > most + 1e-9 ||
      there < least - 1e-9)
    throw NotSolved("the points push the soil in another way than the nodes");
  results.add("points", static_cast<double>(now.solution.pressure.size()), "-");
  results.add("points_nodes", static_cast<double>(n), "-");
  results.add("points_least", least / weight / q, "q");
  results.add("points_most", most / weight / q, "q");
  results.add("points_inner_most", (corner - outer * least) / inner / weight / q, "q");
  const double h = 2 * weight;
  results.add("points_closed_form", rigid_strip_pressure(strip, a - inner * h) / q, "q");
  results.add("points_inner_closed_form", rigid_strip_pressure(strip, a - outer * h) / q, "q");
  results.add("points_pressed", static_cast<double>(now.solution.contact.active.size()), "-",
              Repeats::No);
}

Status chapter(const ProgramOptions& run) {
  Results results("ch13");
  nodal_forces(run, results);
  stiff_footing(results);
  refine_the_edge(run, results);
  sides(run, results);
  points(results);
  domain(run, results);
  thickness(run, results);
  stress(results);
  edge_stress(settle(coarse, {}), results);
  draw(run.out, settle(coarse, {}), settle(soil_of(10, 14, 14, 4, 15), {2, 6}));
  results.headline("middle_40", 1, "(46)");
  results.print();
  results.write(run.out);
  return Status::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return signorini::run_program("ch13", "The rigid strip footing", SIGNORINI_CHAPTER_OUT, argc,
                                argv, chapter);
}
