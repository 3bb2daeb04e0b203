// Live figure of chapter 17: pick an exhibit, see who solves it, who refuses it and who is refuted.
#include "../tour.hpp"
#include "live/exhibits.hpp"
#include "live/figure.hpp"

namespace live {
namespace {

using museum::Verdict;

museum::Case opened(const std::string& name) {
  for (const auto& [file, content] : exhibits)
    if (std::filesystem::path(file).stem() == name)
      return museum::open(museum::read_exhibit(file, content));
  throw signorini::ProblemError("no exhibit " + name);
}

museum::Answer asked(const museum::Case& given, const std::string& visitor) {
  return visitor == "ours" ? museum::ours(given) : museum::naive_answer(visitor, given);
}

std::string words(Verdict verdict, const museum::Exhibit& exhibit, const museum::Answer& said) {
  if (verdict == Verdict::NotFor) return "does not take such problems";
  if (verdict == Verdict::Honest) return said.said;
  if (verdict == Verdict::Solved) return "certified, within all bounds";
  if (!said.certificate.holds(museum::accepted))
    return "claims a solution, its certificate refutes it";
  const std::string broken = museum::broken_bound(exhibit, said);
  return "claims a solution, but " + (broken.empty() ? "there is none" : broken);
}

VectorXd numbers(Index n) { return VectorXd::LinSpaced(n, 1, static_cast<double>(n)); }

// Forces or gaps by number of the pair; nothing to draw if there are none.
void curve(Panel& panel, const char* label, Look look, const VectorXd& values) {
  if (values.size() > 0) panel.curve(label, look, numbers(values.size()), values);
}

// From zero to the largest of the values that are ours, with room beside them.
std::vector<double> window_of(const VectorXd& values) {
  if (values.size() == 0) return {0, 1, -1, 1};
  const double least = std::min(0., values.minCoeff()), most = std::max(0., values.maxCoeff());
  const double size = most > least ? most - least : 1;
  return {0, static_cast<double>(values.size()) + 1, least - 0.2 * size, most + 0.2 * size};
}

// Their figures by line of the table.
void marks(Panel& panel, const char* label, Look look, const std::vector<Index>& lines,
           const VectorXd& worst) {
  if (!lines.empty()) panel.curve(label, look, numbers(worst.size())(lines), worst(lines));
}

Answer visit(const Request& now) {
  const museum::Case given = opened(now.chosen("exhibit"));
  Answer answer;
  answer.says = "Symptom: " + given.exhibit.symptom + ". Cause: " + given.exhibit.cause + ".";
  answer.table = {{"verdict", "who", "what comes of it"}};
  Panel certificates{"The worst figure of the certificate of each who claims a solution",
                     "line of the table", "worst figure"};
  certificates.log_y = true;
  certificates.whole_x = true;
  const auto& all = museum::visitors();
  certificates.window = {0, static_cast<double>(all.size()) + 1, 1e-21, 1e3};
  certificates.clips = true;
  Panel forces{"Contact forces", "pair", "force"};
  Panel gaps{"Gaps", "pair", "gap"};
  forces.whole_x = gaps.whole_x = forces.clips = gaps.clips = true;
  certificates.curve("accepted", Look::Dotted, Eigen::Vector2d(1, static_cast<double>(all.size())),
                     Eigen::Vector2d::Constant(museum::accepted));
  std::vector<Set> verdicts = {{"solved", {}}, {"honest", {}}, {"refuted", {}}, {"not_for", {}}};
  VectorXd worst = VectorXd::Zero(static_cast<Index>(all.size()));
  for (std::size_t k = 0; k < all.size(); ++k) {
    const museum::Answer said = asked(given, all[k]);
    const Verdict verdict = museum::judge(given.exhibit, said);
    verdicts[static_cast<std::size_t>(verdict)].members.push_back(static_cast<Index>(k));
    answer.table.push_back({museum::icon(verdict), all[k], words(verdict, given.exhibit, said)});
    if (said.asked && said.solved())
      worst(static_cast<Index>(k)) = std::max(said.certificate.worst(), 1e-20);
    if (all[k] != "ours" && all[k] != now.chosen("beside")) continue;
    const bool ours = all[k] == "ours";
    if (ours) forces.window = window_of(said.contact.force);
    if (ours) gaps.window = window_of(said.contact.gap);
    curve(forces, ours ? "ours" : "beside", ours ? Look::Cross : Look::Open, said.contact.force);
    curve(gaps, ours ? "ours" : "beside", ours ? Look::Cross : Look::Open, said.contact.gap);
  }
  for (const Set& set : verdicts)
    answer.number(set.name, set.name == "not_for" ? "not for such problems" : set.name,
                  static_cast<double>(set.members.size()), "", "%.0f");
  marks(certificates, "certified", Look::Closed, verdicts[0].members, worst);
  marks(certificates, "refuted", Look::Cross, verdicts[2].members, worst);
  for (Panel* panel : {&certificates, &gaps})  // many of them are rounding
    for (Layer& layer : panel->layers) layer.varies = true;
  answer.sets = verdicts;
  answer.panels = {certificates};
  for (const Panel& panel : {forces, gaps})
    if (!panel.layers.empty()) answer.panels.push_back(panel);
  return answer;
}

}  // namespace

Figure hard() {
  std::vector<std::string> others(museum::visitors().begin() + 1, museum::visitors().end());
  return {"hard",
          "Pick a hard case",
          {with_own_axes(choice("exhibit", "exhibit", "stiff_on_soft_1e12",
                                {"hilbert_8",
                                 "gap_1e-16",
                                 "poisson_0_49999",
                                 "stiff_on_soft_1e12",
                                 "units_micrometres_giganewtons",
                                 "cycle_of_three",
                                 "hundred_equal_pairs",
                                 "nothing_pushes",
                                 "tiny_floating",
                                 "same_row_five_times",
                                 "gauss_points_4",
                                 "contact_twice",
                                 "contradicting_rows",
                                 "pulled_away",
                                 "tips_over",
                                 "corner_in_an_edge",
                                 "patch_on_other_nodes",
                                 "turned_normal",
                                 "three_answers",
                                 "slope_holds",
                                 "just_slides",
                                 "misspelt_operator",
                                 "element_of_other_cells"})),
           choice("beside", "forces and gaps beside ours", "penalty", others)},
          visit};
}

}  // namespace live
