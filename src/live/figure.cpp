#include "live/figure.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>

#include "addons/files/json.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/family.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"

namespace live {

using signorini::Json;
using signorini::require_input;

Control slider(std::string name, std::string label, double value, double least, double most,
               double step) {
  return {std::move(name), std::move(label), value, least, most, step};
}

Control choice(std::string name, std::string label, const std::string& value,
               std::vector<std::string> choices) {
  const auto at = std::find(choices.begin(), choices.end(), value);
  signorini::require_argument(at != choices.end(), "choice: ", name, " has no choice ", value);
  const auto place = static_cast<double>(at - choices.begin());
  const auto last = static_cast<double>(choices.size() - 1);
  return {std::move(name), std::move(label), place, 0, last, 1, std::move(choices)};
}

Control toggle(std::string name, std::string label, bool on) {
  return choice(std::move(name), std::move(label), on ? "on" : "off", {"off", "on"});
}

Request::Request(const std::vector<Control>& controls, const std::string& words) {
  for (const Control& control : controls) {
    values_[control.name] = control.value;
    choices_[control.name] = control.choices;
  }
  std::istringstream in(words);
  for (std::string word; in >> word;) {
    const std::size_t equals = word.find('=');
    require_input(equals != std::string::npos, "expected control=value, got '", word, "'");
    const std::string value = word.substr(equals + 1);
    const Control& control = signorini::find_member(controls, word.substr(0, equals), "control");
    const auto at = std::find(control.choices.begin(), control.choices.end(), value);
    double number = static_cast<double>(at - control.choices.begin());
    if (control.choices.empty()) {
      std::istringstream digits(value);
      digits >> number;
      require_input(digits && digits.eof() && number >= control.least && number <= control.most,
                    control.name, ": expected a number from ", control.least, " to ", control.most,
                    ", got '", value, "'");
    } else {
      require_input(at != control.choices.end(), control.name, ": unknown choice '", value, "'",
                    signorini::suggestion(value, control.choices));
    }
    values_[control.name] = number;
  }
}

Index Request::whole(const std::string& name) const { return std::lround(values_.at(name)); }

const std::string& Request::chosen(const std::string& name) const {
  return choices_.at(name).at(static_cast<std::size_t>(whole(name)));
}

std::string Request::key(const std::vector<std::string>& without) const {
  std::string words;
  for (const auto& [name, value] : values_)
    if (std::find(without.begin(), without.end(), name) == without.end())
      words += name + '=' + signorini::shortest(value) + ' ';
  return words;
}

void Panel::curve(std::string label, Look look, const VectorXd& x, const VectorXd& y) {
  layers.push_back({std::move(label), look, x, y, 0, {}});
}

void Panel::points(const std::string& label, const VectorXd& x, const VectorXd& y,
                   const VectorXd& pressure, const char* some, const char* none) {
  for (const bool closed : {false, true}) {
    std::vector<Index> at;
    for (Index k = 0; k < x.size(); ++k)
      if ((pressure(k) > 0) == closed) at.push_back(k);
    if (!at.empty())
      curve(label + ", " + (closed ? some : none), closed ? Look::Closed : Look::Open, x(at),
            y(at));
  }
}

void Panel::motions(const VectorXd& x, const VectorXd& y, const signorini::ContactState& contact) {
  for (const bool slide : {false, true}) {
    const std::vector<Index> at = closed_pairs(contact, slide);
    if (!at.empty())
      curve(slide ? "slides" : "sticks", slide ? Look::Open : Look::Closed, x(at), y(at));
  }
}

void Panel::cells(std::string label, const MatrixXd& corner,
                  const Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic>& cell,
                  const VectorXd& value) {
  Layer layer{std::move(label), Look::Line, {}, {}, cell.cols(), value};
  layer.x.resize(cell.size());
  layer.y.resize(cell.size());
  for (Index k = 0, n = 0; k < cell.rows(); ++k)
    for (Index c = 0; c < cell.cols(); ++c, ++n) {
      layer.x(n) = corner(cell(k, c), 0);
      layer.y(n) = corner(cell(k, c), 1);
    }
  layers.push_back(std::move(layer));
}

void Panel::map(std::string label, const VectorXd& x, const VectorXd& y,
                const std::function<double(double, double)>& value) {
  const Index columns = x.size() - 1;
  const Index rows = y.size() - 1;
  Layer layer{std::move(label),
              Look::Line,
              VectorXd(4 * columns * rows),
              VectorXd(4 * columns * rows),
              4,
              VectorXd(columns * rows)};
  for (Index i = 0, n = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j, ++n) {
      layer.x.segment<4>(4 * n) << x(j), x(j + 1), x(j + 1), x(j);
      layer.y.segment<4>(4 * n) << y(i), y(i), y(i + 1), y(i + 1);
      layer.value(n) = value((x(j) + x(j + 1)) / 2, (y(i) + y(i + 1)) / 2);
    }
  layers.push_back(std::move(layer));
}

void Panel::level_lines(std::string label, Look look, const VectorXd& x, const VectorXd& y,
                        const std::function<double(double, double)>& value,
                        const std::vector<double>& levels) {
  using Eigen::Vector3d;
  MatrixXd values(y.size(), x.size());
  for (Index i = 0; i < y.size(); ++i)
    for (Index j = 0; j < x.size(); ++j) values(i, j) = value(x(j), y(i));
  std::vector<Vector3d> ends;  // of pieces: a line enters and leaves each triangle that it meets
  const auto corner = [&](Index j, Index i) { return Vector3d(x(j), y(i), values(i, j)); };
  const auto edge = [&ends](double level, const Vector3d& a, const Vector3d& b) {
    if ((a.z() > level) != (b.z() > level))
      ends.push_back(a + (level - a.z()) / (b.z() - a.z()) * (b - a));
  };
  for (const double level : levels)
    for (Index i = 0; i + 1 < y.size(); ++i)
      for (Index j = 0; j + 1 < x.size(); ++j)
        for (const Index upper : {0, 1}) {
          const Vector3d a = corner(j, i);
          const Vector3d b = corner(j + 1, i + 1);
          const Vector3d c = corner(j + 1 - upper, i + upper);
          edge(level, a, b);
          edge(level, b, c);
          edge(level, c, a);
        }
  if (ends.empty()) return;
  const double none = std::numeric_limits<double>::quiet_NaN();
  VectorXd at_x = VectorXd::Constant(static_cast<Index>(3 * ends.size() / 2), none);
  VectorXd at_y = at_x;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const auto place = static_cast<Index>(k + k / 2);  // a break after each piece
    at_x(place) = ends[k].x();
    at_y(place) = ends[k].y();
  }
  curve(std::move(label), look, at_x, at_y);
}

