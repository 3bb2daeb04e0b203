// A word on standard error while a stage of a run takes far longer than its forecast.
#pragma once
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "addons/prediction/prediction.hpp"

namespace command_line {

/// A stage of a run and the phases of the ledger that it is made of.
struct Stage {
  const char* name;                 ///< what messages call it
  std::vector<const char*> phases;  ///< of the ledger
};

const Stage& assembling();
const Stage& condensing();
const Stage& solving();

/// When a stage is overdue: ten times its forecast. Where the iterations of contact are not known, one of them counts.
/// A stage that takes less than two seconds is not reported.
/// \param stage       of the run
/// \param prediction  of the run
/// \return seconds after its beginning
double overdue_after(const Stage& stage, const signorini::Prediction& prediction);

/// The message: the stage, how long it has taken, the forecast, and what helps.
/// \param stage       of the run
/// \param plan        of the run; its bodies may be gone
/// \param prediction  of the plan
/// \return one line
std::string overdue_words(const Stage& stage, const signorini::Plan& plan,
                          const signorini::Prediction& prediction);

/// Writes a line to standard error if it still lives after so many seconds.
///
/// A second thread waits for the end of the stage or of the seconds, so nothing has to ask for the time, not even within one
/// long factorisation. It shares nothing with the work, and it has ended when this has.
class Overdue {
 public:
  /// \param seconds  after which to write, more than 0
  /// \param line     what to write
  Overdue(double seconds, const std::string& line);
  ~Overdue();
  Overdue(const Overdue&) = delete;
  Overdue& operator=(const Overdue&) = delete;
  Overdue(Overdue&&) = delete;
  Overdue& operator=(Overdue&&) = delete;

 private:
  std::mutex guard_;
  std::condition_variable end_;
  bool ended_ = false;
  std::thread clock_;
};

}  // namespace command_line
