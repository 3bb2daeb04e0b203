// # Several contacts as one problem
//
// Contacts do not know each other, and solvers know only one list of pairs. So rows, gaps, weights
// and normals of one contact are put below those of another. They meet again in the stiffness
// matrix: a force of one contact moves the body that the other one touches. A block between two
// plates is such a case.
//
// Every member of Gaps is stacked but `kept`, which counts the candidates of one contact and means
// nothing for two. The list below has the order of the struct, and braces leave out nothing but
// what stands last.

#include <utility>
#include <vector>

#include "signorini/contact/gaps.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Vectors and arrays that have a row per pair.
template <typename Array>
Array below_dense(const Array& upper, const Array& lower) {
  Array both(upper.rows() + lower.rows(), lower.cols());
  both.topRows(upper.rows()) = upper;
  both.bottomRows(lower.rows()) = lower;
  return both;
}

std::vector<Index> joined_lists(std::vector<Index> upper, const std::vector<Index>& lower) {
  upper.insert(upper.end(), lower.begin(), lower.end());
  return upper;
}

}  // namespace

Gaps stacked(const Gaps& upper, const Gaps& lower) {
  const Pairs& above = upper.pairs;
  const Pairs& under = lower.pairs;
  return {{below(above.opening, under.opening), below(above.sliding, under.sliding),
           below_dense(above.initial_gap, under.initial_gap),
           below_dense(above.weight, under.weight), below_dense(above.position, under.position),
           below_dense(above.normal, under.normal), below_dense(above.moment, under.moment),
           below_dense(above.target_moment, under.target_moment),
           joined_lists(above.node, under.node), joined_lists(above.unpaired, under.unpaired)},
          below(upper.A, lower.A),
          below(upper.T, lower.T),
          below_dense(upper.initial_slip, lower.initial_slip)};
}

// Of two contacts one is put below the other. Of a thousand that would copy the first one a thousand
// times, and the time would grow with the square of their number. So neighbours are put together in
// pairs, then pairs of pairs:
//
//     1 2 3 4 5  ->  12 34 5  ->  1234 5  ->  12345
//
// A list of a thousand is halved ten times, and each contact is copied ten times.
Gaps stacked(std::vector<Gaps> contacts) {
  while (contacts.size() > 1) {
    std::vector<Gaps> half;
    for (std::size_t k = 0; k + 1 < contacts.size(); k += 2)
      half.push_back(stacked(contacts[k], contacts[k + 1]));
    if (contacts.size() % 2 == 1) half.push_back(std::move(contacts.back()));
    contacts = std::move(half);
  }
  return std::move(contacts.front());
}

}  // namespace signorini
