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
  long long calls = 0;                      ///< how often the phase ended
  std::map<std::string, long long> counts;  ///< what was counted in it, by name
  long long bytes = 0;                      ///< memory of what the phase built [byte]
};

/// Collects phases while a problem is solved. Times are for reading; tests assert the counts.
class Ledger {
 public:
  /// Times the block it lives in, nested in the phase that is open when it begins.
  class Phase {
   public:
    /// Opens a phase; entering the same one again adds to its line.
    /// \param ledger  receives the line; must outlive the phase
    /// \param name    last part of the path, without '/'
    Phase(Ledger& ledger, const std::string& name);
    /// Ends the phase: adds its seconds and one call, and opens the outer phase again.
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

  /// Counts something in the open phase, or on the line `outside` if none is open.
  /// \param name    what is counted
  /// \param amount  how many to add
  void count(const std::string& name, long long amount);
  /// Notes memory that the open phase built, or on the line `outside` if none is open.
  /// \param amount  how much to add [byte]
  void bytes(long long amount);

  /// \return all lines, in the order in which their phases were first entered
  [[nodiscard]] const std::vector<LedgerEntry>& entries() const { return entries_; }
  /// Time of one phase, with what is nested in it.
  /// \param path  such as `"factor/numeric"`
  /// \return wall time [s], 0 if the phase was never entered
  [[nodiscard]] double seconds(const std::string& path) const;
  /// One count of one phase, without what is nested in it.
  /// \param path  such as `"factor/numeric"`
  /// \param name  what was counted
  /// \return the count, 0 if there is none
  [[nodiscard]] long long counted(const std::string& path, const std::string& name) const;

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t line(const std::string& path);  // its number; a new one at the end if there is none
  LedgerEntry& open_entry();
  [[nodiscard]] const LedgerEntry* find(const std::string& path) const;

  std::vector<LedgerEntry> entries_;
  std::size_t open_ = none;
};

/// Prints the ledger as an indented table: seconds, calls, megabytes (10^6 bytes) and counts.
/// \param out     where to
/// \param ledger  what
/// \return `out`
std::ostream& operator<<(std::ostream& out, const Ledger& ledger);

}  // namespace signorini
