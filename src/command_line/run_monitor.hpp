// What a run says of itself while it lasts: a line on a terminal, and a word when it is interrupted.
#pragma once
#include <csignal>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace command_line {

/// Watches a run in a second thread. After two seconds a line on the error stream, if that is a terminal, says what is being done
/// and for how long, anew in every second. An interruption (SIGINT, as by Ctrl-C, or SIGTERM) ends the program by that signal, which
/// shells call status 130 or 143, with a word on what was done and what is kept. It waits for files that are just being written; a second
/// interruption does not.
///
/// Nothing of the work asks for the time or for signals, so it may be within one long factorisation. A signal that the program was told to
/// ignore, as nohup tells it, stays ignored.
class RunMonitor {
 public:
  /// Begins. All threads are to be started later, so that signals come here. Where no thread can be started nothing is said, and signals
  /// do what they would.
  RunMonitor();
  ~RunMonitor();
  RunMonitor(const RunMonitor&) = delete;
  RunMonitor& operator=(const RunMonitor&) = delete;
  RunMonitor(RunMonitor&&) = delete;
  RunMonitor& operator=(RunMonitor&&) = delete;

 private:
  void watch();

  sigset_t signals_ = {};  // that are waited for
  sigset_t before_ = {};   // that were blocked
  std::thread thread_;
};

/// What is being done, for the line and the word, as long as this lives. The last one to speak is heard.
class Progress {
 public:
  /// \param what  is being done, such as `reading a.toml`; empty: the line is taken back until more is said
  explicit Progress(const std::string& what = "") { say(what); }
  ~Progress() { say(""); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;
  /// \param what  as above
  void say(const std::string& what) const;
};

/// No interruption ends the program while this lives: files are being written.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
  Uninterrupted(Uninterrupted&&) = delete;
  Uninterrupted& operator=(Uninterrupted&&) = delete;
};

/// Says what an interruption from now on leaves. \param what  in words, a sentence without its full stop
void set_kept(const std::string& what);

/// Adds something to be done before an interruption ends the program. \param last  must not throw
void do_last(std::function<void()> last);

/// \return what takes back the last line of a terminal; nothing where the error stream is none
const char* erase_line();

}  // namespace command_line
