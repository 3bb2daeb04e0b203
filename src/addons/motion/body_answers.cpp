// # What bodies answer
//
// A step of bodies that move asks for forces at a place that may be far from the scene, and wants the last digit of them. Two
// things take digits away. Carried by 1e4 of its sizes, a body has displacements of 1e4 whose differences, 1e-3, are all that
// counts: a product with K would leave 1e-9 of them. So each cell is asked for itself, with displacements less those of its
// first node. And the displacements are sums of two doubles, or the strain of 1e-3 would be rounded by 1e-12.
//
// In axial symmetry a shift along the radius strains the body, and is not taken out.

#include "addons/motion/body_answers.hpp"

#include <algorithm>

#include "addons/equations/take_equations.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/eigenstrain.hpp"
#include "signorini/fem/strain_law.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;

/// One cell among the unknowns of all bodies.
struct Numbers {
  const Unknowns& unknowns;
  Index first_node;
  const Cell& cell;

  [[nodiscard]] Index unknown(Index k) const {
    return unknowns.number(first_node + cell.node(k / 2), k % 2);
  }
};

/// Where the entries of a cell are among the values of K, which has all of them, column by column; -1 of held components.
void find_places(const Numbers& numbers, Eigen::SparseMatrix<double>& K, int* place) {
  const Index n = 2 * numbers.cell.element.n_nodes;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index row = numbers.unknown(i);
      const Index column = numbers.unknown(j);
      *place++ = row < 0 || column < 0
                     ? -1
                     : static_cast<int>(&K.coeffRef(row, column) - K.valuePtr());
    }
}

/// Adds a matrix of a cell, so many times, to those values.
void add_values(const CellMatrix& cell, double times, const int* place,
                Eigen::SparseMatrix<double>& K) {
  for (Index k = 0; k < cell.size(); ++k)
    if (place[k] >= 0) K.valuePtr()[place[k]] += times * cell.data()[k];
}

/// Springs pull along fixed axes, however far they are drawn.
void add_springs(const BodyModel& body, const NodeArray& own, VectorXd& sum) {
  NodeArray pulled(own.rows(), 2);
  pulled.reshaped<Eigen::RowMajor>() = body.springs * own.reshaped<Eigen::RowMajor>();
  add_nodal_forces(body, pulled, sum);
}

}  // namespace

double rounding_of_places(double within, double whole) {
  return 4 * epsilon * (within + epsilon * whole);
}

BodyAnswers::BodyAnswers(const Model& model) : rest_(stiffness_of_bodies(model)) {
  for (const BodyModel& body : model.bodies) {
    const Index entries = 4 * body.element.n_nodes * body.element.n_nodes;
    const bool finite = body.material.base.law != nullptr;
    finite_ = finite_ || finite;
    BodyAtRest& own = bodies_.emplace_back();
    own.farthest = body.mesh.nodes.cwiseAbs().maxCoeff();
    if (finite)
      own.places.resize(entries, body.mesh.n_cells());
    else
      own.stiffness.resize(entries, body.mesh.n_cells());
    visit_cells(body.mesh, body.element, body.material, [&](const Cell& cell) {
      const CellMatrix K = cell_stiffness(cell.element, cell.body);
      if (!finite) {
        own.stiffness.col(cell.number).head(K.size()) =
            Eigen::Map<const VectorXd>(K.data(), K.size());
        return;
      }
      int* const place = own.places.col(cell.number).data();
      find_places({model.unknowns, body.first_node, cell}, rest_, place);
      add_values(K, -1, place, rest_);
    });
  }
}

void BodyAnswers::ask(const Cell& cell, const BodyAtRest& rest, const CellVector& u,
                      CellAnswer& answer) {
  if (cell.material.law != nullptr) return cell.material.law->answer(cell, u, answer);
  const Index n = u.size();
  answer.tangent = Eigen::Map<const Eigen::MatrixXd>(rest.stiffness.col(cell.number).data(), n, n);
  answer.force = answer.tangent * u;
}

BodyAnswer BodyAnswers::at(const Model& model, const Displaced& at, const NodeArray& going_on,
                           Eigen::SparseMatrix<double>* tangent) const {
  const Index n = model.unknowns.count;
  BodyAnswer all{VectorXd::Zero(n), VectorXd::Zero(n), VectorXd::Zero(n)};
  if (tangent != nullptr) *tangent = rest_;
  CellAnswer answer;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    const BodyAtRest& rest = bodies_[b];
    const auto own = [&](const NodeArray& nodes) {
      return NodeArray(nodes.middleRows(body.first_node, body.mesh.n_nodes()));
    };
    const NodeArray high = own(at.high), low = own(at.low), ahead = own(going_on);
    visit_cells(body.mesh, body.element, body.material, [&](const Cell& cell) {
      const CellVector u = less_shift(cell, high) + less_shift(cell, low);
      const Numbers numbers{model.unknowns, body.first_node, cell};
      ask(cell, rest, u, answer);
      if (tangent != nullptr && rest.places.size() > 0)
        add_values(answer.tangent, 1, rest.places.col(cell.number).data(), *tangent);
      const CellVector push = answer.tangent * gathered(cell, ahead);
      const double farthest = rest.farthest + gathered(cell, high).cwiseAbs().maxCoeff();
      const double size = answer.force.cwiseAbs().maxCoeff() +
                          answer.tangent.diagonal().maxCoeff() *
                              rounding_of_places(u.cwiseAbs().maxCoeff(), farthest) /
                              certificate_tolerance;
      for (Index k = 0; k < answer.force.size(); ++k)
        if (const Index row = numbers.unknown(k); row >= 0) {
          all.force(row) += answer.force(k);
          all.terms(row) += size;
          all.ahead(row) += push(k);
        }
    });
    if (body.springs.rows() == 0) continue;
    add_springs(body, high, all.force);
    add_springs(body, high.cwiseAbs(), all.terms);
    add_springs(body, ahead, all.ahead);
  }
  return all;
}

VectorXd outer_forces(const Model& model) {
  VectorXd load = VectorXd::Zero(model.unknowns.count);
  for (const BodyModel& body : model.bodies) {
    NodeArray nodal = nodal_loads(body.mesh, body.element, body.material, body.loads);
    if (body.material.eigenstrain)
      nodal += eigenstrain_forces(body.mesh, body.element, body.material);
    add_nodal_forces(body, nodal, load);
  }
  return load;
}

}  // namespace signorini