void Panel::body(const signorini::BodyModel& body, const signorini::NodeArray& displacement,
                 const signorini::NodeArray& place) {
  const signorini::StressArray stress =
      signorini::cell_stress(body.mesh, body.element, body.material, displacement);
  VectorXd mises(stress.rows());
  for (Index k = 0; k < stress.rows(); ++k) mises(k) = signorini::von_mises(stress.row(k));
  Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic> corners(body.mesh.n_cells(), 4);
  for (Index k = 0; k < body.mesh.n_cells(); ++k)
    for (Index c = 0; c < 4; ++c)
      corners(k, c) = body.mesh.cells(k, std::min<Index>(c, body.mesh.corners(k) - 1));
  cells(body.mesh.name + ", von Mises's stress", place, corners, mises);
}

void Panel::bodies(const signorini::Model& model, const signorini::Solution& solution,
                   double magnified) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const signorini::NodeArray& u = solution.displacements[b];
    body(model.bodies[b], u, model.bodies[b].mesh.nodes + magnified * u);
  }
}

std::vector<Index> closed_pairs(const signorini::ContactState& contact, bool slide) {
  std::vector<Index> found;
  for (const Index i : contact.active)
    if ((contact.contact_status[static_cast<std::size_t>(i)] != signorini::ContactStatus::Stick) ==
        slide)
      found.push_back(i);
  return found;
}

void Answer::number(std::string name, std::string label, double value, std::string unit,
                    const char* format) {
  numbers.push_back({std::move(name), std::move(label), value, std::move(unit), format});
}

void Answer::rounding(std::string name, std::string label, double value, std::string unit) {
  number(std::move(name), std::move(label), value, std::move(unit), "%.1e");
  numbers.back().varies = true;
}

void Answer::solution(const signorini::Solution& solved, bool determined) {
  const signorini::ContactState& contact = solved.contact;
  const auto count = [&](const char* name, const char* label, Index value) {
    number(name, label, static_cast<double>(value), "", "%.0f");
    numbers.back().varies = !determined;
  };
  count("closed", "closed pairs", static_cast<Index>(contact.active.size()));
  count("pairs", "pairs", contact.force.size());
  count("iterations", "iterations", contact.report.iterations);
  rounding("certificate", "certificate, its worst entry", solved.certificate.worst());
  if (determined) sets.push_back({"closed", {contact.active.begin(), contact.active.end()}});
  if (determined &&
      contact.contact_status.size() == static_cast<std::size_t>(contact.force.size())) {
    sets.push_back({"stick", closed_pairs(contact, false)});
    sets.push_back({"slide", closed_pairs(contact, true)});
  }
  for (std::string note : solved.notes) {  // sentences of the library begin small and end open
    if (!note.empty())
      note[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(note[0])));
    says += " " + note + (!note.empty() && note.back() == '.' ? "" : ".");
  }
}

