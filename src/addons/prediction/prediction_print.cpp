// What a prediction looks like, alone and beside what became of it.
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "addons/prediction/prediction.hpp"
#include "signorini/core/table.hpp"

namespace signorini {
namespace {

/// A time, or a size, in as many digits as anybody wants to read.
std::string in_words(const PredictedFigure& figure, double amount) {
  if (std::isnan(amount)) return "not known";
  const bool bytes = figure.what.find("bytes") != std::string::npos;
  if (figure.what.find("seconds") == 0) return signorini::number(amount, "%.2g s");
  if (bytes && amount >= 1e5) return signorini::number(amount / 1e6, "%.3g MB");
  if (figure.what.find("operations") != std::string::npos) return signorini::number(amount, "%.3g");
  return signorini::number(amount, "%.0f");
}

}  // namespace

const char* to_string(Certainty certainty) {
  return certainty == Certainty::Exact      ? "exact"
         : certainty == Certainty::Estimate ? "about"
         : certainty == Certainty::AtLeast  ? "at least"
                                            : "not known";
}

const char* to_string(Frequency frequency) {
  return frequency == Frequency::Once      ? "once"
         : frequency == Frequency::PerStep ? "per load step"
                                           : "per iteration";
}

std::ostream& operator<<(std::ostream& out, const Prediction& prediction) {
  std::ostringstream table;
  for (const BodySummary& body : prediction.bodies)
    table << "  body '" << body.name << "': " << body.pieces
          << (body.pieces == 1 ? " piece" : " loose pieces") << ", loads add up to ("
          << body.force.x() << ", " << body.force.y() << "), moment about the origin "
          << body.moment << '\n';
  table << "  " << prediction.method << '\n';
  if (!prediction.unknown.empty()) table << "  " << prediction.unknown << '\n';
  for (const Frequency frequency : {Frequency::Once, Frequency::PerStep, Frequency::PerIteration}) {
    table << "  " << to_string(frequency) << '\n';
    std::string last;
    for (const PredictedFigure& figure : prediction.figures) {
      if (figure.frequency != frequency) continue;
      if (figure.phase != last)
        table << (last.empty() ? "" : "\n") << "    " << std::left << std::setw(16) << figure.phase;
      table << (figure.phase != last ? " " : ", ") << figure.what << ' '
            << (figure.certainty == Certainty::Exact || figure.certainty == Certainty::Unknown
                    ? ""
                    : std::string(to_string(figure.certainty)) + ' ')
            << in_words(figure, figure.amount);
      last = figure.phase;
    }
    table << '\n';
  }
  return out << table.str();
}

std::ostream& operator<<(std::ostream& out, const std::vector<ComparedFigure>& figures) {
  std::ostringstream table;
  table << std::left << std::setw(18) << "phase" << std::setw(26) << "figure" << std::right
        << std::setw(12) << "predicted" << std::setw(12) << "measured"
        << "  trust\n";
  for (const ComparedFigure& figure : figures)
    table << std::left << std::setw(18) << figure.predicted.phase << std::setw(26)
          << figure.predicted.what << std::right << std::setw(12)
          << in_words(figure.predicted, figure.predicted.amount) << std::setw(12)
          << (figure.measured ? in_words(figure.predicted, *figure.measured) : "-") << "  "
          << to_string(figure.predicted.certainty) << '\n';
  return out << table.str();
}

}  // namespace signorini
