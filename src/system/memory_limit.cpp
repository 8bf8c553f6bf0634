// The limit by which the system itself counts: it cannot be passed, whoever asks for memory.
#include "system/memory_limit.h"

#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace {

// Linux counts all private writable memory as data (since 4.7). Elsewhere that is the heap alone,
// and only the whole address space, code included, bounds everything.
#ifdef __linux__
constexpr auto kCounted = RLIMIT_DATA;
#else
constexpr auto kCounted = RLIMIT_AS;
#endif

}  // namespace

void limitMemory(std::size_t bytes) {
  struct rlimit limit;
  bool isSet = getrlimit(kCounted, &limit) == 0;
  if (isSet) {
    limit.rlim_cur = std::min(limit.rlim_cur, rlim_t(bytes));  // "no limit" is the largest number
    isSet = setrlimit(kCounted, &limit) == 0;
  }
  if (!isSet) throw std::system_error(errno, std::generic_category(), "cannot limit memory");
}
