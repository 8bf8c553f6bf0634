// Memory on POSIX: pages that are never touched are never had.
//
// mmap reserves addresses, which cost nothing; a page is given when it is first written, and taken
// back by munmap or madvise. On Linux madvise also asks for pages of 2 MB in place of 4 KB, where
// whole ones fit; elsewhere, and where the system refuses, all stays as it is.
#include "system/memory.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <new>
#include <system_error>

namespace {

constexpr std::size_t kLargePage = std::size_t(1) << 21;

// Linux counts all private writable memory as data (since 4.7). Elsewhere that is the heap alone,
// and only the whole address space, code included, bounds everything.
#ifdef __linux__
constexpr auto kCountedMemory = RLIMIT_DATA;
#else
constexpr auto kCountedMemory = RLIMIT_AS;
#endif

std::size_t smallPage() { return std::size_t(sysconf(_SC_PAGESIZE)); }

}  // namespace

PageBuffer::PageBuffer(std::size_t bytes) {
  if (bytes == 0) return;
  const bool isLarge = bytes >= 2 * kLargePage;
  bytes = roundedUp(bytes, isLarge ? kLargePage : smallPage());
  const std::size_t reserved = bytes + (isLarge ? kLargePage : 0);
  void* memory = mmap(nullptr, reserved, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  data_ = memory;
  bytes_ = reserved;
  if (!isLarge) return;
  // Whole large pages alone: the small ones at both ends took a tenth of a tree's building. And
  // rays visit nodes all over the tree: fewer, larger pages spare look-ups of addresses.
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::size_t before = roundedUp(begin, kLargePage) - begin;
  munmap(memory, before);
  data_ = static_cast<char*>(memory) + before;
  bytes_ -= before;
  shrink(bytes);
  preferLargePages(data_, bytes_);
}

PageBuffer::~PageBuffer() {
  if (data_) munmap(data_, bytes_);
}

void PageBuffer::shrink(std::size_t bytes) {
  const std::size_t kept = roundedUp(bytes, smallPage());
  if (!data_ || kept >= bytes_) return;
  munmap(static_cast<char*>(data_) + kept, bytes_ - kept);
  bytes_ = kept;
  if (kept == 0) data_ = nullptr;
}

void PageBuffer::discard(std::size_t begin, std::size_t end) {
  const std::size_t from = roundedUp(begin, smallPage()), to = end / smallPage() * smallPage();
  if (data_ && from < to) madvise(static_cast<char*>(data_) + from, to - from, MADV_DONTNEED);
}

void preferLargePages(const void* memory, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  // From the first to the last large page that lies wholly within.
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = roundedUp(begin, kLargePage);
  const std::uintptr_t last = (begin + bytes) / kLargePage * kLargePage;
  char* const start = static_cast<char*>(const_cast<void*>(memory));
  if (first < last) (void)madvise(start + (first - begin), last - first, MADV_HUGEPAGE);
#else
  (void)memory;
  (void)bytes;
#endif
}

/// The system itself counts, so that the limit cannot be passed, whoever asks for memory.
void limitMemory(std::size_t bytes) {
  struct rlimit limit;
  bool isSet = getrlimit(kCountedMemory, &limit) == 0;
  if (isSet) {
    limit.rlim_cur = std::min(limit.rlim_cur, rlim_t(bytes));  // "no limit" is the largest number
    isSet = setrlimit(kCountedMemory, &limit) == 0;
  }
  if (!isSet) throw std::system_error(errno, std::generic_category(), "cannot limit memory");
}
