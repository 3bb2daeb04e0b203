#include "command_line/scene_print.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>

#include "command_line/print.hpp"
#include "signorini/core/table.hpp"
#include "signorini/elasticity/stress.hpp"
#include "signorini/report/pressure_table.hpp"
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
      << (report.status == Status::Solved ? "solved" : "not solved: ")
      << (report.status == Status::Solved ? "" : to_string(report.status)) << " after "
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
  bool on_springs = false;
};

std::vector<BodyFigures> figures_of(const Model& model, const Solution& solution) {
  std::vector<BodyFigures> all;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    const NodeArray& u = solution.displacements[b];
    BodyFigures figures;
    figures.name = body.mesh.name;
    Index node = 0;
    figures.moves = u.rowwise().norm().maxCoeff(&node);
    figures.at = body.mesh.nodes.row(node);
    const StressArray stress = cell_stress(body.mesh, body.element, body.material, u);
    for (Index cell = 0; cell < stress.rows(); ++cell)
      if (const double now = von_mises(stress.row(cell).transpose()); now > figures.stress) {
        figures.stress = now;
        figures.stressed_at = body.mesh.nodes.row(body.mesh.cells(cell, 0));
      }
    figures.supports = support_forces(model, solution, b).colwise().sum();
    figures.on_springs = body.springs.rows() > 0;
    if (figures.on_springs) figures.springs = spring_forces(model, solution, b).colwise().sum();
    figures.axial = body.material.bulk.state == PlaneState::Axial;
    all.push_back(figures);
  }
  return all;
}

/// A force; what pushes along the radius all round the axis has no sum.
std::string force_in_words(const Eigen::Vector2d& force, bool axial) {
  return axial ? text(force.y(), " along the axis") : text('(', force.x(), ", ", force.y(), ')');
}

void print_bodies(std::ostream& out, const Model& model, const Solution& solution) {
  for (const BodyFigures& body : figures_of(model, solution)) {
    out << "body '" << body.name << "': moves by up to " << body.moves << ", at (" << body.at.x()
        << ", " << body.at.y() << "); von Mises' stress up to " << body.stress
        << ", in the cell at (" << body.stressed_at.x() << ", " << body.stressed_at.y()
        << "); supports bear " << force_in_words(body.supports, body.axial);
    if (body.on_springs) out << ", springs " << force_in_words(body.springs, body.axial);
    out << '\n';
  }
}

/// Pairs that are closed, if they are few.
void print_pressures(std::ostream& out, const Pairs& pairs, const Solution& solution) {
  const std::vector<Index>& active = solution.contact.active;
  const Index closed = static_cast<Index>(active.size());
  out << closed << " of " << solution.pressure.size() << " pairs are closed\n";
  if (closed == 0) return;
  if (closed > largest_printed) {
    out << "more than " << largest_printed << " are not printed: --csv FILE writes them\n";
    return;
  }
  const auto cell = [&](double value) { out << std::setw(14) << number(value, "%.6g"); };
  out << '\n';
  for (const char* name : {"x", "y", "pressure", "force"}) out << std::setw(14) << name;
  out << '\n';
  for (const Index pair : active) {
    cell(pairs.position(pair, 0));
    cell(pairs.position(pair, 1));
    cell(solution.pressure(pair));
    cell(solution.contact.force(pair));
    out << '\n';
  }
}

void print_resultants(std::ostream& out, const Model& model, const Solution& solution) {
  const Resultants sum = resultants(model.pairs, solution);
  const bool axial = model.bodies[0].material.bulk.state == PlaneState::Axial;
  out << "contact: force on the sources " << force_in_words(sum.force, axial);
  if (!axial) out << ", moment about the origin " << sum.moment;
  out << ", closed boundary " << sum.closed_weight << ", peak pressure " << sum.peak_pressure
      << '\n';
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
  json.key("bodies").array();
  for (const BodySummary& body : run.prediction.bodies) {
    json.object().key("name").value(body.name).key("unknowns").value(body.unknowns);
    json.key("pieces").value(body.pieces);
    write_point(json, "load", body.force);
    json.key("moment").value(body.moment).end();
  }
  json.end().key("predicted").array();
  for (const PredictedFigure& figure : run.prediction.figures) {
    json.object().key("built").value(to_string(figure.built)).key("phase").value(figure.phase);
    json.key("what").value(figure.what).key("amount").value(figure.amount);
    json.key("trust").value(to_string(figure.trust)).end();
  }
  json.end().end();
}

void write_pairs(Json& json, const Pairs& pairs, const Solution& solution) {
  const ContactState& contact = solution.contact;
  Eigen::VectorXd closed = Eigen::VectorXd::Zero(contact.force.size());
  for (const Index pair : contact.active) closed(pair) = 1;
  json.key("pairs").object();
  json.key("x").value(Eigen::VectorXd(pairs.position.col(0)));
  json.key("y").value(Eigen::VectorXd(pairs.position.col(1)));
  json.key("gap").value(contact.gap).key("pressure").value(solution.pressure);
  json.key("force").value(contact.force).key("closed").value(closed);
  if (!contact.rubbing.empty()) {
    Eigen::VectorXd rubbing(static_cast<Index>(contact.rubbing.size()));
    std::copy(contact.rubbing.begin(), contact.rubbing.end(), rubbing.data());
    json.key("rubbing").value(rubbing).key("friction").value(contact.friction);
    json.key("slip").value(contact.slip);
  }
  json.end();
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

void write_ledger(Json& json, const Ledger& ledger) {
  json.key("ledger").array();
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

}  // namespace

void print_plan(std::ostream& out, const SceneRun& run) {
  print_title(out, run);
  signorini::print(out, run.plan, run.notes());
  out << '\n' << run.prediction;
}

void print_solution(std::ostream& out, const SceneRun& run) {
  print_title(out, run);
  signorini::print(out, run.plan, run.notes());
  print_status(out, *run.solution);
  if (run.solved()) print_bodies(out, *run.model, *run.solution);
  if (run.solved() && run.solution->pressure.size() > 0) {
    print_resultants(out, *run.model, *run.solution);
    print_pressures(out, run.model->pairs, *run.solution);
  }
  out << '\n' << run.solution->ledger << '\n' << confront(run.prediction, run.solution->ledger);
}

void write(Json& json, const SceneRun& run) {
  json.object().key("file").value(run.file.name).key("title").value(run.file.title);
  write_plan(json, run);
  write_lines(json, "notes", run.notes());
  if (run.solution) {
    const Solution& solution = *run.solution;
    json.key("solved").value(run.solved());
    json.key("solver").value(run.plan.solver);
    json.key("status").value(to_string(solution.contact.report.status));
    json.key("reason").value(why_unsolved(solution));
    if (solution.limit) json.key("limit").value(*solution.limit);
    json.key("iterations").value(solution.contact.report.iterations);
    json.key("certificate");
    write(json, solution.certificate);
    if (run.solved()) {
      const Resultants sum = resultants(run.model->pairs, solution);
      json.key("resultants").object();
      write_point(json, "force", sum.force);
      json.key("moment").value(sum.moment).key("closed").value(sum.closed_weight);
      json.key("peak_pressure").value(sum.peak_pressure).end();
      write_bodies(json, *run.model, solution);
      write_pairs(json, run.model->pairs, solution);
    }
    write_ledger(json, solution.ledger);
  }
  json.end();
}

}  // namespace command_line
