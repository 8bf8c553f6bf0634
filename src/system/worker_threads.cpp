// Worker threads on POSIX threads: std::thread cannot be given a stack size.
//
// Work is a number of calls that are told apart by an index. All threads share one counter: each
// takes the next index from it, makes that call, and comes back for another, until the indices are
// used up. So nobody waits for a slow neighbour, and where the system starts fewer threads than
// were asked for, those it starts make all calls. A thread never lets an exception out, which would
// end the process: the first is kept until all have ended and thrown again in the caller.
//
// Threads live as long as one such call. To start one takes some tens of microseconds, the work
// milliseconds; a pool that waits between calls would have to be owned, and stopped, by somebody.
#include "system/worker_threads.h"

#include <pthread.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <vector>

#include "system/memory.h"

namespace {

/// What the threads of one call of runOnThreads share; it lives on the caller's stack.
struct SharedWork {
  const std::function<void(int)>& work;
  const int count;
  std::atomic<int> next{0};
  std::mutex mutex;
  std::exception_ptr failure;  // guarded by mutex

  void runAll() {
    for (int index; (index = next++) < count;) {
      try {
        work(index);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!failure) failure = std::current_exception();
      }
    }
  }
};

extern "C" void* runSharedWork(void* work) {
  static_cast<SharedWork*>(work)->runAll();
  return nullptr;
}

}  // namespace

int hardwareThreads() {
  cpu_set_t allowed;  // fewer than the machine has, under taskset or in a container
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
    return std::max(1, CPU_COUNT(&allowed));
  }
  return int(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));  // more cores than a cpu_set_t holds
}

void runOnThreads(int threads, std::size_t stackBytes, const std::function<void(int)>& work) {
  SharedWork shared{work, threads, {}, {}, {}};
  std::vector<pthread_t> started;
  started.reserve(std::size_t(threads));
  // From here on nothing throws until all is given back.
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  constexpr std::size_t kUnit = 65536;  // a multiple of every page, and enough for any system
  pthread_attr_setstacksize(&attributes, roundedUp(std::max(stackBytes, kUnit), kUnit));
  int error = 0;
  for (int i = 0; i < threads && error == 0; ++i) {
    pthread_t thread;
    error = pthread_create(&thread, &attributes, runSharedWork, &shared);
    if (error == 0) started.push_back(thread);
  }
  for (const pthread_t thread : started) pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  if (started.empty()) {
    const std::string room = std::to_string(stackBytes >> 20) + " MB of stack";
    throw std::system_error(error, std::generic_category(), "cannot start a thread with " + room);
  }
  if (shared.failure) std::rethrow_exception(shared.failure);
}

void shareOnThreads(int threads, std::size_t stackBytes, std::size_t count,
                    const std::function<void(std::size_t)>& work) {
  shareOnThreads(threads, stackBytes, count, [&] { return std::ref(work); });
}

void shareOnThreads(int threads, std::size_t stackBytes, std::size_t count,
                    const std::function<std::function<void(std::size_t)>()>& makeWork) {
  std::atomic<std::size_t> next{0};
  // Each thread is one call of runOnThreads, which makes many of ours: the counter of indices is
  // another one, so that an exception can use it up.
  const auto takeCalls = [&](int) {
    try {
      const std::function<void(std::size_t)> work = makeWork();
      for (std::size_t i; (i = next++) < count;) work(i);
    } catch (...) {
      next = count;
      throw;
    }
  };
  const auto most = int(std::min(count, std::size_t(threads)));
  most <= 1 ? takeCalls(0) : runOnThreads(most, stackBytes, takeCalls);
}
