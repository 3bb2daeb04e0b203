#include "exercise.hpp"

namespace ex16_3 {

double over_plain(const signorini::Ledger& /*ledger*/) {
  return 1;  // your code here
}

std::string dearest(const signorini::Ledger& ledger) {
  std::string path;
  double most = -1;
  for (const signorini::LedgerEntry& entry : ledger.entries())
    if (entry.seconds > most) {  // your code here: less what is nested
      most = entry.seconds;
      path = entry.path;
    }
  return path;
}

double power_of(const signorini::Ledger& /*small*/, const signorini::Ledger& /*large*/,
                const std::string& /*path*/, const std::string& /*name*/) {
  return 1;  // your code here
}

}  // namespace ex16_3
