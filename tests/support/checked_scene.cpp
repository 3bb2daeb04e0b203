#include "support/checked_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "signorini/core/index.hpp"

namespace signorini_test {
namespace {

using Eigen::Index;
using namespace signorini;

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Wide;
#else
using Wide = long double;
#endif
using Wides = std::vector<Wide>;

Wide size(Wide x) { return x < 0 ? -x : x; }
double over(Wide part, Wide whole) {
  if (part == 0) return 0;
  return whole > 0 ? static_cast<double>(part / whole) : std::numeric_limits<double>::infinity();
}

/// The model and the solution, number by number.
class Checked {
 public:
  Checked(const Model& model, const Solution& solution, double length, double stiffest);
  SceneErrors errors();

 private:
  void sum_up();
  void measure();
  void look_at_forces();
  /// A gap or slip that is told may be rounded.
  void read(Index row, Wide told);
  void look_at_pair(Index pair);
  void look_at_friction(Index k);
  void look_at_rigid_motions();
  [[nodiscard]] bool carries(Index row) const {
    return size(force(row)) > std::max(1e-12 * force_, made_);
  }
  [[nodiscard]] Wide movement(Index row) const { return movement_[at(row)] / norm_[at(row)]; }
  [[nodiscard]] Wide force(Index row) const {
    return solution_.refined.force(row) * norm_[at(row)];
  }

