#include "signorini/scene/bodies.hpp"

#include <algorithm>
#include <utility>

#include "signorini/core/errors.hpp"

namespace signorini {

using Eigen::Index;

namespace {

/// Some cells of a body, and all of its nodes.
Eigen::SparseMatrix<double> stiffness_of_cells(const BodyModel& body, Index first, Index count) {
  if (count == 0) return {body.unknowns.count, body.unknowns.count};
  Mesh part = body.mesh;
  part.cells = body.mesh.cells.middleRows(first, count).eval();
  MaterialField material = body.material;
  material.eigenstrain = {};
  if (const auto begin = material.number_of.begin() + first; !material.number_of.empty())
    material.number_of = {begin, begin + count};
  bool triangles = true;  // beside the quadrilaterals of other shares
  for (Index cell = 0; cell < count; ++cell) triangles = triangles && part.corners(cell) == 3;
  const bool beside = triangles && body.element.corners() != 3;
  Eigen::SparseMatrix<double> K;
  assemble(part, beside ? triangle_beside(part) : body.element, material, body.unknowns, {})
      .stiffness.swap(K);  // a move would copy it
  return K;
}

}  // namespace

void add_nodal_forces(const BodyModel& body, const NodeArray& forces, Eigen::VectorXd& load) {
  load.segment(body.first_unknown, body.unknowns.count) += restricted(body.unknowns, forces);
}

void add_springs(const BodyModel& body, QuadraticProgramme& programme) {
  const auto number = [&body](Index component) {
    const Index own = body.unknowns.number(component / 2, component % 2);
    return own < 0 ? own : body.first_unknown + own;
  };
  for (Index k = 0; k < body.springs.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(body.springs, k); it; ++it) {
      const Index row = number(it.row());
      const Index column = number(it.col());
      if (row < 0) continue;
      if (column >= 0)
        programme.stiffness.coeffRef(row, column) += it.value();
      else
        programme.load(row) -= it.value() * body.unknowns.held(it.col() / 2, it.col() % 2);
    }
}

Eigen::SparseMatrix<double> stiffness_share(const std::vector<BodyModel>& bodies, int part,
                                            int parts) {
  require_argument(part >= 0 && part < parts, "stiffness_share: expected a share from 0 to ",
                   parts - 1, ", got ", part);
  std::vector<Eigen::SparseMatrix<double>> blocks;
  for (const BodyModel& body : bodies) {
    const Index first = body.mesh.n_cells() * part / parts;
    const Index end = body.mesh.n_cells() * (part + 1) / parts;
    blocks.push_back(stiffness_of_cells(body, first, end - first));
  }
  QuadraticProgramme share;
  put_along_diagonal(bodies, blocks, share.stiffness);
  share.load = Eigen::VectorXd::Zero(count_unknowns(bodies));
  if (part == 0)
    for (const BodyModel& body : bodies) add_springs(body, share);
  share.stiffness.makeCompressed();
  Eigen::SparseMatrix<double> K;
  share.stiffness.swap(K);
  return K;
}

std::size_t body_index(const std::vector<BodyModel>& bodies, const Side& side) {
  if (side.body.empty() && bodies.size() == 1) return 0;
  std::string names;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].mesh.name == side.body) return b;
    names += (b == 0 ? "'" : ", '") + bodies[b].mesh.name + "'";
  }
  throw ProblemError(text("boundary '", side.boundary, "': there is no body '", side.body,
                          "'; the scene has ", names));
}

Surface surface(const std::vector<BodyModel>& bodies, const Side& side) {
  const BodyModel& own = bodies[body_index(bodies, side)];
  static_cast<void>(boundary(own.mesh, side.boundary));
  return {own.mesh, side.boundary, own.first_node};
}

Index count_nodes(const std::vector<BodyModel>& bodies) {
  return bodies.back().first_node + bodies.back().mesh.n_nodes();
}

std::size_t body_of_node(const std::vector<BodyModel>& bodies, Index node) {
  std::size_t body = bodies.size() - 1;
  while (bodies[body].first_node > node) --body;
  return body;
}

Index count_unknowns(const std::vector<BodyModel>& bodies) {
  return bodies.back().first_unknown + bodies.back().unknowns.count;
}

std::string describe(const std::vector<BodyModel>& bodies, const ContactSpec& contact) {
  const auto name = [&bodies](const Side& side) {
    return text('\'', side.boundary, "' of '", bodies[body_index(bodies, side)].mesh.name, '\'');
  };
  if (const Obstacle* obstacle = std::get_if<Obstacle>(&contact.target))
    return text("contact of ", name(contact.source), " with a rigid ", obstacle->name);
  return text("contact of ", name(contact.source), " with ", name(std::get<Side>(contact.target)));
}

std::vector<std::string> contact_names(const std::vector<BodyModel>& bodies,
                                       const std::vector<ContactSpec>& contacts) {
  const auto name = [&bodies](const Side& side) {
    return text(bodies[body_index(bodies, side)].mesh.name, '.', side.boundary);
  };
  std::vector<std::string> names;
  for (const ContactSpec& contact : contacts) {
    const Obstacle* const obstacle = std::get_if<Obstacle>(&contact.target);
    const std::string plain =
        text(name(contact.source), " on ",
             obstacle != nullptr ? obstacle->name : name(std::get<Side>(contact.target)));
    std::string own = plain;
    for (int count = 2; std::find(names.begin(), names.end(), own) != names.end(); ++count)
      own = text(plain, " (", count, ')');
    names.push_back(std::move(own));
  }
  return names;
}

bool is_axial(const BodyModel& body) { return body.material.base.state == PlaneState::Axial; }

Eigen::Vector2d sum_of_forces(const BodyModel& body, const NodeArray& forces) {
  Eigen::Vector2d sum = forces.colwise().sum().transpose();
  if (is_axial(body)) sum.x() = 0;
  return sum;
}

bool has_friction(const ContactSpec& contact) {
  return contact.friction &&
         (contact.friction->coefficient != 0 || contact.friction->cohesion != 0);
}

NodalRows contact_rows(const Gaps& gaps, const FrictionLaw& law) {
  return below(gaps.A, -selected_rows(gaps.T, law.pair));
}

void put_along_diagonal(const std::vector<BodyModel>& bodies,
                        std::vector<Eigen::SparseMatrix<double>>& blocks,
                        Eigen::SparseMatrix<double>& all) {
  if (blocks.size() == 1) return all.swap(blocks.front());
  const Index count = count_unknowns(bodies);
  all.resize(count, count);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Index first = bodies[b].first_unknown;
    all.reserve(all.nonZeros() + blocks[b].nonZeros());
    for (Index k = 0; k < blocks[b].cols(); ++k) {
      all.startVec(first + k);
      for (Eigen::SparseMatrix<double>::InnerIterator it(blocks[b], k); it; ++it)
        all.insertBack(first + it.row(), first + k) = it.value();
    }
    blocks[b] = {};
  }
  all.finalize();
}

NodeArray unknown_positions(const std::vector<BodyModel>& bodies) {
  NodeArray positions(count_unknowns(bodies), 2);
  for (const BodyModel& body : bodies)
    positions.middleRows(body.first_unknown, body.unknowns.count) =
        unknown_positions(body.mesh, body.unknowns);
  return positions;
}

NodeArray unknown_positions(const Model& model) { return unknown_positions(model.bodies); }

}  // namespace signorini
