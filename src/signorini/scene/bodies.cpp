// # Several bodies in one numbering
//
// The library solves one system for all bodies. Their nodes are numbered one after another,
// and so are their unknowns. Let a first body have 4 nodes, of which a support holds one in
// both directions, and a second one 6 free nodes. Then the nodes of the second are 4 to 9,
// its unknowns 6 to 17, and
// \f[ K = \begin{pmatrix} K_1 & 0 \\ 0 & K_2 \end{pmatrix}, \f]
// with 6 and 12 rows. Nothing in K joins the blocks. Only rows of A have entries of two
// bodies. This file translates between a body and the whole, and between the names of a
// scene and the numbers.
//
// The order of the numbers is the order of the bodies in the scene. So a number of a node
// tells its body, and one offset per body is all that has to be stored.

#include "signorini/scene/bodies.hpp"

#include <algorithm>
#include <utility>

#include "signorini/core/errors.hpp"

namespace signorini {

using Eigen::Index;

// Forces on held components are dropped here. They go into the support, and no unknown feels
// them.
void add_nodal_forces(const BodyModel& body, const NodeArray& forces, Eigen::VectorXd& load) {
  load.segment(body.first_unknown, body.unknowns.count) += restricted(body.unknowns, forces);
}

// With one body, a side need not name it. With several, a missing name is as wrong as an
// unknown one, and the message lists those that exist.
std::size_t body_index(const std::vector<BodyModel>& bodies, const Side& side) {
  if (side.body.empty() && bodies.size() == 1) return 0;
  std::string names;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].mesh.name == side.body) return b;
  for (const BodyModel& one : bodies) names += (names.empty() ? "'" : ", '") + one.mesh.name + "'";
  throw ProblemError(text("boundary '", side.boundary, "': there is no body '", side.body,
                          "'; the scene has ", names));
}

// Gap operators know surfaces and no bodies. The call of boundary() is for its error: a
// wrong name is reported here, where the body is known.
Surface surface(const std::vector<BodyModel>& bodies, const Side& side) {
  const BodyModel& own = bodies[body_index(bodies, side)];
  static_cast<void>(boundary(own.mesh, side.boundary));
  return {own.mesh, side.boundary, own.first_node};
}

// Nodes of all bodies are numbered from 0, so their number is where the last body ends.
Index count_nodes(const std::vector<BodyModel>& bodies) {
  return bodies.empty() ? 0 : bodies.back().first_node + bodies.back().mesh.n_nodes();
}

// Bodies are few, so we go through them from the last one to the first.
std::size_t body_of_node(const std::vector<BodyModel>& bodies, Index node) {
  std::size_t body = bodies.size() - 1;
  while (bodies[body].first_node > node) --body;
  return body;
}

// Unknowns end in the same way: the last body has the last one.
Index count_unknowns(const std::vector<BodyModel>& bodies) {
  return bodies.back().first_unknown + bodies.back().unknowns.count;
}

// Messages are sentences and name a contact by quoted names. Tables have little room and
// take the short form of a scene file, which the next function makes.
std::string describe(const std::vector<BodyModel>& bodies, const ContactSpec& contact) {
  const auto name = [&bodies](const Side& side) {
    return text('\'', side.boundary, "' of '", bodies[body_index(bodies, side)].mesh.name, '\'');
  };
  if (const Obstacle* obstacle = std::get_if<Obstacle>(&contact.target))
    return text("contact of ", name(contact.source), " with a rigid ", obstacle->name);
  return text("contact of ", name(contact.source), " with ", name(std::get<Side>(contact.target)));
}

// A disc between two half-planes has two contacts, each called "disc.rim on half plane". A
// reader of the table must tell them apart, so the second gets a number. Names stay as they
// are if a contact is added behind them.
std::vector<std::string> contact_names(const std::vector<BodyModel>& bodies,
                                       const std::vector<ContactSpec>& contacts) {
  const auto name = [&bodies](const Side& side) {
    return text(bodies[body_index(bodies, side)].mesh.name, '.', side.boundary);
  };
  std::vector<std::string> names;
  for (const ContactSpec& contact : contacts) {
    const Obstacle* const obstacle = std::get_if<Obstacle>(&contact.target);
    const std::string other = obstacle ? obstacle->name : name(std::get<Side>(contact.target));
    const std::string plain = text(name(contact.source), " on ", other);
    std::string own = plain;
    for (int count = 2; std::find(names.begin(), names.end(), own) != names.end(); ++count)
      own = text(plain, " (", count, ')');
    names.push_back(std::move(own));
  }
  return names;
}

// In axial symmetry x is a radius. Much that is true in the plane is not true there: forces
// along x cancel round the circle, and the only rigid motion goes along the axis.
bool is_axial(const BodyModel& body) { return body.material.base.state == PlaneState::Axial; }

