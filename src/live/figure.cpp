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

Control playing(Control slider) {
  slider.plays = true;
  return slider;
}

Control with_own_axes(Control control) {
  control.own_axes = true;
  return control;
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

std::vector<Index> closed_pairs(const signorini::ContactState& contact, bool slide) {
  std::vector<Index> found;
  for (const Index i : contact.active())
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
  const std::vector<Index> closed = contact.active();
  count("closed", "closed pairs", static_cast<Index>(closed.size()));
  count("pairs", "pairs", contact.force.size());
  count("iterations", "iterations", contact.report.iterations);
  rounding("certificate", "certificate, its worst entry", solved.certificate.worst());
  if (determined) sets.push_back({"closed", {closed.begin(), closed.end()}});
  if (determined &&
      contact.friction.size() == contact.force.size()) {
    sets.push_back({"stick", closed_pairs(contact, false)});
    sets.push_back({"slide", closed_pairs(contact, true)});
  }
  for (std::string note : solved.notes) {  // sentences of the library begin small and end open
    if (!note.empty())
      note[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(note[0])));
    notes += (notes.empty() ? "" : " ") + note + (!note.empty() && note.back() == '.' ? "" : ".");
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
    json.key("plays").value(control.plays).key("own_axes").value(control.own_axes);
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
    case Look::Arrow:
      return "arrow";
    case Look::Solid:
      return "solid";
    case Look::Trail:
      return "trail";
  }
  return "line";
}

void write(const Layer& layer, Json& json, std::vector<VectorXd>& arrays) {
  const auto place = [&arrays](const VectorXd& values) {
    arrays.push_back(values);
    return static_cast<Index>(arrays.size() - 1);
  };
  json.object().key("label").value(layer.label).key("look").value(name_of(layer.look));
  json.key("x").value(place(layer.x)).key("y").value(place(layer.y));
  json.key("corners").value(layer.corners).key("varies").value(layer.varies);
  if (layer.look == Look::Trail) json.key("series").value(layer.series);
  if (layer.corners > 0) {
    json.key("value").value(place(layer.value)).key("mesh").value(layer.mesh);
    json.key("least").value(layer.least).key("most").value(layer.most);
  }
  json.end();
}

void write(const Panel& panel, Json& json, std::vector<VectorXd>& arrays) {
  json.object().key("title").value(panel.title).key("question").value(panel.question);
  json.key("x").value(panel.x_label).key("y").value(panel.y_label);
  json.key("equal").value(panel.equal).key("log_x").value(panel.log_x);
  json.key("log_y").value(panel.log_y).key("whole_x").value(panel.whole_x);
  json.key("whole_y").value(panel.whole_y).key("window").array();
  for (const double edge : panel.window) json.value(edge);
  json.end().key("grab").value(panel.grab).key("drag").array();
  for (const Drag& drag : panel.drag) {
    json.object().key("control").value(drag.control).key("x").value(drag.x);
    json.key("y").value(drag.y).key("from").value(drag.from).end();
  }
  json.end().key("layers").array();
  for (const Layer& layer : panel.layers) write(layer, json, arrays);
  json.end().end();
}

void write(const Answer& answer, Json& json, std::vector<VectorXd>& arrays) {
  json.key("says").value(answer.says).key("notes").value(answer.notes).key("numbers").array();
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
