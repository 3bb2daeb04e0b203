// # Pairs, found and found again
//
// A candidate pair is a point of the source and the place on the target that it faces.
// pair_up() finds the pairs in the meshes, before anything moves. From there on a gap is
// linear in the displacements, \f$ g + Nu \f$.
//
// That is an approximation. Take a node on top of a disc of radius 1, with the normal (0, 1)
// and the gap 0. The node moves by (0.6, 0). The linear gap stays 0. The true gap is
// \f$ \sqrt{1 + 0.6^2} - 1 = 0.166 \f$, because the disc curves away. So the pairs can be
// found again where the bodies have moved to. The add-on certified asks for this behind a
// solution. It then estimates by how much contact forces would change there.
//
// Three things may have happened. A pair faces another place of the target. A pair faces
// nothing any more. Or a place overlaps that was in no pair before. All three are told apart
// here.
//
// The pairs of the model keep their numbers. Gaps are compared with those of the meshes, so
// that what was done to a gap before loading does not count as a movement.

#include "addons/checks/follow.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/fem/side_curve.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::RowVector2d, Eigen::VectorXd;

// How far a pair slides is measured in sides: the same length is little in a coarse mesh and
// much in a fine one. So each node is told the longest side that it is on.
void see_sides(const Surface& surface, VectorXd& length) {
  for (const SideCurve& side : side_curves(surface.mesh, surface.boundary)) {
    const double chord = (side.point(1) - side.point(-1)).norm();
    for (const Index node : side.nodes()) {
      double& longest = length(surface.first_node + node);
      longest = std::max(longest, chord);
    }
  }
}

// Copies of the bodies with moved nodes. Only what pairing needs is copied: loads and
// supports are not. The model itself must stay where it is, because its displacements are
// counted from there.
std::vector<BodyModel> moved(const std::vector<BodyModel>& bodies, const NodeArray& displacement) {
  std::vector<BodyModel> there;
  for (const BodyModel& body : bodies) {
    there.push_back(
        {body.mesh, body.element, body.material, {}, {}, body.first_node, body.first_unknown});
    Mesh& mesh = there.back().mesh;
    mesh.nodes += displacement.middleRows(body.first_node, mesh.n_nodes());
  }
  return there;
}

// A pair at a Gauss point has no node, so its place must be computed. Its row of N has the
// entries \f$ \varphi_j n \f$, with the shape functions \f$ \varphi_j \f$ of the source.
// Times the unit normal they give \f$ \varphi_j n \cdot n = \varphi_j \f$, and the point
// moves by \f$ \sum_j \varphi_j u_j \f$.
RowVector2d moved_point(const Model& model, const Surface& source, Index pair,
                        const NodeArray& displacement) {
  RowVector2d x = model.pairs.position.row(pair);
  for (NodalRows::InnerIterator it(model.pairs.opening, pair); it; ++it) {
    const Index node = it.col() / 2;
    const Index axis = it.col() % 2;
    if (node >= source.first_node && node < source.first_node + source.mesh.n_nodes())
      x += it.value() * model.pairs.normal(pair, axis) * displacement.row(node);
  }
  return x;
}

// A body may have moved so far that a contact faces nothing. In a scene that is an error and
// ends the run. Here it is an answer to the question where the pairs are, so the message
// becomes a value.
std::pair<Pairs, std::string> found_pairs(const ContactSpec& contact,
                                          const std::vector<BodyModel>& bodies) {
  try {
    return {pair_up(contact, bodies, false), ""};
  } catch (const ProblemError& error) {
    return {Pairs{}, error.what()};
  }
}

// Puts the pairs of one contact that are found there in the place of those of the model. The
// numbers of pairs must stay: forces and statuses belong to them.
class Following {
 public:
  Following(const Model& model, const NodeArray& displacement, MovedPairs& all)
      : model_(model), displacement_(displacement), all_(all) {
    entries_.reserve(static_cast<std::size_t>(model.pairs.opening.nonZeros()));
  }

  // A pair with a node is the same as the one that has that node there. A pair without one
  // is the nearest. A pair that faces nothing any more has an infinite gap, and keeps its
  // old row. What is left among those found there belongs to no pair of the model. It
  // matters if it overlaps by more than rounding and if something of it can move. No force
  // of the model acts there, so the solution knew nothing of it. Where equations hold a pair, they
  // have its force. `source` is as it was, `first` the first pair of the contact in the model.
  void match(const Surface& source, const Pairs& there, std::size_t contact, Index first,
             const FollowedContact& followed) {
    const VectorXd& gap = followed.gap;
    const std::vector<Index>& given = followed.given;
    std::vector<bool> taken(there.node.size(), false);
    std::vector<Index> of_node(static_cast<std::size_t>(source.mesh.n_nodes()), -1);
    for (std::size_t k = 0; k < there.node.size(); ++k) {
      const Index node = there.node[k];
      if (node >= 0) of_node[static_cast<std::size_t>(node)] = static_cast<Index>(k);
      taken[k] = node >= 0 && std::binary_search(given.begin(), given.end(), source.first_node + node);
    }
    for (Index pair = first; pair < first + gap.size(); ++pair) {
      const Index node = model_.pairs.node[static_cast<std::size_t>(pair)];
      const Index found = node >= 0 ? of_node[static_cast<std::size_t>(node - source.first_node)]
                                    : nearest(source, there, pair);
      if (found >= 0) taken[static_cast<std::size_t>(found)] = true;
      all_.opens(pair) = found >= 0 ? there.initial_gap(found) - gap(pair - first)
                                    : std::numeric_limits<double>::infinity();
      add(found >= 0 ? there.opening : model_.pairs.opening, found >= 0 ? found : pair, pair,
          entries_);
    }
    for (std::size_t k = 0; k < taken.size(); ++k)
      if (!taken[k] && there.initial_gap(static_cast<Index>(k)) < -gap_rounding(there) &&
          can_move(there.opening, static_cast<Index>(k))) {
        add(there.opening, static_cast<Index>(k), static_cast<Index>(gaps_.size()), fresh_);
        gaps_.push_back(there.initial_gap(static_cast<Index>(k)));
        all_.fresh_contact.push_back(contact);
      }
  }

