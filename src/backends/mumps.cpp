// The back end `mumps`: MUMPS over MPI, packages libmumps-dev and libopenmpi-dev.  Every process keeps a part of the factor
// of [K A^T; A 0], with the rows of A, the contact forces, as the variables of its Schur complement -A K^-1 A^T.
#include <dmumps_c.h>
#include <mpi.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <Eigen/SparseCore>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <new>
#include <numeric>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/factor/backend.hpp"
#include "signorini/factor/frontal_factor.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// What process 0 wants of the others.
enum class Order : int { Tell, Factor, Solve, Forget, Report, End };

long long peak_bytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  long long kilobytes = 0;
  while (status >> word)
    if (word == "VmHWM:") status >> kilobytes;
  return 1024 * kilobytes;
}

/// Entries of one triangle, as MUMPS takes them: rows and columns from 1.
struct Entries {
  std::vector<int> row;
  std::vector<int> column;
  std::vector<double> value;

  void add(Index i, Index j, double v) {
    row.push_back(static_cast<int>(i) + 1);
    column.push_back(static_cast<int>(j) + 1);
    value.push_back(v);
  }
  void reserve(Index count) {
    for (auto* const numbers : {&row, &column}) numbers->reserve(static_cast<std::size_t>(count));
    value.reserve(static_cast<std::size_t>(count));
  }
  void add_lower(const Matrix& K, double scale) {
    reserve((K.nonZeros() + K.cols()) / 2);
    for (Index k = 0; k < K.cols(); ++k)
      for (Matrix::InnerIterator entry(K, k); entry; ++entry)
        if (entry.row() >= k) add(entry.row(), k, scale * entry.value());
  }
};

/// A number that MUMPS gives in millions, and negative, if it is large.
double many(int count) { return count < 0 ? -1e6 * count : count; }

/// Where MUMPS works: its part of the factor from the beginning on, and while it factors a stack from the end down.
class Room {
 public:
  Room() = default;
  ~Room() { take(0); }
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;
  Room(Room&&) = delete;
  Room& operator=(Room&&) = delete;

  /// Gets room for new numbers, whole millions of them, and gives the old one back.
  void take(double numbers) {
    if (bytes_ > 0) munmap(begin_, bytes_);
    bytes_ = static_cast<std::size_t>(std::ceil(numbers / 1e6)) * million;
    begin_ = nullptr;
    if (bytes_ == 0) return;
    begin_ = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE,
                  MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (begin_ != MAP_FAILED) return;
    bytes_ = 0;
    throw std::bad_alloc();
  }
  /// Lets the system use again what lies behind the first numbers.
  void keep(double numbers) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t kept = (static_cast<std::size_t>(numbers) * sizeof(double) / page + 1) * page;
    if (kept < bytes_) madvise(static_cast<char*>(begin_) + kept, bytes_ - kept, MADV_DONTNEED);
  }
  [[nodiscard]] double* begin() const { return static_cast<double*>(begin_); }
  [[nodiscard]] int millions() const { return static_cast<int>(bytes_ / million); }

 private:
  static constexpr std::size_t million = 1000000 * sizeof(double);
  void* begin_ = nullptr;
  std::size_t bytes_ = 0;
};

