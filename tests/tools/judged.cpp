// Linked first into every program of an exercise: tells tools/judge.pl what the tests found, in a way that an answer
// cannot imitate, and encloses the program before a line of the answer runs.
//
// SIGNORINI_JUDGED = "SECONDS BYTES PRINTED READS" is set by the judge: the limits of processor time, of memory and of what is
// printed, and 1 if files may be read, else 0. From file 3 comes a secret of one line; to file 4 goes a line for every test
// case that ends, "SECRET<tab>passed<tab>failed<tab>name" with the numbers of its assertions, and last
// "SECRET<tab>end<tab>enclosed", or "open" where the system is none that this file can enclose a program on. File 3 is read
// and closed before static objects of the answer come to life. Without the variable nothing happens.
//
// Enclosed means: computing, memory and open files are all there is, and files to read if READS says so. A program that starts
// another one, signals, opens a socket or opens a file for writing is killed by SIGSYS, whatever else it asks for is refused.
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>

#include "catch_listener.hpp"

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
#define SIGNORINI_CAN_ENCLOSE
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

namespace {

constexpr int from_judge = 3;
constexpr int to_judge = 4;
std::array<char, 80> secret{};  // empty if no judge asked
bool enclosed = false;

void tell(const std::string& what) {
  if (secret[0] == '\0') return;
  const std::string line = secret.data() + ('\t' + what) + '\n';
  if (write(to_judge, line.data(), line.size()) < 0) std::abort();
}

[[noreturn]] void give_up(const char* what) {  // before main: nothing but system calls
  static_cast<void>(!write(STDERR_FILENO, what, std::strlen(what)));
  _exit(3);
}

void limit(decltype(RLIMIT_CPU) what, rlim_t soft, rlim_t hard) {
  const rlimit both{soft, hard};
  if (setrlimit(what, &both) != 0) give_up("judged.cpp: cannot set a limit\n");
}

#ifdef SIGNORINI_CAN_ENCLOSE
#ifdef __x86_64__
constexpr unsigned machine = AUDIT_ARCH_X86_64;
#else
constexpr unsigned machine = AUDIT_ARCH_AARCH64;
#endif
// What computing and printing take.
constexpr unsigned allowed[] = {
    SYS_read,         SYS_readv,          SYS_write,        SYS_writev,        SYS_lseek,
    SYS_close,        SYS_fstat,          SYS_mmap,         SYS_munmap,        SYS_mprotect,
    SYS_mremap,       SYS_madvise,        SYS_brk,          SYS_futex,         SYS_sched_yield,
    SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_sigaltstack,   SYS_restart_syscall,
    SYS_getpid,       SYS_gettid,         SYS_getrusage,    SYS_clock_gettime, SYS_clock_getres,
    SYS_gettimeofday, SYS_getrandom,      SYS_exit,         SYS_exit_group};
// What an answer has no use for.
constexpr unsigned deadly[] = {SYS_clone, SYS_clone3, SYS_execve, SYS_execveat,
                               SYS_kill,  SYS_socket, SYS_ptrace,
#ifdef __x86_64__
                               SYS_fork,  SYS_vfork,  SYS_creat
#endif
};

class Filter {
 public:
  void add(unsigned short code, unsigned value, unsigned char yes = 0, unsigned char no = 0) {
    if (length_ == rules_.size()) give_up("judged.cpp: too many rules\n");
    rules_[length_++] = {code, yes, no, value};
  }
  void load(std::size_t offset) { add(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset)); }
  void end(unsigned verdict) { add(BPF_RET | BPF_K, verdict); }
  void on_call(unsigned number, unsigned verdict) {
    add(BPF_JMP | BPF_JEQ | BPF_K, number, 0, 1);
    end(verdict);
  }
  /// Opening a file: deadly for writing.
  void on_open(unsigned number, std::size_t flags, unsigned for_reading) {
    add(BPF_JMP | BPF_JEQ | BPF_K, number, 0, 4);
    load(flags);
    add(BPF_JMP | BPF_JSET | BPF_K, O_WRONLY | O_RDWR | O_CREAT | O_TRUNC, 0, 1);
    end(SECCOMP_RET_KILL_PROCESS);
    end(for_reading);
  }
  /// A signal to a thread: only to one's own, which is how a program aborts.
  void on_signal(unsigned number) {
    add(BPF_JMP | BPF_JEQ | BPF_K, number, 0, 4);
    load(argument(0));
    add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(getpid()), 0, 1);
    end(SECCOMP_RET_ALLOW);
    end(SECCOMP_RET_KILL_PROCESS);
  }
  [[nodiscard]] bool install() {
    const sock_fprog program{static_cast<unsigned short>(length_), rules_.data()};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
  }
  static std::size_t argument(std::size_t i) { return offsetof(seccomp_data, args) + 8 * i; }

 private:
  std::array<sock_filter, 128> rules_{};
  std::size_t length_ = 0;
};