// Along the radius, the forces of one half of a section do not cancel in the sum over nodes.
// Those of the whole circle do: its resultant has no radial part.
Eigen::Vector2d sum_of_forces(const BodyModel& body, const NodeArray& forces) {
  Eigen::Vector2d sum = forces.colwise().sum().transpose();
  if (is_axial(body)) sum.x() = 0;
  return sum;
}

// A law with \f$ \mu = 0 \f$ and no cohesion allows no friction force. It must cost nothing,
// so it counts as absent.
bool has_friction(const ContactSpec& contact) {
  return contact.friction &&
         (contact.friction->coefficient != 0 || contact.friction->cohesion != 0);
}

// The programme has one formula for all rows, \f$ g - Au \f$. A slip is \f$ s_0 + Tu \f$, so
// its row of A is that of T with the opposite sign.
NodalRows contact_rows(const Gaps& gaps, const FrictionLaw& law) {
  return below(gaps.A, -selected_rows(gaps.T, law.pair));
}

// The plan has all numbers of contact already, because pairs must be found to be counted. So
// the numbers are moved to where the programme has them, and nothing is computed.
void take_gaps(Model& model) {
  model.programme.A.swap(model.gaps.A);
  model.programme.initial_gap = model.gaps.pairs.initial_gap;
  model.pairs = std::move(model.gaps.pairs);
}

// K is large. One body hands over its block without a copy. Several blocks are written
// column by column in the order of storage, so that nothing is sorted, and each block is
// freed as soon as it is written. Room for one block more copies all that is there, so of many
// small blocks the storage grows by itself, which doubles it.
void put_along_diagonal(const std::vector<BodyModel>& bodies,
                        std::vector<Eigen::SparseMatrix<double>>& blocks,
                        Eigen::SparseMatrix<double>& all) {
  if (blocks.size() == 1) return all.swap(blocks.front());
  const Index count = count_unknowns(bodies);
  all.resize(count, count);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Index first = bodies[b].first_unknown;
    if (blocks.size() <= 16) all.reserve(all.nonZeros() + blocks[b].nonZeros());
    for (Index k = 0; k < blocks[b].cols(); ++k) {
      all.startVec(first + k);
      for (Eigen::SparseMatrix<double>::InnerIterator it(blocks[b], k); it; ++it)
        all.insertBack(first + it.row(), first + k) = it.value();
    }
    blocks[b] = {};
  }
  all.finalize();
}

// Where an unknown is matters to a back end that orders the elimination by cutting the body
// into parts. The others do not ask.
NodeArray unknown_positions(const Plan& plan) {
  NodeArray positions(plan.unknowns.count, 2);
  for (const BodyModel& body : plan.bodies)
    positions.middleRows(body.first_unknown, body.unknowns.count) =
        unknown_positions(body.mesh, body.unknowns);
  return positions;
}

// A layer counts as the body does.
bool any_law(const Scene& scene) {
  const auto has_law = [](const auto& part) { return part.material.law != nullptr; };
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& body) {
    return has_law(body) || std::any_of(body.layers.begin(), body.layers.end(), has_law);
  });
}

// A law of finite strain is written for places that the body comes to.
bool bodies_move(const Scene& scene) { return scene.moves || any_law(scene); }

// Two histories may press first and drag later. What both give together then, as if each had
// its value 1, is given at no time.
void each_given(const Scene& scene, const Plan& draft,
                const std::function<void(const NodeArray&, std::optional<double>)>& visit) {
  if (!scene.path || draft.standing) return visit(draft.unknowns.held, {});
  NodeArray held(draft.unknowns.held.rows(), 2);
  for (const double time : scene.path->times) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const BodyModel& body = draft.bodies[b];
      std::vector<Support> supports = scene.bodies[b].supports;
      for (Support& support : supports)
        support.displacement = [factor = factor_of(scene.path->histories, support.history, time),
                                full = support.displacement](const Eigen::Vector2d& x) {
          return Eigen::Vector2d(factor * full(x));
        };
      held.middleRows(body.first_node, body.mesh.n_nodes()) =
          number_unknowns(body.mesh, supports, body.material.base.state).held;
    }
    visit(held, time);
  }
}

// The share is a number from 0 to 1 that varies along the source.
double interference_at(const ContactSpec& contact, const Eigen::Vector2d& x) {
  return contact.interference.value_or(0) *
         (contact.interference_share ? contact.interference_share(x) : 1);
}

// Gaps of the plan are less all of it.
double interference_to_come(const Scene& scene, const ContactSpec& contact,
                            const Eigen::Vector2d& x, std::optional<double> time) {
  const std::string& history = contact.interference_history;
  return time ? (1 - factor_of(scene.path->histories, history, *time)) * interference_at(contact, x)
              : 0;
}

}  // namespace signorini
