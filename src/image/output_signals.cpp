// What signals do to outputs that are not finished: their temporary files are removed.
// The one exception to "no globals": a signal handler receives nothing but a number, and may use
// neither the heap nor a mutex, so that what it needs can only stand in static memory: where the
// names of the temporary files are. A file is created and its name noted, or renamed and its name
// dropped, as one step that no signal can split: signals are blocked in that thread, and a handler
// in another thread waits for it (Undisturbed). A handler that ends the program stays in that state
// for good, so that nothing is created or renamed any more.
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include "image/output_file.h"

namespace {

/// True or false in a word: riscv64 locks for less.
using Flag = std::atomic<int>;
using Name = std::atomic<const char*>;
static_assert(Flag::is_always_lock_free && Name::is_always_lock_free, "used in signal handlers");

Name temporaries[16];  // null: free; owned by the OutputFile. A run has a handful open at once.
Flag isDisturbanceBarred{false};
Flag isLineOpenNow{false};

/// As long as one lives, no signal reaches its thread, and no other thread has one.
class Undisturbed {
 public:
  Undisturbed() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
    while (isDisturbanceBarred.exchange(true)) {  // for one system call, or until the program ends
    }
  }
  ~Undisturbed() {
    isDisturbanceBarred = false;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;

 private:
  sigset_t before_;
};

void removeTemporaries() {
  for (const char* const name : temporaries) {
    if (name) unlink(name);
  }
}

/// Ends the program with status 128 + `signal`.
extern "C" void removeAndEnd(int signal) {
  const Undisturbed untilTheEnd;
  removeTemporaries();
  struct pollfd errors = {STDERR_FILENO, POLLOUT, 0};  // a pipe that nobody reads may be full
  const bool endsLine = isLineOpen() && poll(&errors, 1, 0) == 1;
  [[maybe_unused]] const ssize_t written = endsLine ? write(STDERR_FILENO, "\n", 1) : 0;
  _exit(128 + signal);
}

/// For crashes: SA_RESETHAND has put the default action back, which the second signal meets. Waits
/// for nobody, as the thread that it interrupts may be the one that is Undisturbed.
extern "C" void removeAndCrash(int signal) {
  removeTemporaries();
  raise(signal);
}

/// While the handler runs, it is the only one in its thread.
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

/// O_EXCL: a file of that name is another run's, or left by one that was killed.
void OutputFile::createTemporary(unsigned permissions) {
  const Undisturbed whileNoting;
  Name* const free = std::find(std::begin(temporaries), std::end(temporaries), nullptr);
  errno = EMFILE;
  if (free == std::end(temporaries)) return;
  descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
  if (descriptor_ < 0) return;
  *free = temporary_.c_str();
  isTemporary_ = true;
}

bool OutputFile::endTemporary(bool isWhole) {
  const Undisturbed whileNoting;
  if (isWhole && std::rename(temporary_.c_str(), target_.c_str()) != 0) return false;
  if (!isWhole) unlink(temporary_.c_str());
  *std::find(std::begin(temporaries), std::end(temporaries), temporary_.c_str()) = nullptr;
  isTemporary_ = false;
  return true;
}

void setLineOpen(bool isOpen) { isLineOpenNow = isOpen; }
bool isLineOpen() { return isLineOpenNow; }

void removeTemporaryOnSignals() {
  for (const int signal :
       {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2, SIGXCPU}) {
    install(signal, removeAndEnd, SA_RESTART);
  }
  for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGTRAP, SIGSYS}) {
    install(signal, removeAndCrash, static_cast<int>(SA_RESETHAND));
  }
  for (const int signal : {SIGPIPE, SIGXFSZ}) install(signal, SIG_IGN, 0);
}