bool enclose(bool reads) {
  const unsigned reading = reads ? SECCOMP_RET_ALLOW : SECCOMP_RET_ERRNO | EACCES;
  Filter filter;
  filter.load(offsetof(seccomp_data, arch));
  filter.add(BPF_JMP | BPF_JEQ | BPF_K, machine, 1, 0);
  filter.end(SECCOMP_RET_KILL_PROCESS);
  filter.load(offsetof(seccomp_data, nr));
  for (const unsigned number : allowed) filter.on_call(number, SECCOMP_RET_ALLOW);
  for (const unsigned number : deadly) filter.on_call(number, SECCOMP_RET_KILL_PROCESS);
  filter.on_open(SYS_openat, Filter::argument(2), reading);
  filter.on_call(SYS_newfstatat, reading);
#ifdef __x86_64__
  filter.on_open(SYS_open, Filter::argument(1), reading);
  filter.on_call(SYS_stat, reading);
#endif
  filter.on_signal(SYS_tgkill);
  filter.end(SECCOMP_RET_ERRNO | EPERM);
  return filter.install();
}
#else
bool enclose(bool /*reads*/) { return false; }
#endif

void begin(int /*argc*/, char** /*argv*/, char** environment) {
  constexpr const char* variable = "SIGNORINI_JUDGED=";
  const std::size_t n = std::strlen(variable);
  while (*environment != nullptr && std::strncmp(*environment, variable, n) != 0) ++environment;
  if (*environment == nullptr) return;
  std::array<unsigned long, 4> number{};
  char* rest = *environment + n;
  for (unsigned long& each : number) each = std::strtoul(rest, &rest, 10);
  const ssize_t length = read(from_judge, secret.data(), secret.size() - 1);
  close(from_judge);
  if (length < 2 || secret[static_cast<std::size_t>(length) - 1] != '\n')
    give_up("judged.cpp: no secret\n");
  secret[static_cast<std::size_t>(length) - 1] = '\0';
  limit(RLIMIT_CPU, number[0], number[0] + 1);
  limit(RLIMIT_AS, number[1], number[1]);
  limit(RLIMIT_FSIZE, number[2], number[2]);
  limit(RLIMIT_CORE, 0, 0);
  enclosed = enclose(number[3] != 0);
}

// Before any constructor of the program, of whatever priority: those of other files follow in the order of linking.
[[gnu::section(".preinit_array"), gnu::used]] void (*const first)(int, char**, char**) = begin;

struct ToJudge : Listener {
  using Listener::Listener;
  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    const Catch::Counts& assertions = stats.totals.assertions;
    tell(std::to_string(assertions.passed) + '\t' + std::to_string(assertions.failed) + '\t' +
         name_of(stats));
  }
  void testRunEnded(const Catch::TestRunStats& /*stats*/) override {
    tell(enclosed ? "end\tenclosed" : "end\topen");
  }
};

}  // namespace

CATCH_REGISTER_LISTENER(ToJudge)