  const Model& model_;
  const Solution& solution_;
  const QuadraticProgramme& given_;
  Wides u_;         // `n`
  Wides rigid_;     // `n`
  Wides strained_;  // `n` u without the rigid part
  Wides residual_;  // `n` of the equilibrium
  Wides contact_;   // `n` A^T f
  Wides movement_;  // gaps and slips
  Wides norm_;      // of rows, 1 for one without entries
  Wide length_;
  double stiffest_;
  Wide force_ = 0;
  Wide inside_ = 0;    // largest |K| |u|
  Wide made_ = 0;      // that rounding of the entries of K may make along rigid motions
  Wide resolved_ = 0;  // largest rounding of K u: u is known in two doubles
  SceneErrors errors_;
};

Checked::Checked(const Model& model, const Solution& solution, double length, double stiffest)
    : model_(model),
      solution_(solution),
      given_(model.programme),
      length_(length),
      stiffest_(std::max(stiffest, model.programme.stiffness.diagonal().maxCoeff())) {
  const PrimalDual& found = solution.refined;
  for (Index j = 0; j < given_.load.size(); ++j) {
    const double low = found.displacement_low.size() > 0 ? found.displacement_low(j) : 0;
    rigid_.push_back(found.rigid.size() > 0 ? found.rigid(j) : 0);
    u_.push_back(Wide(found.displacement(j)) + low);
    strained_.push_back(Wide(found.displacement(j)) - rigid_.back() + low);
  }
}

void Checked::sum_up() {
  const std::size_t n = u_.size();
  contact_.assign(n, 0);
  for (Index row = 0; row < given_.A.rows(); ++row) {
    Wide moved = given_.initial_gap(row);
    Wide squares = 0;
    for (NodalRows::InnerIterator it(given_.A, row); it; ++it) {
      const Wide a = it.value();
      moved -= a * u_[at(it.col())];
      squares += a * a;
      contact_[at(it.col())] += a * solution_.refined.force(row);
    }
    movement_.push_back(moved);
    norm_.push_back(squares > 0 ? std::sqrt(static_cast<double>(squares)) : 1);
  }
  Wides strains(n, 0);
  Wides terms(n, 0);
  Wides whole(n, 0);
  const Eigen::VectorXd stiff = given_.stiffness.diagonal();
  residual_.assign(n, 0);
  for (Index k = 0; k < given_.stiffness.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(given_.stiffness, k); it; ++it) {
      const Wide entry = it.value();
      const Wide pull = entry * strained_[at(k)];
      made_ += size(pull);
      residual_[at(it.row())] -= pull;
      whole[at(it.row())] += size(entry * u_[at(k)]);
      strains[at(it.row())] += entry * rigid_[at(k)];
      // Not |K_jk|: on right-angled triangles many are zero but for rounding.
      terms[at(it.row())] +=
          Wide(std::sqrt(stiff(it.row()))) * std::sqrt(stiff(k)) * size(rigid_[at(k)]);
    }
  made_ *= 0x1p-52 * static_cast<double>(given_.stiffness.nonZeros()) /
           static_cast<double>(std::max<std::size_t>(1, n));
  for (std::size_t j = 0; j < n; ++j) {
    residual_[j] += given_.load(static_cast<Index>(j)) - contact_[j];
    grow(errors_.strain, over(size(strains[j]), terms[j]));
    inside_ = std::max(inside_, whole[j]);
    resolved_ = std::max(resolved_, 0x1p-106 * whole[j]);
  }
}

void Checked::measure() {
  for (std::size_t j = 0; j < u_.size(); ++j)
    force_ = std::max({force_, size(given_.load(static_cast<Index>(j))), size(contact_[j])});
  // What bears without moving is measured by how the force would move the stiffest unknown.
  length_ = std::max<Wide>(length_, force_ / stiffest_);
  for (Index row = 0; row < given_.A.rows(); ++row) {
    Wide length = 0;
    for (NodalRows::InnerIterator it(given_.A, row); it; ++it)
      length += size(it.value()) * size(u_[at(it.col())]);
    length_ = std::max(length_, length / norm_[at(row)]);
  }
  // Without a load, contact forces that u in two doubles cannot resolve are measured by those that it could make.
  if ((given_.load.array() != 0).any() || force_ > resolved_) return;
  for (const Wide& u : u_) inside_ = std::max(inside_, Wide(stiffest_) * size(u));
  force_ = inside_;
}

void Checked::look_at_forces() {
  for (const Wide& residual : residual_) grow(errors_.equilibrium, over(size(residual), force_));
}

void Checked::read(Index row, Wide told) {
  const Wide difference = size(movement_[at(row)] - told) / norm_[at(row)];
  grow(errors_.reading, over(difference, std::max(length_, size(movement(row)))));
}

void Checked::look_at_pair(Index pair) {
  const Wide gap = movement(pair);
  const double opens = over(size(gap), length_);
  const double pushes = over(size(force(pair)), force_);
  if (gap < 0) grow(errors_.penetration, opens);
  if (force(pair) < 0) grow(errors_.tension, pushes);
  grow(errors_.complementarity, std::min(opens, pushes));
  const ContactState& told = solution_.contact;
  read(pair, told.gap(pair));
  grow(errors_.reading, over(size(solution_.refined.force(pair) - told.force(pair)), force_));
}

void Checked::look_at_friction(Index k) {
  const Index pair = model_.law.pair[at(k)];
  const Index row = given_.A.rows() - static_cast<Index>(model_.law.pair.size()) + k;
  const ContactState& told = solution_.contact;
  const ContactStatus status = status_of_slip(told, k);
  const Wide slip = movement(row);
  const Wide normal = std::max<Wide>(solution_.refined.force(pair), 0);
  const Wide bound =
      norm_[at(row)] * (status == ContactStatus::Open
                            ? Wide(0)
                            : model_.law.coefficient(k) * normal + Wide(model_.law.cohesion(k)));
  const double slides = over(size(slip), length_);
  grow(errors_.cone, over(std::max<Wide>(size(force(row)) - bound, 0), force_));
  if (status != ContactStatus::Open && model_.law.cohesion(k) > 0)
    grow(errors_.cone, over(size(movement(pair)), length_));
  if (status == ContactStatus::Stick) grow(errors_.stick, slides);
  const Wide lacks = slip > 0 ? force(row) + bound : force(row) - bound;
  grow(errors_.sliding, std::min(slides, over(size(lacks), force_)));
  read(row, told.slip(k));
  grow(errors_.reading, over(size(solution_.refined.force(row) - told.friction(k)), force_));
}

void Checked::look_at_rigid_motions() {
  const Index gaps = static_cast<Index>(model_.pairs.weight.size());
  std::vector<Wides> basis;
  for (Index row = 0; row < given_.A.rows(); ++row) {
    const bool sticks =
        row >= gaps && status_of_slip(solution_.contact, row - gaps) == ContactStatus::Stick;
    if (row < gaps ? !carries(row) : !sticks) continue;
    Wides moved;
    for (const FreeMotion& mode : model_.modes) {
      moved.push_back(0);
      for (NodalRows::InnerIterator it(given_.A, row); it; ++it)
        moved.back() += it.value() * Wide(mode.shape.coeff(it.col())) / norm_[at(row)];
    }
    for (const Wides& known : basis) {
      Wide along = 0;
      for (std::size_t k = 0; k < known.size(); ++k) along += known[k] * moved[k];
      for (std::size_t k = 0; k < known.size(); ++k) moved[k] -= along * known[k];
    }
    Wide squares = 0;
    for (const Wide& m : moved) squares += m * m;
    const double left = std::sqrt(static_cast<double>(squares));
    if (left <= 1e-9) continue;
    for (Wide& m : moved) m /= left;
    basis.push_back(std::move(moved));
  }
  errors_.held = basis.size() == model_.modes.size();
}

SceneErrors Checked::errors() {
  sum_up();
  measure();
  look_at_forces();
  for (Index pair = 0; pair < model_.pairs.weight.size(); ++pair) look_at_pair(pair);
  for (std::size_t k = 0; k < model_.law.pair.size(); ++k) look_at_friction(static_cast<Index>(k));
  look_at_rigid_motions();
  errors_.length = static_cast<double>(length_);
  return errors_;
}

}  // namespace

void grow(double& figure, double value) {
  if (!(value <= figure)) figure = std::isnan(value) ? HUGE_VAL : value;
}

double SceneErrors::worst() const {
  return std::max({equilibrium, strain, penetration, tension, complementarity, cone, stick, sliding,
                   reading, balance});
}

SceneErrors check_scene(const Model& model, const Solution& solution, double length,
                        double stiffest) {
  return Checked(model, solution, length, stiffest).errors();
}

}  // namespace signorini_test
