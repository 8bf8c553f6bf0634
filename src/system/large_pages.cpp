// Large pages on Linux; elsewhere nothing.
#include "system/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

void preferLargePages(const void* memory, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t kLargePage = std::uintptr_t(1) << 21;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + kLargePage - 1) / kLargePage * kLargePage;
  const std::uintptr_t last = (begin + bytes) / kLargePage * kLargePage;
  char* whole = static_cast<char*>(const_cast<void*>(memory));
  // Where the system refuses, all stays as it is.
  if (first < last) (void)madvise(whole + (first - begin), last - first, MADV_HUGEPAGE);
#else
  (void)memory;
  (void)bytes;
#endif
}
