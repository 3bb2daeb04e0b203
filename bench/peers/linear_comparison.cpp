#include "bench/peers/linear_comparison.hpp"

#include <iostream>
#include <optional>

#include "bench/measure.hpp"
#include "bench/rounds.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/results.hpp"

namespace signorini::bench {
namespace {

/// Rows of one size.
void add_rows(const Cost& cost, const std::vector<Yardstick>& others, Table& table) {
  const auto row = [&](const std::string& name, const std::string& way) {
    const auto times = cost.times.find(way);
    if (times == cost.times.end()) return;
    const auto rise = cost.rise.find(way);
    table.row({text(cost.unknowns), name, number(median(times->second), "%.4f"),
               rise == cost.rise.end() ? "-" : number(rise->second, "%.0f"),
               ratio(cost, "whole", way), ratio(cost, "condense", way)});
  };
  row("contact, ours", "whole");
  row("compliance, ours", "condense");
  row("plain solve, ours", "plain");
  for (const Yardstick& other : others) row("plain solve, " + other.name, other.name);
  for (const Yardstick& other : others)
    row("compliance, " + other.name, other.name + " compliance");
}

}  // namespace

bool compare_linear(bool full, const std::filesystem::path& out) {
  const std::vector<Yardstick> others = all_yardsticks();
  Table table({"unknowns", "what", "s", "MB", "contact / it", "compliance / it"});
  bool good = true;
  std::optional<Cost> before;
  for (const Eigen::Index part :
       full ? std::vector<Eigen::Index>{1, 2, 4, 8} : std::vector<Eigen::Index>{1}) {
    Cost cost = measure(signorini_test::hertz(finer_hertz_mesh(part)), full ? 5 : 1,
                        before ? &*before : nullptr, others);
    good = good && cost.good;
    add_rows(cost, others, table);
    before = std::move(cost);
  }
  std::cout
      << "\nContact, from K, p, A, g to the certificate, and its compliance, against plain solves: "
         "ordering, "
         "factor, one\nsolve. Medians of processor time; by how much memory rose. MUMPS finds "
         "the compliance as a Schur complement.\nDense kernels of CHOLMOD and MUMPS: "
      << dense_kernels() << ".\n\n"
      << table.markdown();
  write_file(out / "linear.md", table.markdown());
  return good;
}

}  // namespace signorini::bench
