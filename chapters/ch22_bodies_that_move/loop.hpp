// Chapter 22 - Contact of bodies that move, as a loop of linear contact problems.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "signorini/contact/gaps.hpp"
#include "signorini/pairing/interface.hpp"
#include "signorini/scene/scene.hpp"
#include "signorini/solvers/portfolio.hpp"

namespace ch22 {

using namespace signorini;
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

const double rounding = 1e-12;  // of a move, beside bodies of size 1 [length]

/// Two bodies: the first one is held at its bottom, the top of the second one is moved by hand.
struct Two {
  Body base, tool;
  std::string source_of_tool;  ///< its side; that of the base is its top
  double friction = 0.3;
  const char* gap_operator = "mortar";
};

/// What is known of them before they move.
struct Assembled {
  Two of;
  Model model;    // K, unknowns, where nodes stand
  Factor factor;  // of K, the only one
};

/// Where the bodies are, and how the loop got there.
struct Place {
  NodeArray u;                 // `n_nodes x 2` from the scene [length]
  std::vector<double> moves;   // by how much each iteration moved a node at most [length]
  Gaps gaps;                   // of the last iteration
  ContactState contact;        // of the last iteration
  bool arrived = true;         // whether the last move is rounding
};

inline Assembled assembled(const Two& of) {
  Scene scene;
  scene.bodies = {of.base, of.tool};
  Ledger ledger;
  Model model = build(scene, ledger);
  Factor factor = default_backend().factor({model.programme.stiffness, model.programme.A}, ledger);
  return {of, std::move(model), std::move(factor)};
}

/// A mesh whose nodes have moved.
inline Mesh moved_by(const BodyModel& body, const NodeArray& u) {
  Mesh mesh = body.mesh;
  mesh.nodes += u.middleRows(body.first_node, mesh.n_nodes());
  return mesh;
}

inline NodeArray places(const Model& model, const NodeArray& u) {
  NodeArray all(u.rows(), 2);
  for (const BodyModel& body : model.bodies)
    all.middleRows(body.first_node, body.mesh.n_nodes()) = moved_by(body, u).nodes;
  return all;
}

/// Pairs where the bodies are; slips count from where they were before.
inline Pairs pairs_at(const Assembled& bodies, const NodeArray& u, const NodeArray& before) {
  const Mesh base = moved_by(bodies.model.bodies[0], u), tool = moved_by(bodies.model.bodies[1], u);
  const NodeArray moved = u - before;
  GapOptions options;
  options.n_nodes = u.rows();
  options.sliding = bodies.of.friction > 0;
  options.since = &moved;
  return find_gap_operator(bodies.of.gap_operator)
      .pair({tool, bodies.of.source_of_tool, bodies.model.bodies[1].first_node}, {base, "top", 0},
            options);
}

/// The same for what supports leave free.
inline Gaps gaps_at(const Assembled& bodies, const NodeArray& u, const NodeArray& before) {
  const BodyModel& tool = bodies.model.bodies[1];
  return reduce(pairs_at(bodies, u, before),
                {tool.mesh, bodies.of.source_of_tool, tool.first_node}, bodies.model.unknowns);
}

/// What stresses leave out of balance: minus the internal forces of linear elasticity.
inline VectorXd out_of_balance(const Model& model, const NodeArray& u) {
  NodeArray force(u.rows(), 2);
  for (const BodyModel& body : model.bodies)
    force.middleRows(body.first_node, body.mesh.n_nodes()) =
        internal_forces(body.mesh, body.element, body.material,
                        u.middleRows(body.first_node, body.mesh.n_nodes()));
  return -restricted(model.unknowns, force);
}

/// Rows of gaps, and of slips below them.
inline NodalRows rows_of(const Gaps& gaps) {
  return gaps.T.nonZeros() == 0 ? gaps.A : below(gaps.A, -gaps.T);
}

/// What the rows of this place say of contact, but for the load: compliance and law.
inline ContactProblem problem_here(const Assembled& bodies, const Gaps& gaps, const NodalRows& A) {
  Ledger ledger;
  const Index n = gaps.pairs.weight.size();
  ContactProblem problem{bodies.factor.compliance(A, ledger), gaps.pairs.initial_gap};
  if (A.rows() > n)
    problem.law = law_of_all(VectorXd::Constant(n, bodies.of.friction), VectorXd::Zero(n));
  return problem;
}

inline VectorXd forces_of(const ContactState& contact) {
  VectorXd all(contact.force.size() + contact.friction.size());
  all << contact.force, contact.friction;
  return all;
}

/// What contact does to all nodes.
inline NodeArray pushes(const Assembled& bodies, const Place& place) {
  VectorXd all = place.gaps.pairs.opening.transpose() * place.contact.force;
  if (place.contact.friction.size() > 0)
    all += place.gaps.pairs.sliding.transpose() * place.contact.friction;
  return Eigen::Map<const NodeArray>(all.data(), bodies.model.unknowns.number.rows(), 2);
}

/// The way to the answer of the linear contact problem of a place: two solves with the factor, and the small problem.
/// \param A        rows of gaps, then of slips `n_c + n_s` x `n`
/// \param load     `n` [N]
/// \param problem  of A; gets the movements that this load makes without contact
/// \param contact  becomes the answer
/// \return d `n` [length]
inline VectorXd way(const Assembled& bodies, const Gaps& gaps, const NodalRows& A,
                    const VectorXd& load, ContactProblem& problem, ContactState& contact) {
  const VectorXd free = bodies.factor.solve(load);
  const VectorXd moved = A * free;
  const Index n = gaps.pairs.weight.size();
  problem.free_gap = gaps.pairs.initial_gap - moved.head(n);
  if (A.rows() > n) problem.free_slip = gaps.initial_slip - moved.tail(n);
  contact = solve(problem, bodies.model.solver);
  return free - bodies.factor.solve(A.transpose() * forces_of(contact));
}

/// What contact forces do along a way because they turn: a difference over 1e-8 in length, beside bodies of size 1. Nothing where
/// that place has pairs of another number.
/// \param now  with the contact forces \param A  its rows \param d  `n` the way [length]
/// \return `n` [N]
inline VectorXd turned(const Assembled& bodies, const Place& now, const NodeArray& before,
                              const NodalRows& A, const VectorXd& d) {
  const double part = 1e-8 / std::max(d.cwiseAbs().maxCoeff(), 1e-300);
  // [turned]
  const NodeArray ahead = now.u + part * expand(bodies.model.unknowns, d);
  const NodalRows there = rows_of(gaps_at(bodies, ahead, before));
  if (there.rows() != A.rows()) return VectorXd::Zero(d.size());
  return (A - there).transpose() * forces_of(now.contact) / part;
  // [turned]
}

/// One step, from where the last one ended; the hand is already at its new place.
/// \param before       `n_nodes x 2` from the scene to the end of the last step [length]
/// \param hand         displacement of the top of the tool [length]
/// \param most         iterations
/// \param corrections  how often an iteration lets contact forces turn along the way that it has found
inline Place step(const Assembled& bodies, const NodeArray& before, const Vector2d& hand,
                  std::size_t most = 60, int corrections = 0) {
  const Model& model = bodies.model;
  Place now{before, {}, {}, {}};
  for (const Index node : boundary_nodes(model.bodies[1].mesh, "top"))
    now.u.row(model.bodies[1].first_node + node) = hand.transpose();
  // [loop]
  do {
    now.gaps = gaps_at(bodies, now.u, before);  // pairs where the bodies are,
    const NodalRows A = rows_of(now.gaps);      // frozen until the next iteration
    ContactProblem problem = problem_here(bodies, now.gaps, A);
    const VectorXd load = out_of_balance(model, now.u);
    VectorXd d = way(bodies, now.gaps, A, load, problem, now.contact);
    for (int k = 0; k < corrections; ++k)
      d = way(bodies, now.gaps, A, load + turned(bodies, now, before, A, d), problem, now.contact);
    now.u += expand(model.unknowns, d);
    now.moves.push_back(d.cwiseAbs().maxCoeff());
  } while (now.moves.back() > rounding && now.moves.size() < most);
  // [loop]
  now.arrived = now.moves.back() <= rounding;
  return now;
}

}  // namespace ch22
