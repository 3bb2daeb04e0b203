#include <stdexcept>

#include "exercise.hpp"

namespace ex0_2 {

namespace {

using Eigen::Index;

void check(Index n_nodes, const std::vector<Part>& parts, const std::map<Index, double>& held) {
  for (const Part& part : parts) {
    const Index size = 2 * Index(part.nodes.size());
    if (part.stiffness.rows() != size || part.stiffness.cols() != size)
      throw std::invalid_argument("assemble: a cell needs a row and a column per component");
    for (const Index node : part.nodes)
      if (node < 0 || node >= n_nodes) throw std::invalid_argument("assemble: no such node");
  }
  for (const auto& [component, displacement] : held)
    if (component < 0 || component >= 2 * n_nodes)
      throw std::invalid_argument("assemble: no such component to hold");
}

}  // namespace

System assemble(Index n_nodes, const std::vector<Part>& parts,
                const std::map<Index, double>& held) {
  check(n_nodes, parts, held);
  std::vector<Index> number(std::size_t(2 * n_nodes), -1);
  Index left = 0;
  for (Index i = 0; i < 2 * n_nodes; ++i)
    if (held.count(i) == 0) number[std::size_t(i)] = left++;
  System system{Eigen::SparseMatrix<double>(left, left), Eigen::VectorXd::Zero(left)};
  std::vector<Eigen::Triplet<double>> entries;
  for (const Part& part : parts)
    for (Index i = 0; i < part.stiffness.rows(); ++i) {
      const Index row = number[std::size_t(2 * part.nodes[std::size_t(i / 2)] + i % 2)];
      if (row < 0) continue;
      for (Index j = 0; j < part.stiffness.cols(); ++j) {
        const Index component = 2 * part.nodes[std::size_t(j / 2)] + j % 2;
        const Index column = number[std::size_t(component)];
        if (column >= 0)
          entries.emplace_back(row, column, part.stiffness(i, j));
        else
          system.load(row) -= part.stiffness(i, j) * held.at(component);
      }
    }
  system.stiffness.setFromTriplets(entries.begin(), entries.end());
  return system;
}

}  // namespace ex0_2
