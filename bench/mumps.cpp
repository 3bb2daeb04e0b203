#include "bench/mumps.hpp"

#include <limits>
#include <vector>

#ifdef SIGNORINI_MUMPS_SEQ
#include <dmumps_c.h>
#endif

namespace signorini::bench {

#ifdef SIGNORINI_MUMPS_SEQ
namespace {

/// A matrix of MUMPS: the lower triangle as triples counted from 1, and one analysis and factorisation of it.
class Job {
 public:
  explicit Job(int symmetry) {
    data_.par = 1;
    data_.sym = symmetry;
    data_.comm_fortran = -987654;  // all processes: the one there is
    run(-1);
    for (int stream = 0; stream < 3; ++stream) data_.icntl[stream] = -1;
    data_.icntl[3] = 0;
  }
  ~Job() { run(-2); }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  Job(Job&&) = delete;
  Job& operator=(Job&&) = delete;

  void add(Eigen::Index row, Eigen::Index column, double value) {
    rows_.push_back(static_cast<int>(row) + 1);
    columns_.push_back(static_cast<int>(column) + 1);
    values_.push_back(value);
  }
  void add_lower(const Eigen::SparseMatrix<double>& K) {
    for (Eigen::Index j = 0; j < K.cols(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(K, j); entry; ++entry)
        if (entry.row() >= j) add(entry.row(), j, entry.value());
  }
  /// \return whether all went well
  bool factor(Eigen::Index size) {
    data_.n = static_cast<int>(size);
    data_.nnz = static_cast<MUMPS_INT8>(values_.size());
    data_.irn = rows_.data();
    data_.jcn = columns_.data();
    data_.a = values_.data();
    run(4);
    return data_.infog[0] >= 0;
  }
  bool solve(Eigen::VectorXd& right) {
    data_.rhs = right.data();
    run(3);
    return data_.infog[0] >= 0;
  }
  /// Asks for the full Schur complement, row by row.
  void keep(std::vector<int>& unknowns, Eigen::MatrixXd& schur) {
    data_.icntl[18] = 1;
    data_.size_schur = static_cast<int>(unknowns.size());
    data_.listvar_schur = unknowns.data();
    data_.schur = schur.data();
  }

 private:
  void run(int job) {
    data_.job = job;
    dmumps_c(&data_);
  }
  DMUMPS_STRUC_C data_{};
  std::vector<int> rows_, columns_;
  std::vector<double> values_;
};

const double no_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::string mumps_missing() { return ""; }

Eigen::VectorXd mumps_solve(const Eigen::SparseMatrix<double>& K, const Eigen::VectorXd& p) {
  Job job(1);
  job.add_lower(K);
  Eigen::VectorXd u = p;
  if (!job.factor(K.rows()) || !job.solve(u)) u.setConstant(no_number);
  return u;
}

Eigen::MatrixXd mumps_compliance(const Eigen::SparseMatrix<double>& K,
                                 const Eigen::SparseMatrix<double, Eigen::RowMajor>& A) {
  const Eigen::Index n = K.rows(), m = A.rows();
  Job job(2);
  job.add_lower(K);
  std::vector<int> multipliers;
  for (Eigen::Index i = 0; i < m; ++i) {
    multipliers.push_back(static_cast<int>(n + i) + 1);
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(A, i); entry; ++entry)
      job.add(n + i, entry.col(), entry.value());
  }
  Eigen::MatrixXd schur = Eigen::MatrixXd::Zero(m, m);
  job.keep(multipliers, schur);
  if (!job.factor(n + m)) return Eigen::MatrixXd::Constant(m, m, no_number);
  return -Eigen::MatrixXd(schur.selfadjointView<Eigen::Upper>());  // its rows are our columns
}
#else
std::string mumps_missing() { return "not installed (Debian package libmumps-seq-dev)"; }

Eigen::VectorXd mumps_solve(const Eigen::SparseMatrix<double>&, const Eigen::VectorXd& p) {
  return Eigen::VectorXd::Constant(p.size(), std::numeric_limits<double>::quiet_NaN());
}

Eigen::MatrixXd mumps_compliance(const Eigen::SparseMatrix<double>&,
                                 const Eigen::SparseMatrix<double, Eigen::RowMajor>& A) {
  return Eigen::MatrixXd::Constant(A.rows(), A.rows(), std::numeric_limits<double>::quiet_NaN());
}
#endif

}  // namespace signorini::bench
