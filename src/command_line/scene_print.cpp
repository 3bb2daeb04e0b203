#include "command_line/scene_print.hpp"

#include <cmath>
#include <ostream>

#include "command_line/contact_print.hpp"
#include "command_line/print.hpp"
#include "command_line/probe_print.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/fem/von_mises.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;

void print_title(std::ostream& out, const SceneRun& run) {
  out << run.file.name << (run.file.title.empty() ? "" : ": ") << run.file.title << "\n\n";
}

void print_status(std::ostream& out, const Solution& solution) {
  const Report& report = solution.contact.report;
  const std::string why = why_unsolved(solution);
  out << '\n'
      << (report.status == SolveStatus::Solved ? "solved" : "not solved: ")
      << (report.status == SolveStatus::Solved ? "" : to_string(report.status)) << " after "
      << report.iterations << (report.iterations == 1 ? " iteration" : " iterations")
      << (why.empty() ? "" : ": " + why) << '\n';
  if (std::isfinite(solution.certificate.worst()))
    out << "certificate: " << solution.certificate << '\n';
}

/// What became of a body, as far as a few numbers tell.
struct BodyFigures {
  std::string name;
  double moves = 0;                                       // farthest [length]
  Eigen::Vector2d at = Eigen::Vector2d::Zero();           // place of that node
  double stress = 0;                                      // largest von Mises' stress of a cell
  Eigen::Vector2d stressed_at = Eigen::Vector2d::Zero();  // first corner of that cell
  Eigen::Vector2d supports = Eigen::Vector2d::Zero();     // sum of their forces on the body
  Eigen::Vector2d springs = Eigen::Vector2d::Zero();      // and of the springs'
  bool axial = false;
  bool supported = false;
  bool on_springs = false;
};

std::vector<BodyFigures> figures_of(const Model& model, const Solution& solution) {
  std::vector<BodyFigures> all;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    const NodeArray& u = solution.displacements[b];
    BodyFigures figures;
    figures.name = body.mesh.name;
    const Farthest moved = farthest(u);
    figures.moves = moved.length;
    figures.at = body.mesh.nodes.row(moved.node);
    const StressArray stress = cell_stress(body.mesh, body.element, body.material, u);
    for (Index cell = 0; cell < stress.rows(); ++cell)
      if (const double now = von_mises(stress.row(cell).transpose()); now > figures.stress) {
        figures.stress = now;
        figures.stressed_at = body.mesh.nodes.row(body.mesh.cells(cell, 0));
      }
    figures.supports = sum_of_forces(body, support_forces(model, solution, b));
    figures.supported = (body.unknowns.number.array() < 0).any();
    figures.on_springs = body.springs.rows() > 0;
    if (figures.on_springs)
      figures.springs = sum_of_forces(body, spring_forces(model, solution, b));
    figures.axial = is_axial(body);
    all.push_back(figures);
  }
  return all;
}

void print_bodies(std::ostream& out, const Model& model, const Solution& solution) {
  for (const BodyFigures& body : figures_of(model, solution)) {
    out << "body '" << body.name << "': moves by up to " << body.moves << ", at (" << body.at.x()
        << ", " << body.at.y() << "); von Mises' stress up to " << body.stress
        << " in the mean of a cell, that at (" << body.stressed_at.x() << ", " << body.stressed_at.y() << ')';
    if (body.supported) out << "; supports bear " << force_in_words(body.supports, body.axial);
    if (body.on_springs)
      out << (body.supported ? ", springs " : "; springs bear ")
          << force_in_words(body.springs, body.axial);
    out << '\n';
  }
}

void write_lines(Json& json, const char* key, const std::vector<std::string>& lines) {
  json.key(key).array();
  for (const std::string& line : lines) json.value(line);
  json.end();
}

void write_point(Json& json, const char* key, const Eigen::Vector2d& point) {
  json.key(key).value(Eigen::VectorXd(point));
}

