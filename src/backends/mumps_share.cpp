#include "backends/mumps_share.hpp"

#include <mpi.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <new>
#include <numeric>

namespace signorini::over_mpi {

using Eigen::Index;

namespace {

constexpr std::size_t million = 1000000 * sizeof(double);

/// A number that MUMPS gives in millions, and negative, if it is large.
double many(int count) { return count < 0 ? -1e6 * count : count; }

}  // namespace

void Entries::add(Index i, Index j, double v) {
  row.push_back(static_cast<int>(i) + 1);
  column.push_back(static_cast<int>(j) + 1);
  value.push_back(v);
}

void Entries::add_lower(const Eigen::SparseMatrix<double>& K, double scale) {
  const auto count = static_cast<std::size_t>((K.nonZeros() + K.cols()) / 2);
  for (auto* const numbers : {&row, &column}) numbers->reserve(count);
  value.reserve(count);
  for (Index k = 0; k < K.cols(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(K, k); entry; ++entry)
      if (entry.row() >= k) add(entry.row(), k, scale * entry.value());
}

Room::~Room() { take(0); }

void Room::take(double numbers) {
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

void Room::keep(double numbers) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t kept = (static_cast<std::size_t>(numbers) * sizeof(double) / page + 1) * page;
  if (kept < bytes_) madvise(static_cast<char*>(begin_) + kept, bytes_ - kept, MADV_DONTNEED);
}

int Room::millions() const { return static_cast<int>(bytes_ / million); }

void Share::begin() {
  forget();
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
}

void Share::factor(Index n, Index m, Entries& own, std::vector<int> place, Eigen::MatrixXd& schur) {
  begin();
  std::vector<int> schur_variables(static_cast<std::size_t>(m));
  std::iota(schur_variables.begin(), schur_variables.end(), static_cast<int>(n) + 1);
  if (m > 0) {
    control(19) = 1;  // the Schur complement on process 0, its lower triangle by rows
    mumps_->size_schur = static_cast<int>(m);
    mumps_->listvar_schur = schur_variables.data();
    mumps_->schur = schur.data();
  }
  mumps_->n = static_cast<int>(n + m);
  mumps_->nnz_loc = static_cast<MUMPS_INT8>(own.value.size());
  mumps_->irn_loc = own.row.data();
  mumps_->jcn_loc = own.column.data();
  mumps_->a_loc = own.value.data();
  mumps_->perm_in = place.data();
  call(1);
  mumps_->perm_in = nullptr;
  std::vector<int>().swap(place);
  if (error() >= 0) {
    room_.take(2 * many(mumps_->info[7]));  // twice what MUMPS expects: unused, it costs nothing
    mumps_->wk_user = room_.begin();
    mumps_->lwk_user = -room_.millions();
    call(2);
    room_.keep(many(mumps_->info[8]));
  }
  own_operations_ = mumps_->rinfo[2];
  // Of solving, MUMPS wants none of these again.
  mumps_->irn_loc = mumps_->jcn_loc = mumps_->listvar_schur = nullptr;
  mumps_->a_loc = mumps_->schur = nullptr;
}

void Share::solve(Eigen::VectorXd& both) {
  mumps_->rhs = both.data();
  mumps_->nrhs = 1;
  mumps_->lrhs = mumps_->n;
  call(3);
}

void Share::forget() {
  if (mumps_) call(-2);
  mumps_.reset();
  room_.take(0);
}

double Share::nonzeros() const { return many(mumps_->infog[28]); }

void Share::call(int job) {
  mumps_->job = job;
  dmumps_c(mumps_.get());
}

}  // namespace signorini::over_mpi
