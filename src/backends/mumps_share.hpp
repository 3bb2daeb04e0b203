/// \file
/// What one process has of a factor that MUMPS makes on all of them.
#pragma once
#include <dmumps_c.h>

#include <Eigen/SparseCore>
#include <cstddef>
#include <memory>
#include <vector>

namespace signorini::over_mpi {

/// Entries of one triangle, as MUMPS takes them: rows and columns from 1.
struct Entries {
  std::vector<int> row;       ///< of each entry
  std::vector<int> column;    ///< of each entry
  std::vector<double> value;  ///< of each entry; those in the same place are added

  /// \param i  row, from 0
  /// \param j  column, from 0
  /// \param v  what is added there
  void add(Eigen::Index i, Eigen::Index j, double v);
  /// Adds the lower triangle of a matrix.
  /// \param K      `n x n`, both triangles
  /// \param scale  every entry is multiplied by
  void add_lower(const Eigen::SparseMatrix<double>& K, double scale);
};

/// Where MUMPS works: its part of the factor from the beginning on, and while it factors a stack from the end down.
class Room {
 public:
  Room() = default;
  ~Room();
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;
  Room(Room&&) = delete;
  Room& operator=(Room&&) = delete;

  /// Gets room for new numbers, whole millions of them, and gives the old one back.
  /// \param numbers  at least so many; 0 gives all back
  /// \throws std::bad_alloc if the system has no addresses for them; memory it takes only for those that are used
  void take(double numbers);
  /// Lets the system use again what lies behind the first numbers.
  /// \param numbers  how many stay
  void keep(double numbers);
  /// \return the first number
  [[nodiscard]] double* begin() const { return static_cast<double*>(begin_); }
  /// \return how many millions of numbers there is room for
  [[nodiscard]] int millions() const;

 private:
  void* begin_ = nullptr;
  std::size_t bytes_ = 0;
};

/// One system with a symmetric matrix, factored by all processes of MPI_COMM_WORLD; each calls the same functions in the
/// same order. The arguments and results that process 0 gives and takes are empty elsewhere.
class Share {
 public:
  Share() = default;
  ~Share() = default;
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;
  Share(Share&&) = delete;
  Share& operator=(Share&&) = delete;

  /// Factors the first unknowns, and forgets what was factored before; error() says whether it could.
  /// \param n      how many are eliminated
  /// \param m      how many follow that are not
  /// \param own    entries that this process assembled
  /// \param place  `n + m`, of process 0: where each unknown stands in the order of elimination, from 1
  /// \param schur  `m x m`, of process 0: gets the Schur complement of the last m unknowns in its upper triangle
  void factor(Eigen::Index n, Eigen::Index m, Entries& own, std::vector<int> place,
              Eigen::MatrixXd& schur);
  /// Solves with the factor of the first unknowns.
  /// \param both  `n + m`, of process 0: the right-hand side, and the solution in its place
  void solve(Eigen::VectorXd& both);
  /// Gives the factor back.
  void forget();

  /// \return what MUMPS says of its last call: 0, or a number of its manual below
  [[nodiscard]] int error() const { return mumps_->infog[0]; }
  /// \return what the manual says that belongs to error()
  [[nodiscard]] int error_detail() const { return mumps_->infog[1]; }
  /// \return pivots below 0, of all processes
  [[nodiscard]] int negative_pivots() const { return mumps_->infog[11]; }
  /// \return operations of the factorisation, of all processes
  [[nodiscard]] double operations() const { return mumps_->rinfog[2]; }
  /// \return entries of the factor, of all processes
  [[nodiscard]] double nonzeros() const;
  /// \return operations of the last factorisation, of this process, also once it is forgotten
  [[nodiscard]] double own_operations() const { return own_operations_; }

 private:
  void begin();  // a new factorisation
  void call(int job);
  /// Control parameter, numbered as in the manual of MUMPS.
  int& control(int number) { return mumps_->icntl[number - 1]; }

  Room room_;
  std::unique_ptr<DMUMPS_STRUC_C> mumps_;
  double own_operations_ = 0;
};

}  // namespace signorini::over_mpi
