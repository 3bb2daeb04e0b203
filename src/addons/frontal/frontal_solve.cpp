// K u = p with the factor: once up the tree, once down.
#include <algorithm>
#include <utility>

#include "addons/frontal/frontal_factor.hpp"
#include "addons/frontal/threads.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/parts.hpp"
#include "signorini/core/triangular.hpp"

namespace signorini {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// Has the processor fetch numbers that will be read next: it foresees walks up the memory, not those down.
void fetch(const Eigen::Map<const MatrixXd>& numbers) {
  constexpr Index line = 64 / sizeof(double);  // what one fetch brings
  for (Index k = 0; k < numbers.size(); k += line) __builtin_prefetch(numbers.data() + k);
}

/// What fronts of a part add to unknowns that other parts eliminate, in the order of the fronts: at which place, how much.
using Addends = std::vector<std::pair<int, double>>;

}  // namespace

/// Eliminates the unknowns of a front. \param add  gets a place and what is to be added there
template <typename Add>
void FrontalFactor::forward(const Front& front, VectorXd& x, VectorXd& numbers, Add&& add) const {
  Eigen::Ref<VectorXd> own = x.segment(front.separator.first, front.own());
  if ((own.array() == 0).all()) return;  // nothing to hand on
  Eigen::Ref<VectorXd> rows = numbers.head(front.rows());
  rows << own, VectorXd::Zero(front.rim());
  solve_lower(columns(front), rows);
  own = rows.head(front.own());
  for (std::size_t k = 0; k < front.boundary.size(); ++k)
    add(front.boundary[k], rows(front.own() + static_cast<Index>(k)));
}

void FrontalFactor::backward(const Front& front, VectorXd& x, VectorXd& numbers) const {
  Eigen::Ref<VectorXd> own = x.segment(front.separator.first, front.own());
  Eigen::Ref<VectorXd> rows = numbers.head(front.rows());
  rows.head(front.own()) = own;
  for (std::size_t k = 0; k < front.boundary.size(); ++k)
    rows(front.own() + static_cast<Index>(k)) = x(front.boundary[k]);
  solve_lower_transposed(columns(front), rows);
  own = rows.head(front.own());
}

/// Every unknown gets its addends in the order of the fronts that they come from. One thread walks through all fronts. Of
/// several each keeps what its part adds to others in a list, behind what those below have not needed.
void FrontalFactor::forward_in_parts(VectorXd& x) const {
  if (free_threads() == 1) {
    VectorXd room(fronts_.tallest);
    for (const Front& front : fronts_.all)
      forward(front, x, room, [&x](int place, double addend) { x(place) += addend; });
    return;
  }
  std::vector<Addends> handed(fronts_.parts.size());
  std::vector<VectorXd> numbers(at(threads()));
  up_the_tree(fronts_.parts, [&](int number, int worker) {
    const TreePart& part = fronts_.parts[at(number)];
    const Separator& last = fronts_.front(part.end - 1).separator;
    const int end = last.first + last.own;
    Addends& later = handed[at(number)];
    const auto add = [&](int place, double addend) {
      if (place < end)
        x(place) += addend;
      else
        later.emplace_back(place, addend);
    };
    for (const int below : part.below) {
      for (const auto& [place, addend] : handed[at(below)]) add(place, addend);
      handed[at(below)] = {};
    }
    VectorXd& room = numbers[at(worker)];
    room.resize(fronts_.tallest);
    for (int k = part.first; k < part.end; ++k) forward(fronts_.front(k), x, room, add);
  });
}

/// Places that are read belong to fronts above, which are done.
void FrontalFactor::backward_in_parts(VectorXd& x) const {
  std::vector<VectorXd> numbers(at(threads()));
  down_the_tree(fronts_.parts, [&](int number, int worker) {
    const TreePart& part = fronts_.parts[at(number)];
    VectorXd& room = numbers[at(worker)];
    room.resize(fronts_.tallest);
    for (int k = part.end - 1; k >= part.first; --k) {
      if (k > part.first) fetch(columns(fronts_.front(k - 1)));
      backward(fronts_.front(k), x, room);
    }
  });
}

VectorXd FrontalFactor::solve(const Eigen::Ref<const VectorXd>& load) const {
  require_argument(load.size() == size(), "FrontalFactor::solve: load must have ", size(),
                   " entries (one per unknown), got ", load.size());
  VectorXd x(size());
  for (Index k = 0; k < size(); ++k) x(fronts_.place[at(k)]) = load(k);
  forward_in_parts(x);
  backward_in_parts(x);
  VectorXd solution(size());
  for (Index k = 0; k < size(); ++k) solution(k) = scale_ * x(fronts_.place[at(k)]);
  return solution;
}

VectorXd FrontalFactor::solve(const Part& part, const Eigen::Ref<const VectorXd>& load) const {
  const Index count = static_cast<Index>(part.places.size());
  require_argument(load.size() == count, "FrontalFactor::solve: load must have ", count,
                   " entries (one per unknown of the part), got ", load.size());
  VectorXd x(size());  // of which only what the fronts know is ever looked at
  for (const int number : part.fronts) {
    const Front& front = fronts_.front(number);
    x.segment(front.separator.first, front.own()).setZero();
    for (const int place : front.boundary) x(place) = 0;
  }
  for (Index k = 0; k < count; ++k) x(part.places[at(k)]) = load(k);
  VectorXd numbers(fronts_.tallest);
  for (const int number : part.fronts)
    forward(fronts_.front(number), x, numbers,
            [&x](int place, double addend) { x(place) += addend; });
  for (auto number = part.fronts.rbegin(); number != part.fronts.rend(); ++number) {
    if (number + 1 != part.fronts.rend()) fetch(columns(fronts_.front(number[1])));
    backward(fronts_.front(*number), x, numbers);
  }
  VectorXd solution(count);
  for (Index k = 0; k < count; ++k) solution(k) = scale_ * x(part.places[at(k)]);
  return solution;
}

}  // namespace signorini
