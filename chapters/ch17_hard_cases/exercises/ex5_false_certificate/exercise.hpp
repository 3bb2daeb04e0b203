/// \file
/// Exercise 17.5 - a false certificate. Do not change this file.
#pragma once
#include <string>
#include <vector>

#include "signorini/problem/certificate.hpp"

namespace ex17_5 {

/// An answer as somebody hands it in, with the certificate that is printed below it.
struct Document {
  std::string author;              ///< who
  signorini::PrimalDual answer;    ///< u, in one part or two, and lambda
  signorini::Certificate printed;  ///< figures; those of friction are 0 here
};

/// The problem that all documents are about: four carts in a row, springs of stiffness 1 between them and from the first to a wall;
/// stops 2 ahead of the second and 4 ahead of the fourth cart.
/// \return K, p, A, g
inline signorini::QuadraticProgramme posed() {
  Eigen::Matrix4d K;
  K << 2, -1, 0, 0, -1, 2, -1, 0, 0, -1, 2, -1, 0, 0, -1, 1;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2, 4);
  A(0, 1) = A(1, 3) = 1;
  return {K.sparseView(), Eigen::Vector4d(0, 1.5, 0, 0.5), A.sparseView(), Eigen::Vector2d(2, 4)};
}

/// \return what was handed in; figures in the order penetration, tension, complementarity, equilibrium, duality gap
inline std::vector<Document> documents() {
  using Eigen::Vector2d, Eigen::Vector4d;
  const Vector4d u(1, 2, 2.5, 3);
  return {{"Ada", {u, {}, Vector2d(1, 0)}, {0, 0, 0, 0, 0}},
          {"Ben", {Vector4d(1.25, 2.5, 3, 3.5), {}, Vector2d(0.75, 0)}, {0, 0, 0, 0, 0}},
          {"Cora", {Vector4d(2, 4, 4.5, 5), {}, Vector2d(0, 0)}, {0.41, 0, 0, 0, 0}},
          {"Dan", {Vector4d(1, 2, 2, 2), {}, Vector2d(0.5, 0)}, {0, 0, 0, 0, 0}},
          {"Eve", {u, {}, Vector2d(1, 0)}, {1e-9, 1e-9, 1e-9, 1e-9, 1e-9}},
          {"Finn", {u, {}, Vector2d(1, -0.25)}, {0, 0, 0.06, 0.34, 0.2}}};
}

/// Figures that a certificate states too small, recomputed from the data as they were posed.
/// \param posed     K, p, A, g; without friction
/// \param document  answer and certificate
/// \return "penetration", "tension", "complementarity", "equilibrium", "duality gap", in this order: those that are more than twice
///   what is printed and above 1e-15, and those for which something is printed that no such figure can be, below 0 or no number
/// \throws std::invalid_argument as signorini::certify(), if sizes do not fit
[[nodiscard]] std::vector<std::string> understated(const signorini::QuadraticProgramme& posed,
                                                   const Document& document);

/// What to think of documents: each number stands in one list.
struct Opinion {
  std::vector<std::size_t> believed;  ///< honest, and the true figures are at most 1e-12
  std::vector<std::size_t>
      bad;  ///< honest, and a true figure is larger: no solution, but the document says so
  std::vector<std::size_t> untrue;  ///< a figure is understated
};

/// Reads a pile of documents.
/// \param posed  K, p, A, g
/// \param pile   any number of documents
/// \return their numbers from 0, increasing in each list
/// \throws std::invalid_argument as understated()
[[nodiscard]] Opinion read(const signorini::QuadraticProgramme& posed,
                           const std::vector<Document>& pile);

}  // namespace ex17_5
