#include "backends/mumps_processes.hpp"

#include <mpi.h>
#include <time.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <array>
#include <fstream>
#include <utility>

#include "signorini/core/errors.hpp"

namespace signorini::over_mpi {

using Eigen::Index;
using Matrix = Eigen::SparseMatrix<double>;

namespace {

long long peak_bytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  long long kilobytes = 0;
  while (status >> word)
    if (word == "VmHWM:") status >> kilobytes;
  return 1024 * kilobytes;
}

/// What process 0 sends all at once, before shares of K are factored.
struct Sizes {
  double unknowns = 0;
  double rows = 0;
  double scale = 1;

  void broadcast() {
    std::array<double, 3> all{unknowns, rows, scale};
    MPI_Bcast(all.data(), 3, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    *this = {all[0], all[1], all[2]};
  }
};

}  // namespace

Processes& Processes::all() {
  static Processes processes;
  return processes;
}

Processes::Processes() {
#ifdef __GLIBC__
  // As at the start, and for good: what is freed goes back at once.
  mallopt(M_MMAP_THRESHOLD, 128 * 1024);
#endif
  int running = 0;
  MPI_Initialized(&running);
  // The command has a second thread, which says when a run is overdue and sends no messages.
  int provided = MPI_THREAD_SINGLE;
  if (running == 0) MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Processes::~Processes() { finish(); }

void Processes::finish() {
  int finished = 0;
  MPI_Finalized(&finished);
  if (finished != 0) return;
  share_.forget();
  MPI_Finalize();
}

void Processes::order(Order what) {
  int number = static_cast<int>(what);
  MPI_Request sent = MPI_REQUEST_NULL;  // as in next()
  MPI_Ibcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD, &sent);
  MPI_Wait(&sent, MPI_STATUS_IGNORE);
}

Order Processes::next() {
  int number = 0;
  MPI_Request coming = MPI_REQUEST_NULL;
  MPI_Ibcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD, &coming);
  for (int here = 0; MPI_Test(&coming, &here, MPI_STATUS_IGNORE), here == 0;) {
    constexpr timespec moment{0, 200000};  // shorter than one solve
    nanosleep(&moment, nullptr);
  }
  return static_cast<Order>(number);
}

void Processes::agree(std::string error) {
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

void Processes::tell(const std::string& text) {
  long long length = static_cast<long long>(text.size());
  order(Order::Tell);
  MPI_Bcast(&length, 1, MPI_LONG_LONG, 0, MPI_COMM_WORLD);
  MPI_Bcast(const_cast<char*>(text.data()), static_cast<int>(length), MPI_CHAR, 0, MPI_COMM_WORLD);
}

std::string Processes::told(const Team::Prepare& prepare, Matrix& share) {
  long long length = 0;
  MPI_Bcast(&length, 1, MPI_LONG_LONG, 0, MPI_COMM_WORLD);
  std::string text(static_cast<std::size_t>(length), ' ');
  MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, 0, MPI_COMM_WORLD);
  try {
    Matrix(prepare(text)).swap(share);
    return {};
  } catch (const std::exception& failure) {
    return failure.what();
  }
}

Eigen::MatrixXd Processes::factor(const Stiffness& K, double scale, std::vector<int> place) {
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
  Sizes{static_cast<double>(n), static_cast<double>(m), scale}.broadcast();
  agree("");
  for (Index k = 0; k < m; ++k) place.push_back(static_cast<int>(n + k) + 1);
  Eigen::MatrixXd schur(m, m);
  share_.factor(n, m, own, std::move(place), schur);
  return schur;
}

void Processes::factor_share(Matrix& share, const std::string& error) {
  Sizes sizes;
  sizes.broadcast();
  const auto n = static_cast<Index>(sizes.unknowns);
  try {
    agree(!error.empty()      ? error
          : share.cols() == n ? ""
                              : text("it has ", share.cols(), " unknowns, process 0 has ", n,
                                     ": start all of them with the same files"));
  } catch (const ProblemError&) {  // process 0 says it
    return;
  }
  Entries own;
  own.add_lower(share, sizes.scale);
  Matrix().swap(share);
  stiffness_entries_ = static_cast<long long>(own.value.size());
  Eigen::MatrixXd none;
  share_.factor(n, static_cast<Index>(sizes.rows), own, {}, none);
}

void Processes::solve(Eigen::VectorXd& both) {
  order(Order::Solve);
  share_.solve(both);
  if (share_.error() < 0)
    throw ProblemError(text("back end mumps: MUMPS could not solve with its factor, error ",
                            share_.error(), " of its manual, with ", share_.error_detail(),
                            ": start it on more processes, or leave out --backend"));
}

void Processes::forget() {
  order(Order::Forget);
  share_.forget();
}

std::vector<TeamMember> Processes::members() {
  order(Order::Report);
  return report();
}

std::vector<TeamMember> Processes::report() {
  const std::array<double, 3> mine{static_cast<double>(peak_bytes()),
                                   static_cast<double>(stiffness_entries_),
                                   share_.own_operations()};
  std::vector<double> all(rank_ == 0 ? 3 * static_cast<std::size_t>(size_) : 0);
  MPI_Gather(mine.data(), 3, MPI_DOUBLE, all.data(), 3, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  std::vector<TeamMember> members;
  for (std::size_t k = 0; k < all.size(); k += 3)
    members.push_back(
        {static_cast<long long>(all[k]), static_cast<long long>(all[k + 1]), all[k + 2]});
  return members;
}

void Processes::end(int code) {
  order(Order::End);
  MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
  finish();
}

int Processes::help(const Team::Prepare& prepare) {
  Matrix share;
  Eigen::VectorXd none;
  std::string error = "it was told nothing to assemble";
  while (true) switch (next()) {
      case Order::Tell:
        error = told(prepare, share);
        break;
      case Order::Factor:
        factor_share(share, error);
        break;
      case Order::Solve:
        share_.solve(none);
        break;
      case Order::Forget:
        share_.forget();
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

}  // namespace signorini::over_mpi
