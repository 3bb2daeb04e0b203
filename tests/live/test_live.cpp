// What every live figure must do: answer all that its controls allow, with a certificate, and say what the programs of
// its chapter found.
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "catch_compat.hpp"
#include "live/figure.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/family.hpp"
#include "signorini/core/table.hpp"

using namespace live;

namespace {

std::string setting(const Control& control, double value) {
  return control.name + '=' +
         (control.choices.empty() ? signorini::shortest(value)
                                  : control.choices[static_cast<std::size_t>(value)]);
}

/// The figure as it begins, and each control alone at its ends, or at each of its choices.
std::vector<std::string> requests(const Figure& figure) {
  std::vector<std::string> all = {""};
  for (const Control& control : figure.controls) {
    if (control.choices.empty()) {
      all.push_back(setting(control, control.least));
      all.push_back(setting(control, control.most));
    }
    for (std::size_t k = 0; k < control.choices.size(); ++k)
      all.push_back(setting(control, static_cast<double>(k)));
  }
  return all;
}

bool same_bits(const VectorXd& a, const VectorXd& b) {  // not a number is the same as itself
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

const Number* find(const Answer& answer, const std::string& name) {
  for (const Number& number : answer.numbers)
    if (number.name == name) return &number;
  return nullptr;
}

void check_layer(const Layer& layer) {
  CHECK(layer.x.size() > 0);
  CHECK(layer.x.size() == layer.y.size());
  if (layer.corners > 0) CHECK(layer.x.size() == layer.corners * layer.value.size());
  if (layer.corners > 0) CHECK(layer.most > 0);
  if (layer.look == Look::Arrow) CHECK(layer.x.size() % 2 == 0);
}

bool is_points(Look look) {
  return look == Look::Closed || look == Look::Open || look == Look::Cross || look == Look::Here ||
         look == Look::Trail;
}

// Points that lie beyond the axes to the left or the right are left out on purpose, above or below only if the panel says so.
void check_window(const Panel& panel) {
  const std::vector<double>& w = panel.window;
  REQUIRE(w.size() == 4);
  CHECK(w[0] < w[1]);
  CHECK(w[2] < w[3]);
  if (panel.log_x) CHECK(w[0] > 0);
  if (panel.log_y) CHECK(w[2] > 0);
  if (panel.clips) return;
  for (const Layer& layer : panel.layers) {
    if (layer.corners > 0 || !is_points(layer.look)) continue;
    for (Index k = 0; k < layer.x.size(); ++k) {
      if (!(layer.x(k) >= w[0] && layer.x(k) <= w[1])) continue;
      INFO(layer.label << " at " << layer.x(k) << ' ' << layer.y(k) << ", axis to " << w[3]);
      CHECK_FALSE(layer.y(k) < w[2]);
      CHECK_FALSE(layer.y(k) > w[3]);
    }
  }
}

void check_answer(const Answer& answer) {
  CHECK_FALSE(answer.says.empty());
  CHECK_FALSE(answer.panels.empty());
  std::set<std::string> names;
  for (const Number& number : answer.numbers) {
    INFO(number.name);
    CHECK(names.insert(number.name).second);
    CHECK_FALSE(number.label.empty());
  }
  if (const Number* worst = find(answer, "certificate")) CHECK(worst->value <= 1e-12);
  for (const Panel& panel : answer.panels) {
    INFO(panel.title);
    CHECK_FALSE(panel.title.empty());
    CHECK_FALSE(panel.x_label.empty());
    CHECK_FALSE(panel.y_label.empty());
    CHECK_FALSE(panel.layers.empty());
    for (const Layer& layer : panel.layers) check_layer(layer);
    check_window(panel);
  }
}

/// Axes and scales of colours of all panels, as text.
std::string axes_of(const Answer& answer) {
  std::string all;
  for (const Panel& panel : answer.panels) {
    all += panel.title + (panel.log_x ? " log" : "") + (panel.log_y ? " log" : "");
    for (const double end : panel.window) all += ' ' + signorini::shortest(end);
    std::set<std::string> scales;  // a body may come and go
    for (const Layer& layer : panel.layers)
      if (layer.corners > 0)
        scales.insert(layer.label + ' ' + signorini::shortest(layer.least) + ' ' +
                      signorini::shortest(layer.most));
    for (const std::string& scale : scales) all += "; " + scale;
    all += '\n';
  }
  return all;
}

/// The numbers of all `.results` files of a chapter.
std::map<std::string, double> results_of(const std::filesystem::path& chapter) {
  std::map<std::string, double> results;
  for (const auto& file : std::filesystem::directory_iterator(chapter / "results")) {
    if (file.path().extension() != ".results") continue;
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::string name;
      double value = 0;
      if (words >> name >> value) results[name] = value;
    }
  }
  return results;
}

std::filesystem::path chapter_of(const std::string& figure) {
  for (const auto& chapter : std::filesystem::directory_iterator(SIGNORINI_CHAPTERS))
    if (std::filesystem::exists(chapter.path() / "live" / (figure + ".cpp"))) return chapter;
  return {};
}

}  // namespace

TEST_CASE("every live figure answers whatever its controls allow") {
  for (const Figure& figure : figures())
    for (const std::string& words : requests(figure)) {
      INFO(figure.name << ' ' << words);
      check_answer(figure.answer(Request(figure.controls, words)));
    }
}

