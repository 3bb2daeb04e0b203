// # What a run costs
//
// "Contact costs about two linear solves" is a claim that can be measured. Every part of a run that
// takes time opens a phase, a local object, and the phase ends with its block:
//
//     const Ledger::Phase outer(ledger, "factor");
//     { const Ledger::Phase inner(ledger, "numeric"); ... }
//
// writes the lines `factor` and `factor/numeric`. The first contains the seconds of the second;
// counts belong only to the line where they were counted. Seconds differ from run to run, counts do
// not: so tests read counts.

#include "signorini/core/ledger.hpp"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace signorini {

// A phase remembers the number of its line, not the line: `entries_` moves in memory when a new
// line is added.
Ledger::Phase::Phase(Ledger& ledger, const std::string& name)
    : ledger_(ledger), parent_(ledger.open_), begin_(std::chrono::steady_clock::now()) {
  entry_ = ledger.line(parent_ == none ? name : ledger.entries_[parent_].path + '/' + name);
  ledger.open_ = entry_;
}

Ledger::Phase::~Phase() {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  ledger_.entries_[entry_].seconds += elapsed.count();
  ++ledger_.entries_[entry_].calls;
  ledger_.open_ = parent_;
}

// A phase in a loop opens the same path again and adds to its line. A run has few lines, so we look
// through all of them.
std::size_t Ledger::line(const std::string& path) {
  if (const LedgerEntry* known = find(path))
    return static_cast<std::size_t>(known - entries_.data());
  entries_.emplace_back();
  entries_.back().path = path;
  return entries_.size() - 1;
}

// What is counted while no phase is open is not lost: it goes to a line of its own.
LedgerEntry& Ledger::open_entry() { return entries_[open_ != none ? open_ : line("outside")]; }

// Any name may be counted. A new one begins at 0.
void Ledger::count(const std::string& name, long long amount) {
  open_entry().counts[name] += amount;
}

void Ledger::bytes(long long amount) { open_entry().bytes += amount; }

// A test may ask for a phase that never ran. That is no error: it took no time, and nothing was
// counted.
const LedgerEntry* Ledger::find(const std::string& path) const {
  const auto known = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const LedgerEntry& e) { return e.path == path; });
  return known == entries_.end() ? nullptr : &*known;
}

double Ledger::seconds(const std::string& path) const {
  const LedgerEntry* entry = find(path);
  return entry == nullptr ? 0 : entry->seconds;
}

long long Ledger::counted(const std::string& path, const std::string& name) const {
  const LedgerEntry* entry = find(path);
  if (entry == nullptr) return 0;
  const auto known = entry->counts.find(name);
  return known == entry->counts.end() ? 0 : known->second;
}

// Each line is indented by its depth, the number of `/` in its path. A phase may be entered again when
// others have ended, so the lines in it are looked for: all begin with its name. The table is written
// into a string first, so that the number formats of `out` stay as they are.
std::ostream& operator<<(std::ostream& out, const Ledger& ledger) {
  std::ostringstream table;
  table << std::left << std::setw(34) << "phase" << std::right << std::setw(10) << "seconds"
        << std::setw(7) << "calls" << std::setw(10) << "MB"
        << "  counts\n";
  const auto print = [&table](const LedgerEntry& entry) {
    const auto depth = std::count(entry.path.begin(), entry.path.end(), '/');
    const std::string name = entry.path.substr(entry.path.rfind('/') + 1);
    table << std::left << std::setw(34)
          << std::string(static_cast<std::size_t>(2 * depth), ' ') + name << std::right
          << std::fixed << std::setprecision(4) << std::setw(10) << entry.seconds << std::setw(7)
          << entry.calls << std::setprecision(1) << std::setw(10)
          << static_cast<double>(entry.bytes) / 1e6;
    for (const auto& [what, amount] : entry.counts) table << "  " << what << ' ' << amount;
    table << '\n';
  };
  for (const LedgerEntry& outer : ledger.entries())
    for (const LedgerEntry& entry : ledger.entries())
      if (outer.path == entry.path.substr(0, entry.path.find('/'))) print(entry);
  return out << table.str();
}

}  // namespace signorini
