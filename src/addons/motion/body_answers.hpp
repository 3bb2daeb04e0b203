// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What the bodies of a model answer to displacements: internal forces, and the tangent of those with a law.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "signorini/fem/strain_law.hpp"
#include "signorini/scene/step_loop.hpp"

namespace signorini {

/// What rounding may have done to displacements: a cell that has turned strains by what little its terms leave, and what is closed
/// stands at the sum of a place in the mesh and a displacement.
/// \param within  the largest displacement less that of the first node of its cell, 0 if places alone count [length]
/// \param whole   the largest place, in two doubles [length] \return [length]
[[nodiscard]] double rounding_of_places(double within, double whole);

/// What the bodies of a model answer at a place.
struct BodyAnswer {
  Eigen::VectorXd force;  ///< `n` internal forces on the unknowns, springs too [force]
  /// `n` how large they are that cancel: of all cells of an unknown the largest internal force, and a force whose
  /// certificate_tolerance is what rounding makes of their displacements, summed [force]
  Eigen::VectorXd terms;
  Eigen::VectorXd ahead;  ///< `n` what the supports will add when they go on [force]
};

/// The bodies of a model, cell by cell. Cells of small strain answer with their stiffness, which is computed once; forces are
/// taken from displacements less those of the first node of a cell, in two doubles: a body that is carried far keeps the
/// digits of its strain.
class BodyAnswers {
 public:
  /// \param model  from build(), with the K of its bodies before strain; is not referred to later
  explicit BodyAnswers(const Model& model);

  /// \param model      the same
  /// \param at         where its bodies are
  /// \param going_on   `n_nodes x 2` what supports move until the end of the step, 0 elsewhere [length]
  /// \param[out] tangent  if not null: K of the model with the tangents of cells that have a law
  /// \return forces
  /// \throws ProblemError if a cell inverts
  [[nodiscard]] BodyAnswer at(const Model& model, const Displaced& at, const NodeArray& going_on,
                              Eigen::SparseMatrix<double>* tangent) const;

  /// \return whether any cell has a law, so that K changes
  [[nodiscard]] bool finite() const { return finite_; }

 private:
  struct BodyAtRest {
    double farthest = 0;  // place of a node from the origin
    // One or the other, a column for each cell:
    Eigen::MatrixXd stiffness;  // of small strain: K of the cell
    Eigen::MatrixXi places;     // with a law: of its entries among the values of K
  };

  static void ask(const Cell& cell, const BodyAtRest& rest, const CellVector& u,
                  CellAnswer& answer);

  std::vector<BodyAtRest> bodies_;
  Eigen::SparseMatrix<double> rest_;  // K before strain, without the cells that have a law
  bool finite_ = false;
};

/// \param model  with loads of its time
/// \return `n` its loads on the unknowns, of temperatures too, not what supports cause [force]
[[nodiscard]] Eigen::VectorXd outer_forces(const Model& model);

}  // namespace signorini