TEST_CASE("axes and colours of a live figure stay while its controls move") {
  int moved = 0;
  for (const Figure& figure : figures()) {
    const std::string first = axes_of(figure.answer(Request(figure.controls, "")));
    for (const Control& control : figure.controls) {
      if (control.own_axes) continue;
      for (const double end : {control.least, control.most}) {
        INFO(figure.name << ' ' << setting(control, end));
        CHECK(axes_of(figure.answer(Request(figure.controls, setting(control, end)))) == first);
        ++moved;
      }
    }
  }
  CHECK(moved >= 20);
}

TEST_CASE("what is dragged or played in a live figure is a slider of it") {
  int dragged = 0, played = 0, asked = 0;
  for (const Figure& figure : figures()) {
    INFO(figure.name);
    for (const Control& control : figure.controls)
      if (control.plays) {
        CHECK(control.choices.empty());
        ++played;
      }
    for (const Panel& panel : figure.answer(Request(figure.controls, "")).panels) {
      asked += panel.question.empty() ? 0 : 1;
      for (const Drag& drag : panel.drag) {
        CHECK(signorini::find_member(figure.controls, drag.control, "control").choices.empty());
        ++dragged;
      }
    }
  }
  CHECK(dragged > 0);
  CHECK(played > 0);
  CHECK(asked >= 3);
}

TEST_CASE("a live figure says again what it said, whatever was asked in between") {
  for (const Figure& figure : figures()) {
    std::vector<VectorXd> first;
    std::vector<VectorXd> again;
    const std::string said = answer(figure.name, first);
    for (const std::string& words : requests(figure))
      (void)answer(figure.name + ' ' + words, again);
    INFO(figure.name);
    CHECK(answer(figure.name, again) == said);
    REQUIRE(first.size() == again.size());
    for (std::size_t k = 0; k < first.size(); ++k) CHECK(same_bits(first[k], again[k]));
  }
}

TEST_CASE("live figures find what the programs of their chapters found") {
  for (const Figure& figure : figures()) {
    if (figure.name == "hard") continue;  // below
    const std::filesystem::path chapter = chapter_of(figure.name);
    INFO(figure.name);
    REQUIRE_FALSE(chapter.empty());
    const std::map<std::string, double> results = results_of(chapter);
    std::ifstream in(chapter / "live" / (figure.name + ".checks"));
    REQUIRE(in);
    int checks = 0;
    for (std::string line; std::getline(in, line);) {
      if (line.empty() || line[0] == '#') continue;
      INFO(line);
      const std::size_t colon = line.find(':');
      REQUIRE(colon != std::string::npos);
      std::istringstream words(line.substr(colon + 1));
      std::string name;
      std::string equals;
      std::string wanted;
      double tolerance = 0;
      REQUIRE(words >> name >> equals >> wanted >> tolerance);
      const Answer answer = figure.answer(Request(figure.controls, line.substr(0, colon)));
      const Number* number = find(answer, name);
      REQUIRE(number != nullptr);
      REQUIRE(results.count(wanted) == 1);
      const double value = results.at(wanted);
      CHECK(std::abs(number->value - value) <= tolerance * std::abs(value));
      ++checks;
    }
    CHECK(checks > 0);
  }
}

// The chapter: at q = 2 both beams stand on their tips and the body, whose corner is dented, with two nodes.
TEST_CASE("the beam of chapter 6 lies where a beam that shears lies, not where its tip is dented") {
  const Figure& figure = signorini::find_member(figures(), "cantilever", "live figure");
  const auto says = [&](const char* load) {
    return figure.answer(Request(figure.controls, load)).says;
  };
  CHECK_THAT(says("load=0.2"), StartsWith("The beam hangs free."));
  CHECK(says("load=1") == "The beam stands on its tip.");
  CHECK(says("load=2") == "The beam stands on its tip, which is dented.");
  CHECK(says("load=3.6") == "The beam lies on its end.");
}

// A row of the table is `| room | exhibit | icon | icon ...`.
TEST_CASE("visitors of an exhibit get the verdicts of the chapter") {
  const Figure& figure = signorini::find_member(figures(), "hard", "live figure");
  const Control& exhibits = signorini::find_member(figure.controls, "exhibit", "control");
  std::map<std::string, std::string> rows;
  std::ifstream in(chapter_of("hard") / "results" / "museum.md");
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string bar;
    std::string room;
    std::string name;
    std::string icons;
    words >> bar >> room >> bar >> name >> bar;
    for (std::string icon; words >> icon >> bar;) icons += icon;
    rows[name] = icons;
  }
  for (const std::string& name : exhibits.choices) {
    const Answer answer = figure.answer(Request(figure.controls, "exhibit=" + name));
    std::string icons;
    for (std::size_t k = 1; k < answer.table.size(); ++k) icons += answer.table[k][0];
    INFO(name);
    CHECK(icons == rows[name]);
  }
}

TEST_CASE("a live figure refuses what it has no control for, in words") {
  std::vector<VectorXd> arrays;
  const auto error = [&arrays](const std::string& words) { return answer(words, arrays); };
  CHECK_THAT(error("cantilver"), ContainsSubstring("did you mean 'cantilever'?"));
  CHECK_THAT(error("cantilever lod=1"), ContainsSubstring("did you mean 'load'?"));
  CHECK_THAT(error("cantilever load=9"),
             ContainsSubstring("expected a number from 0.05 to 3.6, got '9'"));
  CHECK_THAT(error("cantilever load=1x"), ContainsSubstring("got '1x'"));
  CHECK_THAT(error("cantilever load"), ContainsSubstring("expected control=value"));
  CHECK_THAT(error("cantilever element=q9"), ContainsSubstring("did you mean"));
  CHECK(arrays.empty());
}
