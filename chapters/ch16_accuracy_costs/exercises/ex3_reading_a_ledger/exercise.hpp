/// \file
/// Exercise 16.3 - reading the ledger of a run. Do not change this file.
#pragma once
#include <string>

#include "signorini/core/ledger.hpp"

namespace ex16_3 {

/// All operations of a run over those of a plain solve with the same matrix: its factor, and one solve with it.
///
/// Operations are counted in `factor/numeric`, `condensation` and `refinement`; those of one solve stand in `condensation` too, by
/// their own name, and are among its operations.
/// \param ledger  of a run
/// \return at least 1 [-]
/// \throws std::invalid_argument if the ledger has no operations of a factor
[[nodiscard]] double over_plain(const signorini::Ledger& ledger);

/// The phase that took longest by itself: its seconds less those of the phases that are nested in it.
/// \param ledger  of a run
/// \return its path, the first of several; empty if the ledger is
[[nodiscard]] std::string dearest(const signorini::Ledger& ledger);

/// How a count grows with the unknowns of `assembly`: as this power of them.
/// \param small  ledger of a run
/// \param large  of the same scene on a finer mesh
/// \param path   of the phase that counts
/// \param name   of what is counted
/// \return power p of count ~ unknowns^p [-]
/// \throws std::invalid_argument unless both ledgers have the count and the unknowns, all above 0, and one has more unknowns
[[nodiscard]] double power_of(const signorini::Ledger& small, const signorini::Ledger& large,
                              const std::string& path, const std::string& name);

}  // namespace ex16_3
