#include "addons/prediction/front_speed.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "addons/frontal/front.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// One dense task: a front, and rows of A that it carries.
struct Task {
  double operations;
  Index own;
  Index rim;
  Index rows;
};

/// The same shape with no more operations than take some milliseconds.
Task within_milliseconds(Task task) {
  constexpr double most = 1e7;
  if (task.operations <= most) return task;
  const double part = std::cbrt(most / task.operations);
  const auto less = [part](Index n) {
    return static_cast<Index>(std::ceil(part * static_cast<double>(n)));
  };
  return {0, less(task.own), less(task.rim), less(task.rows)};
}

/// Mean time of calls that take half a millisecond together, after one that only warms up.
template <typename Call>
double seconds_of(Call&& call) {
  using Clock = std::chrono::steady_clock;
  call();
  const Clock::time_point begin = Clock::now();
  std::chrono::duration<double> elapsed{};
  int calls = 0;
  do {
    call();
    ++calls;
    elapsed = Clock::now() - begin;
  } while (elapsed.count() < 5e-4);
  return elapsed.count() / calls;
}

/// Eliminates an identity: it comes out as it went in, and the work does not depend on the numbers.
double elimination_speed(const Task& task) {
  MatrixXd columns = MatrixXd::Identity(task.own + task.rim, task.own);
  MatrixXd update = MatrixXd::Zero(task.rim, task.rim);
  const VectorXd least = VectorXd::Zero(task.own);
  const double seconds = seconds_of([&] { static_cast<void>(eliminate(columns, update, least)); });
  return elimination_operations(task.own, task.rim) / seconds;
}

double carrying_speed(const Task& task) {
  const MatrixXd L = MatrixXd::Identity(task.own + task.rim, task.own);
  MatrixXd H = MatrixXd::Ones(task.own, task.rows);
  MatrixXd R = MatrixXd::Ones(task.rim, task.rows);
  MatrixXd square = MatrixXd::Zero(task.rows, task.rows);
  const double seconds = seconds_of([&] {
    L.topRows(task.own).triangularView<Eigen::Lower>().solveInPlace(H);
    R.noalias() -= L.bottomRows(task.rim) * H;
    square.setZero();
    square.selfadjointView<Eigen::Lower>().rankUpdate(H.transpose());
  });
  return carrying_operations(task.own, task.rim, task.rows) / seconds;
}

/// Mean speed of tasks: every third of the operations goes at the speed of the task in its middle.
template <typename Speed>
double mean_speed(std::vector<Task> tasks, Speed&& speed) {
  double sum = 0;
  for (const Task& task : tasks) sum += task.operations;
  if (sum == 0) return 0;
  std::sort(tasks.begin(), tasks.end(),
            [](const Task& a, const Task& b) { return a.operations < b.operations; });
  double seconds_per_operation = 0;
  double done = 0;
  int thirds = 0;
  for (const Task& task : tasks) {
    done += task.operations;
    for (; thirds < 3 && 6 * done >= (2 * thirds + 1) * sum; ++thirds)
      seconds_per_operation += 1 / (3 * speed(within_milliseconds(task)));
  }
  return 1 / seconds_per_operation;
}

/// Bytes per second of a walk through a block as large as the factor, or of four million numbers.
double memory_speed(Index entries) {
  constexpr Index most = Index{1} << 22;
  const VectorXd numbers = VectorXd::Ones(std::clamp(entries, Index{64}, most));
  double sum = 0;
  const double seconds = seconds_of([&] { sum += numbers.sum(); });
  return sum > 0
             ? static_cast<double>(sizeof(double)) * static_cast<double>(numbers.size()) / seconds
             : 0;
}

}  // namespace

FrontSpeed measure_speed(const Fronts& fronts, const RowPaths& paths) {
  std::vector<Task> eliminations;
  std::vector<Task> carries;
  for (std::size_t k = 0; k < fronts.all.size(); ++k) {
    const Index own = fronts.all[k].own();
    const Index rim = fronts.all[k].rim();
    const Index rows = static_cast<Index>(paths.rows[k].size());
    eliminations.push_back({elimination_operations(own, rim), own, rim, 0});
    carries.push_back({carrying_operations(own, rim, rows), own, rim, rows});
  }
  return {mean_speed(std::move(eliminations), elimination_speed),
          mean_speed(std::move(carries), carrying_speed), memory_speed(fronts.entries)};
}

}  // namespace signorini
