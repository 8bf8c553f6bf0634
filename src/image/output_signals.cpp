// What signals do to outputs that are not finished: their temporary files are removed.
// The one exception to "no globals": a signal handler receives nothing but a number, and may use
// neither locks nor the heap, so that what it needs can only stand in static memory: the names of
// the temporary files, in slots. A file is created and its name noted while all signals are blocked
// in that thread, and a handler in another thread waits for it (`isChanging`); once a handler has
// begun (`isEnding`) nothing is created any more. A slot is free again as soon as its file has been
// renamed or removed.
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
  Flag isTaken{false};
  char name[PATH_MAX] = {};
};

Slot slots[kMostTemporaries];
Flag isChanging{false};  // a thread is creating a file and noting its name
Flag isLineOpenNow{false};
Flag isEnding{false};

/// As long as it lives, a file is created and noted, or neither.
class NoSignalsHere {
 public:
  NoSignalsHere() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
    while (isChanging.exchange(true) || isEnding) {
      if (!isEnding) continue;
      isChanging = false;  // which the handler, in another thread, waits for
      pause();             // until its _exit
    }
  }
  ~NoSignalsHere() {
    isChanging = false;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoSignalsHere(const NoSignalsHere&) = delete;
  NoSignalsHere& operator=(const NoSignalsHere&) = delete;

 private:
  sigset_t before_;
};

Flag passedTo{-1};  // the descriptor of who wants to hear of signals
Flag passing{0};    // handlers that are just writing there
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
  bool isPassed = false;
  struct timespec now = {};
  if (descriptor >= 0 && clock_gettime(CLOCK_MONOTONIC, &now) == 0) {
    const Milliseconds time = std::max(
        Milliseconds{1}, Milliseconds(now.tv_sec) * 1000 + Milliseconds(now.tv_nsec / 1000000));
    Milliseconds first = 0;
    if (firstPass.compare_exchange_strong(first, time)) first = time;
    const auto byte = static_cast<unsigned char>(signal);
    isPassed = time - first <= kPatience && write(descriptor, &byte, 1) == 1;
  }
  --passing;
  return isPassed;
}

void removeTemporaries() {
  for (const Slot& slot : slots) {
    if (slot.isTaken) unlink(slot.name);
  }
}

extern "C" void passOrEnd(int signal) {
  const int error = errno;  // of what the signal interrupted
  if (!pass(signal)) endOnSignal(signal);
  errno = error;
}

/// For crashes: SA_RESETHAND has put the default action back, which the second signal meets.
extern "C" void removeAndCrash(int signal) {
  removeTemporaries();
  raise(signal);
}

void install(int signal, void (*handler)(int), int flags) {
  struct sigaction before = {}, action = {};
  sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;  // nohup, or a background job of a plain shell
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigfillset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void OutputFile::createTemporary(unsigned permissions) {
  const NoSignalsHere guard;
  Slot* const free = std::find_if(std::begin(slots), std::end(slots),
                                  [](const Slot& slot) { return slot.isTaken == 0; });
  errno = free == std::end(slots) ? EMFILE : ENAMETOOLONG;
  if (free == std::end(slots) || temporary_.size() >= sizeof free->name) return;
  descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
  if (descriptor_ < 0) return;
  std::memcpy(free->name, temporary_.c_str(), temporary_.size() + 1);
  free->isTaken = true;
  slot_ = static_cast<int>(free - slots);
}

void OutputFile::forgetTemporary() {
  slots[slot_].isTaken = false;
  slot_ = -1;
}

void passSignalsTo(int descriptor) {
  passedTo = descriptor;
  while (passing > 0) {
  }
}

void endOnSignal(int signal) {
  isEnding = true;
  while (isChanging) {
  }
  removeTemporaries();
  struct pollfd errors = {STDERR_FILENO, POLLOUT, 0};  // a pipe that nobody reads may be full
  const bool takesMore =
      isLineOpen() && poll(&errors, 1, 0) == 1 && (errors.revents & POLLOUT) != 0;
  if (takesMore && write(STDERR_FILENO, "\n", 1) < 0) _exit(128 + signal);
  _exit(128 + signal);
}

void setLineOpen(bool isOpen) { isLineOpenNow = isOpen; }
bool isLineOpen() { return isLineOpenNow; }

void waitIfEnding() {
  while (isEnding) pause();
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
