#include "addons/frontal/threads.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <set>
#include <utility>

#include "signorini/core/index.hpp"
#include "signorini/core/parts.hpp"

namespace signorini {
namespace {

/// Parts that wait for others, and threads that take what is ready.
class Schedule {
 public:
  /// \param waits      for how many parts each part waits
  /// \param followers  the parts that wait for each
  /// \param work       see PartWork
  Schedule(std::vector<int> waits, std::vector<std::vector<int>> followers, const PartWork& work)
      : waits_(std::move(waits)),
        followers_(std::move(followers)),
        work_(work),
        left_(waits_.size()),
        failed_(waits_.size()) {
    for (std::size_t part = 0; part < waits_.size(); ++part)
      if (waits_[part] == 0) ready_.insert(static_cast<int>(part));
  }

  void run(int workers) {
    on_threads(workers, [this] { take(); });
    if (error_) std::rethrow_exception(error_);
  }

 private:
  /// What one thread does.
  void take() {
    std::unique_lock<std::mutex> lock(mutex_);
    const int worker = workers_++;
    for (;;) {
      changed_.wait(lock, [this] { return left_ == 0 || !ready_.empty(); });
      if (left_ == 0) return;
      const int part = *ready_.begin();
      ready_.erase(ready_.begin());
      lock.unlock();
      const std::exception_ptr error = done(part, worker);
      lock.lock();
      if (error && at(part) < failed_) {
        failed_ = at(part);
        error_ = error;
      }
      finish(part, error != nullptr);
      changed_.notify_all();
    }
  }

  /// \return what was thrown, null if nothing
  [[nodiscard]] std::exception_ptr done(int part, int worker) const {
    try {
      work_(part, worker);
      return {};
    } catch (...) {
      return std::current_exception();
    }
  }

  /// Lets those begin that waited for a part. Behind a part that failed nothing is done, and all else is: so the least
  /// number that fails does not depend on who was first.
  void finish(int part, bool fails) {
    --left_;
    for (const int follower : followers_[at(part)]) {
      if (fails) lost_.insert(follower);
      if (--waits_[at(follower)] > 0) continue;
      if (lost_.count(follower) > 0)
        finish(follower, true);
      else
        ready_.insert(follower);
    }
  }

  std::vector<int> waits_;
  const std::vector<std::vector<int>> followers_;
  const PartWork& work_;
  std::size_t left_;
  std::set<int> ready_;
  std::set<int> lost_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int workers_ = 0;
  std::size_t failed_;
  std::exception_ptr error_;
};

/// \return how many threads there are for so many parts
int workers_for(int parts) { return std::min(free_threads(), parts); }

}  // namespace

void up_the_tree(const std::vector<TreePart>& parts, const PartWork& work) {
  if (parts.empty()) return;
  const int last = static_cast<int>(parts.size()) - 1;
  const int workers = workers_for(last);
  if (workers <= 1) {
    for (int part = 0; part < last; ++part) work(part, 0);
  } else {
    std::vector<int> waits;
    std::vector<std::vector<int>> followers;
    for (int part = 0; part < last; ++part) {
      waits.push_back(static_cast<int>(parts[at(part)].below.size()));
      const int above = parts[at(part)].above;
      followers.push_back(above >= 0 && above < last ? std::vector<int>{above}
                                                     : std::vector<int>{});
    }
    Schedule(std::move(waits), std::move(followers), work).run(workers);
  }
  work(last, 0);
}

void down_the_tree(const std::vector<TreePart>& parts, const PartWork& work) {
  const int workers = workers_for(static_cast<int>(parts.size()));
  if (workers <= 1) {
    for (std::size_t part = parts.size(); part-- > 0;) work(static_cast<int>(part), 0);
    return;
  }
  std::vector<int> waits;
  std::vector<std::vector<int>> followers;
  for (const TreePart& part : parts) {
    waits.push_back(part.above >= 0 ? 1 : 0);
    followers.push_back(part.below);
  }
  Schedule(std::move(waits), std::move(followers), work).run(workers);
}

}  // namespace signorini
