// The back end `mumps`: MUMPS over MPI.  Every process keeps a part of the factor of [K A^T; A 0], with the rows of A, the
// contact forces, as the variables of its Schur complement -A K^-1 A^T.
#include <Eigen/SparseCore>
#include <memory>
#include <utility>

#include "addons/frontal/backend.hpp"
#include "addons/frontal/frontal_factor.hpp"
#include "backends/mumps_processes.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using over_mpi::Processes;

/// Lets all processes forget their parts of the factor when nobody needs it any more, unless there is a newer one.
class MumpsFactor {
 public:
  MumpsFactor(const Stiffness& K, Ledger& ledger) : scale_(stiffness_scale(K.matrix)) {
    std::vector<int> place(static_cast<std::size_t>(K.matrix.cols()));
    {
      const Ledger::Phase phase(ledger, "ordering");
      const SeparatorTree tree =
          separator_tree(K.matrix, K.positions ? K.positions() : Positions{});
      for (std::size_t k = 0; k < tree.order.size(); ++k)
        place[static_cast<std::size_t>(tree.order[k])] = static_cast<int>(k) + 1;
    }
    const Ledger::Phase phase(ledger, "numeric");
    number_ = ++newest;
    G_ = Processes::all().factor(K, scale_, std::move(place));
    G_ *= -scale_;
    G_.triangularView<Eigen::StrictlyLower>() = G_.transpose();
    rows_ = K.rows;
  }
  ~MumpsFactor() {
    if (number_ == newest) Processes::all().forget();
  }
  MumpsFactor(const MumpsFactor&) = delete;
  MumpsFactor& operator=(const MumpsFactor&) = delete;
  MumpsFactor(MumpsFactor&&) = delete;
  MumpsFactor& operator=(MumpsFactor&&) = delete;

  [[nodiscard]] VectorXd solve(const Eigen::Ref<const VectorXd>& load) const {
    require_argument(number_ == newest,
                     "back end mumps: this factor is gone, a newer one has its place");
    VectorXd both(load.size() + rows_.rows());
    both << load, VectorXd::Zero(rows_.rows());
    Processes::all().solve(both);
    both.conservativeResize(load.size());
    both *= scale_;
    return both;
  }

  /// That of the rows that were factored is there, once, and its operations are those of the factor; of others it takes a
  /// solve per row.
  [[nodiscard]] MatrixXd compliance(const Factor::Rows& A, double one_solve, Ledger& ledger) {
    if (A.rows() == 0) return {};
    const bool known = A.rows() == G_.rows() && Factor::Rows(A - rows_).norm() == 0;
    ledger.count("operations",
                 known ? 0 : static_cast<long long>(one_solve) * static_cast<long long>(A.rows()));
    if (known) return std::exchange(G_, MatrixXd());
    MatrixXd G(A.rows(), A.rows());
    for (Index k = 0; k < A.rows(); ++k) G.col(k) = A * solve(VectorXd(A.row(k).transpose()));
    return 0.5 * (G + MatrixXd(G.transpose()));
  }

 private:
  static int newest;

  double scale_;
  int number_ = 0;
  MatrixXd G_;
  Factor::Rows rows_;
};

int MumpsFactor::newest = 0;

Factor factored(const Stiffness& K, Ledger& ledger) {
  const Processes& processes = Processes::all();
  require_argument(processes.rank() == 0, "back end mumps: process 0 factors, this is process ",
                   processes.rank(), ", which helps: see Team::help");
  if (K.matrix.cols() == 0) return frontal().factor(K, ledger);  // MUMPS takes no empty matrix
  if (!K.matrix.coeffs().allFinite()) refuse(K, "mumps");
  const auto factor = std::make_shared<MumpsFactor>(K, ledger);
  const over_mpi::Share& share = processes.share();
  if (share.error() < 0 || share.negative_pivots() > 0) refuse(K, "mumps");
  const auto solve = [factor](const Eigen::Ref<const VectorXd>& load) {
    return factor->solve(load);
  };
  check_held(K, solve);
  const double nonzeros = share.nonzeros();
  const double one_solve = 4 * nonzeros;
  const Ledger::Phase phase(ledger, "numeric");
  ledger.count("nonzeros", static_cast<long long>(nonzeros));
  ledger.count("operations", static_cast<long long>(share.operations()));
  ledger.bytes(static_cast<long long>(nonzeros * sizeof(double)));
  return {solve,
          [factor, one_solve](const Factor::Rows& A, Ledger& counts) {
            return factor->compliance(A, one_solve, counts);
          },
          {K.matrix.cols(), static_cast<Index>(nonzeros), share.operations(), one_solve}};
}

Team team() {
  Processes& processes = Processes::all();
  return {processes.rank(),
          processes.size(),
          [&processes](const std::string& text) { processes.tell(text); },
          [&processes](const Team::Prepare& prepare) { return processes.help(prepare); },
          [&processes](int code) { processes.end(code); },
          [&processes] { return processes.members(); }};
}

}  // namespace

Backend mumps() {
  return {"mumps", "MUMPS, on as many processes as mpirun starts", factored, team};
}

}  // namespace signorini
