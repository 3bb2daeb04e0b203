#include <cmath>

#include "exercise.hpp"
#include "signorini/core/errors.hpp"

namespace ex16_3 {

using signorini::Ledger;
using signorini::LedgerEntry;
using signorini::require_argument;

double over_plain(const Ledger& ledger) {
  const auto counted = [&](const char* path, const char* name) {
    return static_cast<double>(ledger.counted(path, name));
  };
  const double factor = counted("factor/numeric", "operations");
  require_argument(factor > 0, "over_plain: the ledger has no operations of a factor");
  const double all =
      factor + counted("condensation", "operations") + counted("refinement", "operations");
  return all / (factor + counted("condensation", "operations of one solve"));
}

std::string dearest(const Ledger& ledger) {
  std::string path;
  double most = -1;
  for (const LedgerEntry& entry : ledger.entries()) {
    double own = entry.seconds;
    const std::string within = entry.path + '/';
    for (const LedgerEntry& other : ledger.entries())
      if (other.path.compare(0, within.size(), within) == 0 &&
          other.path.find('/', within.size()) == std::string::npos)  // not what is nested in those
        own -= other.seconds;
    if (own > most) {
      most = own;
      path = entry.path;
    }
  }
  return path;
}

double power_of(const Ledger& small, const Ledger& large, const std::string& path,
                const std::string& name) {
  const auto ratio = [&](const std::string& where, const std::string& what) {
    const long long few = small.counted(where, what), many = large.counted(where, what);
    require_argument(few > 0 && many > 0, "power_of: no '", what, "' in '", where, "'");
    return static_cast<double>(many) / static_cast<double>(few);
  };
  const double unknowns = ratio("assembly", "unknowns");
  require_argument(unknowns != 1, "power_of: both runs have the same unknowns");
  return std::log(ratio(path, name)) / std::log(unknowns);
}

}  // namespace ex16_3