void write_plan(Json& json, const SceneRun& run) {
  json.key("plan").object();
  write_lines(json, "on", run.plan.on);
  write_lines(json, "off", run.plan.off);
  json.key("method").value(run.prediction.method);
  json.key("unknown").value(run.prediction.unknown);
  json.key("bodies").array();
  for (const BodySummary& body : run.prediction.bodies) {
    json.object().key("name").value(body.name).key("unknowns").value(body.unknowns);
    json.key("pieces").value(body.pieces);
    write_point(json, "load", body.force);
    json.key("moment").value(body.moment).end();
  }
  json.end().key("predicted").array();
  for (const PredictedFigure& figure : run.prediction.figures) {
    json.object().key("built").value(to_string(figure.frequency)).key("phase").value(figure.phase);
    json.key("what").value(figure.what).key("amount").value(figure.amount);
    json.key("trust").value(to_string(figure.certainty)).end();
  }
  json.end().end();
}

void write_bodies(Json& json, const Model& model, const Solution& solution) {
  json.key("bodies").array();
  for (const BodyFigures& body : figures_of(model, solution)) {
    json.object().key("name").value(body.name).key("moves").value(body.moves);
    write_point(json, "at", body.at);
    json.key("stress").value(body.stress);
    write_point(json, "stressed_at", body.stressed_at);
    write_point(json, "supports", body.supports);
    if (body.on_springs) write_point(json, "springs", body.springs);
    json.end();
  }
  json.end();
}

}  // namespace

void print_head(std::ostream& out, const SceneRun& run) {
  print_title(out, run);
  signorini::print(out, run.plan, run.notes());
}

void print_plan(std::ostream& out, const SceneRun& run) {
  print_head(out, run);
  out << '\n' << run.prediction;
}

void print_result(std::ostream& out, const SceneRun& run) {
  print_bodies(out, *run.model, *run.solution);
  print_bonds(out, *run.model, *run.solution);
  if (run.solution->pressure.size() > 0)
    print_contacts(out, *run.model, *run.solution, run.state());
  print_probes(out, run);
}

void print_solution(std::ostream& out, const SceneRun& run) {
  print_head(out, run);
  print_status(out, *run.solution);
  if (run.solved()) print_result(out, run);
  out << '\n' << run.solution->ledger << '\n' << compare(run.prediction, run.ledgers);
}

void write_ledger(Json& json, const char* key, const Ledger& ledger) {
  json.key(key).array();
  for (const LedgerEntry& entry : ledger.entries()) {
    json.object().key("phase").value(entry.path).key("seconds").value(entry.seconds);
    json.key("calls").value(static_cast<Index>(entry.calls));
    json.key("bytes").value(static_cast<Index>(entry.bytes));
    for (const auto& [what, amount] : entry.counts)
      json.key(what).value(static_cast<Index>(amount));
    json.end();
  }
  json.end();
}

void write_head(Json& json, const SceneRun& run) {
  json.key("file").value(run.file.name).key("title").value(run.file.title);
  write_plan(json, run);
}

void write_result(Json& json, const Model& model, const Solution& solution,
                  const std::vector<Probe>& probes, const PathState* state) {
  const bool solved = solution.contact.report.status == SolveStatus::Solved;
  write_lines(json, "notes", solution.notes);
  json.key("solved").value(solved);
  json.key("solver").value(model.solver.name);
  json.key("status").value(to_string(solution.contact.report.status));
  json.key("reason").value(why_unsolved(solution));
  if (solution.limit) json.key("limit").value(*solution.limit);
  json.key("iterations").value(solution.contact.report.iterations);
  json.key("certificate");
  write(json, solution.certificate);
  if (solved) {
    write_contacts(json, model, solution, state);
    write_bodies(json, model, solution);
    write_bonds(json, model, solution);
    write_probes(json, probes, model, solution, state);
  }
  write_ledger(json, "ledger", solution.ledger);
}

void write_keys(Json& json, const SceneRun& run) {
  write_head(json, run);
  if (run.solution)
    write_result(json, *run.model, *run.solution, run.file.probes, run.state());
  else
    write_lines(json, "notes", run.notes());
}

void write(Json& json, const SceneRun& run) {
  begin_document(json, run.solution ? "solution" : "plan");
  write_keys(json, run);
  json.end();
}

}  // namespace command_line