Loaded::Loaded(const signorini::Scene& scene, signorini::Ledger ledger)
    : model(signorini::build(scene, ledger)), path(signorini::condense_path(model, ledger)) {}

signorini::Solution Loaded::at(double time) {
  signorini::Step step = signorini::step({}, time, model, path, {});
  signorini::require_solved(step.solution, "the scene");
  return std::move(step.solution);
}

signorini::SolvedScene Loaded::scene_at(double time) {
  signorini::Solution solution = at(time);
  return {model, path.condensed, std::move(solution)};
}

namespace {

void describe(const Figure& figure, Json& json) {
  json.key("title").value(figure.title).key("controls").array();
  for (const Control& control : figure.controls) {
    json.object().key("name").value(control.name).key("label").value(control.label);
    json.key("value").value(control.value).key("least").value(control.least);
    json.key("most").value(control.most).key("step").value(control.step);
    if (!control.choices.empty()) json.key("choices").value(control.choices);
    json.end();
  }
  json.end();
}

const char* name_of(Look look) {
  switch (look) {
    case Look::Line:
      return "line";
    case Look::Dashed:
      return "dashed";
    case Look::Dotted:
      return "dotted";
    case Look::Closed:
      return "closed";
    case Look::Open:
      return "open";
    case Look::Cross:
      return "cross";
    case Look::Here:
      return "here";
  }
  return "line";
}

void write(const Panel& panel, Json& json, std::vector<VectorXd>& arrays) {
  const auto place = [&arrays](const VectorXd& values) {
    arrays.push_back(values);
    return static_cast<Index>(arrays.size() - 1);
  };
  json.object()
      .key("title")
      .value(panel.title)
      .key("x")
      .value(panel.x_label)
      .key("y")
      .value(panel.y_label);
  json.key("equal").value(panel.equal).key("log_x").value(panel.log_x);
  json.key("log_y").value(panel.log_y).key("window").array();
  for (const double edge : panel.window) json.value(edge);
  json.end().key("drag_x").value(panel.drag_x).key("drag_y").value(panel.drag_y);
  json.key("layers").array();
  for (const Layer& layer : panel.layers) {
    json.object().key("label").value(layer.label).key("look").value(name_of(layer.look));
    json.key("x").value(place(layer.x)).key("y").value(place(layer.y));
    json.key("corners").value(layer.corners);
    if (layer.corners > 0) json.key("value").value(place(layer.value));
    json.end();
  }
  json.end().end();
}

void write(const Answer& answer, Json& json, std::vector<VectorXd>& arrays) {
  json.key("says").value(answer.says).key("numbers").array();
  for (const Number& number : answer.numbers) {
    json.object().key("name").value(number.name).key("label").value(number.label);
    json.key("value").value(number.value).key("unit").value(number.unit);
    json.key("varies").value(number.varies);
    json.key("text").value(signorini::number(number.value, number.format)).end();
  }
  json.end().key("sets").object();
  for (const Set& set : answer.sets) {
    json.key(set.name).array();
    for (const Index member : set.members) json.value(member);
    json.end();
  }
  json.end().key("panels").array();
  for (const Panel& panel : answer.panels) write(panel, json, arrays);
  json.end().key("table").array();
  for (const std::vector<std::string>& row : answer.table) json.value(row);
  json.end();
}

}  // namespace

std::string answer(const std::string& words, std::vector<VectorXd>& arrays) {
  arrays.clear();
  std::istringstream in(words);
  std::string name;
  std::string rest;
  in >> name;
  const bool only_told = name == "figure";
  if (only_told) in >> name;
  std::getline(in, rest);
  try {
    const Figure& figure = signorini::find_member(figures(), name, "live figure");
    Json json;
    json.object();
    if (only_told)
      describe(figure, json);
    else
      write(figure.answer(Request(figure.controls, rest)), json, arrays);
    return json.end().text();
  } catch (const std::exception& error) {
    arrays.clear();
    return Json().object().key("error").value(error.what()).end().text();
  }
}

}  // namespace live