  // A half-plane looks the same from everywhere, so a body may slide along it as far as it
  // likes. The linear gaps are exact and nothing is searched.
  void stay(Index first, Index count) {
    const Eigen::Map<const VectorXd> u(displacement_.data(), displacement_.size());
    all_.opens.segment(first, count) = model_.pairs.opening.middleRows(first, count) * u;
    for (Index pair = first; pair < first + count; ++pair)
      add(model_.pairs.opening, pair, pair, entries_);
  }

  // Entries of rows come one by one, pair by pair and contact by contact. Sparse matrices
  // are made of them at the end, all at once: to insert each entry on its own would move
  // those behind it. Rows of fresh overlaps have their own matrix, because no force of the
  // model belongs to them.
  void finish() {
    const NodalRows& old = model_.pairs.opening;
    all_.opening.resize(old.rows(), old.cols());
    all_.opening.setFromTriplets(entries_.begin(), entries_.end());
    all_.fresh.resize(static_cast<Index>(gaps_.size()), old.cols());
    all_.fresh.setFromTriplets(fresh_.begin(), fresh_.end());
    all_.fresh_gap = Eigen::Map<const VectorXd>(gaps_.data(), static_cast<Index>(gaps_.size()));
  }

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;

  // Copies a row. Its number may be another one in the new matrix.
  static void add(const NodalRows& rows, Index from, Index to, Entries& entries) {
    for (NodalRows::InnerIterator it(rows, from); it; ++it)
      entries.emplace_back(static_cast<int>(to), static_cast<int>(it.col()), it.value());
  }

  // If supports hold all nodes of a place, contact cannot undo an overlap there. So it is
  // not reported.
  [[nodiscard]] bool can_move(const NodalRows& rows, Index pair) const {
    for (NodalRows::InnerIterator it(rows, pair); it; ++it)
      if (model_.unknowns.number(it.col() / 2, it.col() % 2) >= 0) return true;
    return false;
  }

  // The pair at the point that one without a node has moved to; -1 if there is none. It must
  // be the same point up to rounding: a neighbour is another pair.
  [[nodiscard]] Index nearest(const Surface& source, const Pairs& there, Index pair) const {
    const RowVector2d x = moved_point(model_, source, pair, displacement_);
    Index found = -1;
    if (there.position.rows() > 0)
      (there.position.rowwise() - x).rowwise().squaredNorm().minCoeff(&found);
    return found >= 0 && (there.position.row(found) - x).norm() <= gap_rounding(there) ? found : -1;
  }

  const Model& model_;
  const NodeArray& displacement_;
  MovedPairs& all_;
  Entries entries_;
  Entries fresh_;
  std::vector<double> gaps_;
};

}  // namespace

MovedPairs follow(const std::vector<FollowedContact>& contacts, const Model& model,
                  const NodeArray& displacement) {
  const NodalRows& old = model.pairs.opening;
  MovedPairs all;
  all.opens.resize(old.rows());
  all.edge.setZero(old.rows());
  all.lost.resize(contacts.size());
  const std::vector<BodyModel> there = moved(model.bodies, displacement);
  Following following(model, displacement, all);
  Index first = 0;
  for (std::size_t k = 0; k < contacts.size(); first += contacts[k++].gap.size()) {
    const ContactSpec& contact = contacts[k].contact;
    const Surface source = surface(model.bodies, contact.source);
    VectorXd length = VectorXd::Zero(displacement.rows());
    see_sides(source, length);
    if (const Side* target = std::get_if<Side>(&contact.target))
      see_sides(surface(model.bodies, *target), length);
    for (Index pair = first; pair < first + contacts[k].gap.size(); ++pair)
      for (NodalRows::InnerIterator it(old, pair); it; ++it)
        all.edge(pair) = std::max(all.edge(pair), length(it.col() / 2));
    const Obstacle* obstacle = std::get_if<Obstacle>(&contact.target);
    if (contacts[k].linear || (obstacle != nullptr && obstacle->linear)) {
      following.stay(first, contacts[k].gap.size());
      continue;
    }
    auto [pairs, lost] = found_pairs(contact, there);
    following.match(source, pairs, k, first, contacts[k]);
    all.lost[k] = std::move(lost);
  }
  following.finish();
  return all;
}

}  // namespace signorini
