// Stiffness matrices and graphs for the tests of the factor.
#pragma once
#include <string>
#include <vector>

#include "addons/frontal/frontal_factor.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/elements.hpp"
#include "support/meshes.hpp"

namespace signorini_test {

/// A matrix, and where its unknowns are.
struct Placed {
  std::string name;
  Eigen::SparseMatrix<double> K;
  signorini::NodeArray positions;
};

inline Placed stiffness(const std::string& name, const signorini::Mesh& mesh,
                        const signorini::Element& element,
                        const std::vector<signorini::Support>& supports) {
  const signorini::Unknowns unknowns = signorini::number_unknowns(mesh, supports);
  const signorini::Material material{7, 0.3, signorini::PlaneState::Strain, 1};
  return {name, signorini::assemble(mesh, element, material, unknowns, {}).stiffness,
          signorini::unknown_positions(mesh, unknowns)};
}

/// Two matrices that know nothing of each other, one behind the other.
inline Placed beside(const Placed& a, const Placed& b) {
  using Triplet = Eigen::Triplet<double>;
  std::vector<Triplet> entries;
  const auto take = [&](const Eigen::SparseMatrix<double>& K, Eigen::Index shift) {
    for (Eigen::Index column = 0; column < K.cols(); ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(K, column); entry; ++entry)
        entries.emplace_back(entry.row() + shift, column + shift, entry.value());
  };
  take(a.K, 0);
  take(b.K, a.K.cols());
  const Eigen::Index n = a.K.cols() + b.K.cols();
  Placed both{a.name + " and " + b.name, Eigen::SparseMatrix<double>(n, n), {}};
  both.K.setFromTriplets(entries.begin(), entries.end());
  both.positions.resize(n, 2);
  both.positions << a.positions, b.positions;
  return both;
}

/// A random positive definite matrix; entries are as dense as asked, between 0 and 1, and positions are random.
inline Placed random_matrix(Eigen::Index n, double density, std::uint64_t seed) {
  Random random(seed);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < j; ++i)
      if (random.uniform(0, 1) < density) dense(i, j) = dense(j, i) = random.uniform(-1, 1);
  dense.diagonal() = dense.cwiseAbs().rowwise().sum().array() + 0.1;
  Placed placed{"random", dense.sparseView(), signorini::NodeArray(n, 2)};
  for (Eigen::Index k = 0; k < n; ++k)
    placed.positions.row(k) << random.uniform(0, 3), random.uniform(0, 1);
  return placed;
}

/// A symmetric matrix of a graph: n on the diagonal, -1 for each edge.
inline Eigen::SparseMatrix<double> graph(int n, const std::vector<std::pair<int, int>>& edges) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < n; ++k) entries.emplace_back(k, k, n);
  for (const auto& [a, b] : edges) {
    entries.emplace_back(a, b, -1);
    entries.emplace_back(b, a, -1);
  }
  Eigen::SparseMatrix<double> K(n, n);
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

/// Bodies of every element, distorted, in pieces, without positions, and matrices of no mesh.
inline std::vector<Placed> placed_matrices() {
  using namespace signorini;
  std::vector<Placed> all;
  for (const Element& element : elements()) {
    const Mesh straight = block_for(element, {3, 2}, 9, 7);
    all.push_back(stiffness(element.name, straight, element, {fixed("left")}));
    all.push_back(stiffness(std::string(element.name) + " distorted",
                            distorted(straight, {3, 2}, {3.0 / 9, 2.0 / 7}, 3), element,
                            {fixed("bottom")}));
  }
  const std::size_t bodies = all.size();
  all.push_back(beside(all[0], all[bodies - 1]));
  all.push_back(beside(beside(all[1], all[0]), all[0]));  // two of them at one place
  for (std::size_t k = 0; k < bodies; ++k)
    all.push_back({all[k].name + " somewhere", all[k].K, NodeArray(0, 2)});
  for (const Eigen::Index n : {0, 1, 2, 9, 40, 90})
    for (const double density : {0.0, 0.04, 0.3, 1.0})
      all.push_back(random_matrix(n, density, static_cast<std::uint64_t>(n)));
  return all;
}

}  // namespace signorini_test
