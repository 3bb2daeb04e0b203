#include "addons/estimate/anisotropy.hpp"

namespace signorini {

using Eigen::Index;

Eigen::MatrixXd anisotropic_indicator(const PrimalAndDuals& fields, const SmoothStress& stress) {
  const Index n_fields = static_cast<Index>(fields.displacements.size());
  const Index n_rows = stress.value.cols() / n_fields;
  Eigen::MatrixXd shares = Eigen::MatrixXd::Ones(fields.mesh.n_cells(), n_fields - 1);
  Eigen::RowVectorXd first(stress.value.cols());
  Eigen::RowVectorXd second(stress.value.cols());
  for (Index cell = 0; cell < shares.rows(); ++cell) {
    if (fields.mesh.corners(cell) == 3) continue;
    const auto corner = [&](int k) { return stress.value.row(stress.cells(cell, k)); };
    first = corner(1) - corner(0) + corner(2) - corner(3);
    second = corner(3) - corner(0) + corner(2) - corner(1);
    const auto varies = [&](const Eigen::RowVectorXd& way, Index z) {
      return way.head(n_rows).norm() * way.segment(n_rows * z, n_rows).norm();
    };
    for (Index z = 1; z < n_fields; ++z) {
      const double along = varies(first, z);
      const double all = along + varies(second, z);
      shares(cell, z - 1) = all > 0 ? along / all : 0.5;
    }
  }
  return shares;
}

}  // namespace signorini
