#include "exercise.hpp"

namespace ex0_3 {

Reading read_matrix(const Eigen::SparseMatrix<double>& /*K*/, Eigen::Index /*node*/) {
  Reading mine;  // your code here
  mine.pieces = 1;
  return mine;
}

}  // namespace ex0_3
