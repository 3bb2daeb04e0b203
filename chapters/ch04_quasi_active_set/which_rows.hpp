// Four choices of the rows that a step takes.
#pragma once
#include <array>

#include "papers/quasi_active_set_literal.hpp"

namespace ch04 {

struct Choice {
  signorini::QuasiActiveRows rows;
  const char* name;
};
constexpr std::array<Choice, 4> choices = {
    {{signorini::QuasiActiveRows::AllViolated, "all violated"},
     {signorini::QuasiActiveRows::IndependentByIndex, "independent, by number"},
     {signorini::QuasiActiveRows::IndependentByViolation, "independent, by overlap"},
     {signorini::QuasiActiveRows::MostViolated, "the most violated"}}};

}  // namespace ch04
