/// \file
/// The processes of one run, which factor with MUMPS what process 0 asks for.
#pragma once
#include <string>
#include <vector>

#include "addons/frontal/backend.hpp"
#include "backends/mumps_share.hpp"

namespace signorini::over_mpi {

/// What process 0 wants of the others.
enum class Order : int {
  Tell,    ///< take a text, and assemble a share of K from it
  Factor,  ///< factor the share
  Solve,   ///< help to solve
  Forget,  ///< give the factor back
  Report,  ///< say what was done
  End      ///< leave
};

/// The processes that mpirun started, seen from one of them. Process 0 calls what stands first; the others call help().
class Processes {
 public:
  /// Starts MPI, unless it runs. \return those of this run
  static Processes& all();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;
  Processes(Processes&&) = delete;
  Processes& operator=(Processes&&) = delete;

  /// \return number of this process
  [[nodiscard]] int rank() const { return rank_; }
  /// \return how many there are
  [[nodiscard]] int size() const { return size_; }
  /// \return what this process has of the factor
  [[nodiscard]] const Share& share() const { return share_; }

  /// Hands a text to the others. \param text  that they make their shares of
  void tell(const std::string& text);
  /// Factors [scale K, A^T; A, 0] up to the rows of A; what MUMPS says of it stands in share().
  /// \param K      with its rows A; of several processes the others have K
  /// \param scale  of K
  /// \param place  `n`, of each unknown in the order of elimination, from 1; rows of A follow
  /// \return `n_c x n_c` -A (scale K)^-1 A^T, of which the upper triangle counts
  /// \throws ProblemError if another process could not assemble its share
  [[nodiscard]] Eigen::MatrixXd factor(const Stiffness& K, double scale, std::vector<int> place);
  /// Solves with the factor.
  /// \param both  `n + n_c`: the load with 0 for the rows of A; gets the displacements in its place
  /// \throws ProblemError if MUMPS could not
  void solve(Eigen::VectorXd& both);
  /// Gives the factor back.
  void forget();
  /// \return what every process did
  [[nodiscard]] std::vector<TeamMember> members();
  /// Lets the others end. \param code  that they end with
  void end(int code);

  /// Works for process 0 until that ends. \param prepare  makes the share of K. \return the code that it ends with
  int help(const Team::Prepare& prepare);

 private:
  Processes();
  ~Processes();

  void finish();
  void order(Order what);
  /// Waits for an order without keeping a processor busy, as MPI_Bcast() would.
  Order next();
  /// Ends the same on all processes if one of them could not prepare its share. \throws ProblemError
  void agree(std::string error);
  /// What the others do while process 0 is in tell(). \return what went wrong, if anything did
  static std::string told(const Team::Prepare& prepare, Eigen::SparseMatrix<double>& share);
  /// What the others do while process 0 is in factor().
  void factor_share(Eigen::SparseMatrix<double>& share, const std::string& error);
  /// \return of all processes, on process 0
  std::vector<TeamMember> report();

  int rank_ = 0;
  int size_ = 1;
  Share share_;
  long long stiffness_entries_ = 0;
};

}  // namespace signorini::over_mpi