/// The processes of one run, and what this one has of the factor.
class Session {
 public:
  static Session& the() {
    static Session session;
    return session;
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  Session(Session&&) = delete;
  Session& operator=(Session&&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  // Process 0.

  void tell(const std::string& text) {
    long long length = static_cast<long long>(text.size());
    order(Order::Tell);
    MPI_Bcast(&length, 1, MPI_LONG_LONG, 0, MPI_COMM_WORLD);
    MPI_Bcast(const_cast<char*>(text.data()), static_cast<int>(length), MPI_CHAR, 0,
              MPI_COMM_WORLD);
  }

  /// Factors, with the others. \return -A (scale K)^-1 A^T by rows, of which the lower triangle counts
  VectorXd factor(const Stiffness& K, double scale, std::vector<int>& place) {
    const Index n = K.matrix.cols();
    const Index m = K.rows.rows();
    Entries own;
    if (size_ == 1) own.add_lower(K.matrix, scale);
    stiffness_entries_ = static_cast<long long>(own.value.size());
    for (const Index unknown : K.grounded)
      own.add(unknown, unknown, scale * K.matrix.coeff(unknown, unknown));
    for (Index k = 0; k < m; ++k)
      for (Factor::Rows::InnerIterator entry(K.rows, k); entry; ++entry)
        own.add(n + k, entry.col(), entry.value());
    order(Order::Factor);
    std::array<double, 3> sizes{static_cast<double>(n), static_cast<double>(m), scale};
    MPI_Bcast(sizes.data(), 3, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    agree("");
    for (Index k = 0; k < m; ++k) place.push_back(static_cast<int>(n + k) + 1);
    VectorXd schur(m * m);
    run(n, m, own, place.data(), schur.data());
    return schur;
  }

  VectorXd solve(const Eigen::Ref<const VectorXd>& load) {
    VectorXd both = VectorXd::Zero(mumps_->n);
    both.head(load.size()) = load;
    order(Order::Solve);
    mumps_->rhs = both.data();
    mumps_->nrhs = 1;
    mumps_->lrhs = mumps_->n;
    call(3);
    if (error() < 0)
      throw ProblemError(text("back end mumps: MUMPS could not solve with its factor, error ",
                              error(), " of its manual, with ", mumps_->infog[1],
                              ": start it on more processes, or leave out --backend"));
    return both.head(load.size());
  }

  void forget() {
    order(Order::Forget);
    release();
  }

  [[nodiscard]] std::vector<TeamMember> members() {
    order(Order::Report);
    return report();
  }

  void end(int code) {
    order(Order::End);
    MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
    finish();
  }

  // The others.

  int help(const Team::Prepare& prepare) {
    Matrix share;
    std::string error = "it was told nothing to assemble";
    while (true) switch (next()) {
        case Order::Tell: {
          long long length = 0;
          MPI_Bcast(&length, 1, MPI_LONG_LONG, 0, MPI_COMM_WORLD);
          std::string text(static_cast<std::size_t>(length), ' ');
          MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, 0, MPI_COMM_WORLD);
          try {
            Matrix(prepare(text)).swap(share);
            error.clear();
          } catch (const std::exception& failure) {
            error = failure.what();
          }
          break;
        }
        case Order::Factor:
          factor(share, error);
          break;
        case Order::Solve:
          call(3);
          break;
        case Order::Forget:
          release();
          break;
        case Order::Report:
          static_cast<void>(report());
          break;
        case Order::End: {
          int code = 0;
          MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
          finish();
          return code;
        }
      }
  }

  [[nodiscard]] int error() const { return mumps_->infog[0]; }
  [[nodiscard]] int negative_pivots() const { return mumps_->infog[11]; }
  [[nodiscard]] double operations() const { return mumps_->rinfog[2]; }
  [[nodiscard]] double nonzeros() const { return many(mumps_->infog[28]); }

 private:
  Session() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD,
            128 * 1024);  // as at the start, and for good: what is freed goes back at once
#endif
    int running = 0;
    MPI_Initialized(&running);
    if (running == 0) MPI_Init(nullptr, nullptr);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~Session() { finish(); }

  void finish() {
    int finished = 0;
    MPI_Finalized(&finished);
    if (finished != 0) return;
    release();
    MPI_Finalize();
  }

  void order(Order what) {
    int number = static_cast<int>(what);
    MPI_Request sent = MPI_REQUEST_NULL;  // as in next()
    MPI_Ibcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD, &sent);
    MPI_Wait(&sent, MPI_STATUS_IGNORE);
  }

