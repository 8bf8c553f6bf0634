// Worker threads with a stack of a stated size. Reading, building and tracing all share this.
#pragma once
#include <cstddef>
#include <functional>

/// How many threads this process may run at once: the cores that it is allowed to use, at least 1.
int hardwareThreads();

/// Calls work(0) .. work(threads - 1), in any order, each on a thread of its own with at least
/// `stackBytes` bytes of stack (0: the least there is), and returns when all have returned. threads
/// >= 1; where the system gives fewer, the calls share those it gives. The first exception that any
/// call throws is thrown again here, after all have ended; std::system_error where not even one
/// thread can be had.
void runOnThreads(int threads, std::size_t stackBytes, const std::function<void(int)>& work);

/// Calls work(0) .. work(count - 1), as runOnThreads does but on at most `threads` threads, each of
/// which takes the next call when it is done with one; on the calling thread, with the stack that
/// it has, where one is enough. Indices are handed out in ascending order, but calls run side by
/// side and end in any order; on one thread each ends before the next begins. After an exception no
/// further call is begun; those that were begun are ended, and one of their exceptions is thrown
/// again here.
void shareOnThreads(int threads, std::size_t stackBytes, std::size_t count,
                    const std::function<void(std::size_t)>& work);

/// The same for calls that hand something on to the next one on their thread: makeWork() makes the
/// `work` of each thread, on that thread.
void shareOnThreads(int threads, std::size_t stackBytes, std::size_t count,
                    const std::function<std::function<void(std::size_t)>()>& makeWork);
