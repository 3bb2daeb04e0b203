// What became of a prediction.
#include <algorithm>

#include "addons/prediction/prediction.hpp"

namespace signorini {
namespace {

/// Seconds of all phases that no other one contains. \param first  of the ledgers that count
double seconds_in(const std::vector<Ledger>& ledgers, std::size_t first) {
  double sum = 0;
  for (std::size_t k = first; k < ledgers.size(); ++k)
    for (const LedgerEntry& entry : ledgers[k].entries())
      if (entry.path.find('/') == std::string::npos) sum += entry.seconds;
  return sum;
}

}  // namespace

std::vector<ComparedFigure> compare(const Prediction& prediction,
                                    const std::vector<Ledger>& ledgers) {
  std::vector<ComparedFigure> figures;
  const std::size_t later = ledgers.size() - std::min<std::size_t>(ledgers.size(), 1);
  for (const PredictedFigure& figure : prediction.figures) {
    figures.push_back({figure, {}});
    std::optional<double>& measured = figures.back().measured;
    if (figure.phase == all_phases && !ledgers.empty()) measured = seconds_in(ledgers, 0);
    if (figure.phase == later_step && later > 0)
      measured = seconds_in(ledgers, 1) / static_cast<double>(later);
    const auto add = [&](double amount) { measured = measured.value_or(0) + amount; };
    double iterations = 0;
    for (const Ledger& ledger : ledgers)
      for (const LedgerEntry& entry : ledger.entries()) {
        if (entry.path != figure.phase) continue;
        if (figure.what == "seconds" || figure.what == one_iteration)
          add(entry.seconds);
        else if (figure.what == "bytes")
          add(static_cast<double>(entry.bytes));
        else if (entry.counts.count(figure.what) > 0)
          add(static_cast<double>(entry.counts.at(figure.what)));
        iterations += static_cast<double>(ledger.counted(entry.path, "iterations"));
      }
    if (figure.what == one_iteration && measured) *measured /= std::max(1.0, iterations);
  }
  return figures;
}

}  // namespace signorini
