/// \file
/// What a run cost: nested named phases with seconds, calls, counts and bytes.
#pragma once
#include <chrono>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace signorini {

/// One line of the ledger.
struct LedgerEntry {
  std::string path;                         ///< names from the outermost phase in, joined by '/'
  double seconds = 0;                       ///< wall time, all calls together [s]
  long long calls = 0;                      ///< how often the phase was entered
  std::map<std::string, long long> counts;  ///< what was counted in it, by name
  long long bytes = 0;                      ///< memory of what the phase built [byte]
};

/// Collects phases while a problem is solved. Times are for reading; tests assert the counts.
class Ledger {
 public:
  /// Times the block it lives in, nested in the phase that is open when it begins.
  class Phase {
   public:
    Phase(Ledger& ledger, const std::string& name);
    ~Phase();
    Phase(const Phase&) = delete;
    Phase& operator=(const Phase&) = delete;
    Phase(Phase&&) = delete;
    Phase& operator=(Phase&&) = delete;

   private:
    Ledger& ledger_;
    std::size_t entry_;
    std::size_t parent_;
    std::chrono::steady_clock::time_point begin_;
  };

  /// Adds `amount` to the count `name` of the open phase.
  void count(const std::string& name, long long amount);
  /// Adds `amount` bytes to the open phase.
  void bytes(long long amount);

  /// All lines in the order in which their phases were first entered.
  [[nodiscard]] const std::vector<LedgerEntry>& entries() const { return entries_; }
  /// Seconds of the phase `path` (`"factor/numeric"`), 0 if it was never entered.
  [[nodiscard]] double seconds(const std::string& path) const;
  /// The count `name` of the phase `path`, 0 if there is none.
  [[nodiscard]] long long counted(const std::string& path, const std::string& name) const;
  /// Largest total of bytes over all phases [byte].
  [[nodiscard]] long long total_bytes() const;

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  LedgerEntry& open_entry();
  [[nodiscard]] const LedgerEntry* find(const std::string& path) const;

  std::vector<LedgerEntry> entries_;
  std::size_t open_ = none;
};

/// Prints the ledger as an indented table.
std::ostream& operator<<(std::ostream& out, const Ledger& ledger);

}  // namespace signorini