  /// Waits for an order without keeping a processor busy, as MPI_Bcast() would.
  Order next() {
    int number = 0;
    MPI_Request coming = MPI_REQUEST_NULL;
    MPI_Ibcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD, &coming);
    for (int here = 0; MPI_Test(&coming, &here, MPI_STATUS_IGNORE), here == 0;) {
      constexpr timespec moment{0, 200000};  // shorter than one solve
      nanosleep(&moment, nullptr);
    }
    return static_cast<Order>(number);
  }

  /// Ends the same on all processes if one of them could not prepare its share. \throws ProblemError
  void agree(std::string error) {
    const int mine = error.empty() ? size_ : rank_;
    int first = size_;
    MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (first == size_) return;
    int length = static_cast<int>(error.size());
    MPI_Bcast(&length, 1, MPI_INT, first, MPI_COMM_WORLD);
    error.resize(static_cast<std::size_t>(length));
    MPI_Bcast(error.data(), length, MPI_CHAR, first, MPI_COMM_WORLD);
    throw ProblemError(text("process ", first, " of ", size_, ": ", error));
  }

  /// What the others do while process 0 is in factor().
  void factor(Matrix& share, const std::string& error) {
    std::array<double, 3> sizes{};
    MPI_Bcast(sizes.data(), 3, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    const auto n = static_cast<Index>(sizes[0]);
    try {
      agree(!error.empty()      ? error
            : share.cols() == n ? ""
                                : text("it has ", share.cols(), " unknowns, process 0 has ", n,
                                       ": start all of them with the same files"));
    } catch (const ProblemError&) {  // process 0 says it
      return;
    }
    Entries own;
    own.add_lower(share, sizes[2]);
    Matrix().swap(share);
    stiffness_entries_ = static_cast<long long>(own.value.size());
    std::vector<int> place;
    run(n, static_cast<Index>(sizes[1]), own, nullptr, nullptr);
  }

  /// Analysis and factorisation. \param place  of each variable in the order of elimination, on process 0
  void run(Index n, Index m, Entries& own, int* place, double* schur) {
    release();
    mumps_ = std::make_unique<DMUMPS_STRUC_C>();
    mumps_->par = 1;
    mumps_->sym = 1;  // no pivoting; how many pivots are negative is told
    mumps_->comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_WORLD));
    call(-1);
    for (const int stream : {1, 2, 3}) control(stream) = -1;
    control(4) = 0;   // silent
    control(7) = 1;   // eliminate in our order
    control(8) = 0;   // K is scaled
    control(18) = 3;  // entries are where they were assembled
    std::vector<int> schur_variables(static_cast<std::size_t>(m));
    std::iota(schur_variables.begin(), schur_variables.end(), static_cast<int>(n) + 1);
    if (m > 0) {
      control(19) = 1;  // the Schur complement on process 0
      mumps_->size_schur = static_cast<int>(m);
      mumps_->listvar_schur = schur_variables.data();
      mumps_->schur = schur;
    }
    mumps_->n = static_cast<int>(n + m);
    mumps_->nnz_loc = static_cast<MUMPS_INT8>(own.value.size());
    mumps_->irn_loc = own.row.data();
    mumps_->jcn_loc = own.column.data();
    mumps_->a_loc = own.value.data();
    mumps_->perm_in = place;
    call(1);
    if (mumps_->infog[0] >= 0) {
      room_.take(
          2 *
          many(mumps_->info[7]));  // twice what MUMPS expects: room costs nothing until it is used
      mumps_->wk_user = room_.begin();
      mumps_->lwk_user = -room_.millions();
      call(2);
      room_.keep(many(mumps_->info[8]));
    }
    operations_ = mumps_->rinfo[2];
    // Of solving, MUMPS wants none of these again.
    mumps_->irn_loc = mumps_->jcn_loc = mumps_->listvar_schur = mumps_->perm_in = nullptr;
    mumps_->a_loc = mumps_->schur = nullptr;
  }

  void release() {
    if (mumps_) call(-2);
    mumps_.reset();
    room_.take(0);
  }

  void call(int job) {
    mumps_->job = job;
    dmumps_c(mumps_.get());
  }

  /// Control parameter, numbered as in the manual of MUMPS.
  int& control(int number) { return mumps_->icntl[number - 1]; }

  /// \return of all processes, on process 0
  std::vector<TeamMember> report() {
    const std::array<double, 3> mine{static_cast<double>(peak_bytes()),
                                     static_cast<double>(stiffness_entries_), operations_};
    std::vector<double> all(rank_ == 0 ? 3 * static_cast<std::size_t>(size_) : 0);
    MPI_Gather(mine.data(), 3, MPI_DOUBLE, all.data(), 3, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    std::vector<TeamMember> members;
    for (std::size_t k = 0; k < all.size(); k += 3)
      members.push_back(
          {static_cast<long long>(all[k]), static_cast<long long>(all[k + 1]), all[k + 2]});
    return members;
  }

  int rank_ = 0;
  int size_ = 1;
  Room room_;
  std::unique_ptr<DMUMPS_STRUC_C> mumps_;
  long long stiffness_entries_ = 0;
  double operations_ = 0;
};

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
    const Index m = K.rows.rows();
    const VectorXd schur = Session::the().factor(K, scale_, place);
    if (m > 0) {
      G_ = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          schur.data(), m, m);
      G_ *= -scale_;
      G_.triangularView<Eigen::StrictlyUpper>() = G_.transpose();
    }
    rows_ = K.rows;
  }
  ~MumpsFactor() {
    if (number_ == newest) Session::the().forget();
  }
  MumpsFactor(const MumpsFactor&) = delete;
  MumpsFactor& operator=(const MumpsFactor&) = delete;
  MumpsFactor(MumpsFactor&&) = delete;
  MumpsFactor& operator=(MumpsFactor&&) = delete;

  [[nodiscard]] VectorXd solve(const Eigen::Ref<const VectorXd>& load) const {
    require(number_ == newest, "back end mumps: this factor is gone, a newer one has its place");
    return scale_ * Session::the().solve(load);
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
  Session& session = Session::the();
  require(session.rank() == 0, "back end mumps: process 0 factors, this is process ",
          session.rank(), ", which helps: see Team::help");
  if (K.matrix.cols() == 0)
    return backends().front().factor(K, ledger);  // MUMPS takes no empty matrix
  if (!K.matrix.coeffs().allFinite()) refuse(K, "mumps");
  const auto factor = std::make_shared<MumpsFactor>(K, ledger);
  if (session.error() < 0 || session.negative_pivots() > 0) refuse(K, "mumps");
  const auto solve = [factor](const Eigen::Ref<const VectorXd>& load) {
    return factor->solve(load);
  };
  check_held(K, solve);
  const double nonzeros = session.nonzeros();
  const double one_solve = 4 * nonzeros;
  const Ledger::Phase phase(ledger, "numeric");
  ledger.count("nonzeros", static_cast<long long>(nonzeros));
  ledger.count("operations", static_cast<long long>(session.operations()));
  ledger.bytes(static_cast<long long>(nonzeros * sizeof(double)));
  return {solve,
          [factor, one_solve](const Factor::Rows& A, Ledger& counts) {
            return factor->compliance(A, one_solve, counts);
          },
          {K.matrix.cols(), static_cast<Index>(nonzeros), session.operations(), one_solve}};
}

Team team() {
  Session& session = Session::the();
  return {session.rank(),
          session.size(),
          [&session](const std::string& text) { session.tell(text); },
          [&session](const Team::Prepare& prepare) { return session.help(prepare); },
          [&session](int code) { session.end(code); },
          [&session] { return session.members(); }};
}

}  // namespace

Backend mumps() {
  return {"mumps", "MUMPS, on as many processes as mpirun starts", factored, team};
}

}  // namespace signorini
