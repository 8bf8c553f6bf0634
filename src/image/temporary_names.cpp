// TemporaryNames: the signal handler that leaves no temporary file, and what it reads.
// The one exception to "no globals": a signal handler receives nothing but a number, and may use
// neither locks nor the heap, so that what it needs can only stand in static memory.
#include "image/temporary_names.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>

#include "image/output_file.h"

namespace {

constexpr int kMostTemporaries = 16;  // outputs open at once; a run has a handful

/// True or false in a word: riscv64 locks for less.
using Flag = std::atomic<int>;
static_assert(Flag::is_always_lock_free, "used in a signal handler");

struct Slot {
  Flag taken{false};
  char name[PATH_MAX] = {};
};

Slot slots[kMostTemporaries];
Flag changing{false};    // a thread is creating a file and noting its name
Flag lineIsOpen{false};  // on standard error
Flag ending{false};      // a handler has begun: nothing may be created any more

/// Blocks all signals in this thread and keeps handlers in other threads waiting, so that a file
/// is created and noted, or neither.
class NoSignalsHere {
 public:
  NoSignalsHere() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
    while (changing.exchange(true) || ending) {
      if (!ending) continue;
      changing = false;  // which the handler, in another thread, waits for
      pause();           // until its _exit
    }
  }
  ~NoSignalsHere() {
    changing = false;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoSignalsHere(const NoSignalsHere&) = delete;
  NoSignalsHere& operator=(const NoSignalsHere&) = delete;

 private:
  sigset_t before_;
};

std::atomic<int> passedTo{-1};  // who wants to hear of signals
std::atomic<int> passing{0};    // handlers that are just writing there
// When the first signal was passed, in ms; 0: none was. The clock begins again at 0 after 49 days,
// as differences of unsigned numbers do: a long of 32 bits would overflow after half of that.
using Milliseconds = std::uint32_t;
std::atomic<Milliseconds> firstPass{0};
constexpr Milliseconds kPatience = 100;
static_assert(std::atomic<Milliseconds>::is_always_lock_free, "used in a signal handler");

/// True where someone else will end the program.
bool pass(int signal) {
  ++passing;
  const int descriptor = passedTo;
  bool passed = false;
  struct timespec now = {};
  if (descriptor >= 0 && clock_gettime(CLOCK_MONOTONIC, &now) == 0) {
    const Milliseconds time = std::max(
        Milliseconds{1}, Milliseconds(now.tv_sec) * 1000 + Milliseconds(now.tv_nsec / 1000000));
    Milliseconds first = 0;
    if (firstPass.compare_exchange_strong(first, time)) first = time;
    const auto byte = static_cast<unsigned char>(signal);
    passed = time - first <= kPatience && write(descriptor, &byte, 1) == 1;
  }
  --passing;
  return passed;
}

extern "C" void passOrEnd(int signal) {
  const int error = errno;  // of what the signal interrupted
  if (!pass(signal)) endOnSignal(signal);
  errno = error;
}

/// For crashes: SA_RESETHAND has put the default action back, which the second signal meets.
extern "C" void removeAndCrash(int signal) {
  for (const Slot& slot : slots) {
    if (slot.taken) unlink(slot.name);
  }
  raise(signal);
}

void install(int signal, void (*handler)(int), int flags) {
  struct sigaction before = {};
  sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;  // nohup, or a background job of a plain shell
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigfillset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

int createTemporary(const std::string& name, unsigned permissions, int& slot) {
  const NoSignalsHere guard;
  errno = EMFILE;
  int free = 0;
  while (free < kMostTemporaries && slots[free].taken) ++free;
  if (free == kMostTemporaries) return -1;
  errno = ENAMETOOLONG;
  if (name.size() >= sizeof slots[free].name) return -1;
  const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
  if (descriptor < 0) return -1;
  std::memcpy(slots[free].name, name.c_str(), name.size() + 1);
  slots[free].taken = true;
  slot = free;
  return descriptor;
}

void forgetTemporary(int slot) { slots[slot].taken = false; }

void passSignalsTo(int descriptor) {
  passedTo = descriptor;
  while (passing > 0) {
  }
}

void endOnSignal(int signal) {
  ending = true;
  while (changing) {
  }
  for (const Slot& slot : slots) {
    if (slot.taken) unlink(slot.name);
  }
  struct pollfd errors = {STDERR_FILENO, POLLOUT, 0};  // a pipe that nobody reads may be full
  const bool takesMore = lineIsOpen && poll(&errors, 1, 0) == 1 && (errors.revents & POLLOUT) != 0;
  if (takesMore && write(STDERR_FILENO, "\n", 1) < 0) _exit(128 + signal);
  _exit(128 + signal);
}

void setLineOpen(bool isOpen) { lineIsOpen = isOpen; }

bool isLineOpen() { return lineIsOpen; }

void waitIfEnding() {
  while (ending) pause();
}

void removeTemporaryOnSignals() {
  for (const int signal :
       {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2, SIGXCPU}) {
    install(signal, passOrEnd, SA_RESTART);
  }
  for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGTRAP, SIGSYS}) {
    install(signal, removeAndCrash, static_cast<int>(SA_RESETHAND));
  }
  for (const int signal : {SIGPIPE, SIGXFSZ}) install(signal, SIG_IGN, 0);
}
