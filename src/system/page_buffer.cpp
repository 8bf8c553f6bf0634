// PageBuffer on mmap: pages that are never touched are never had.
#include "system/page_buffer.h"

#include <sys/mman.h>
#include <unistd.h>

#include <new>

namespace {

constexpr std::size_t kHugePage = 2 << 20;

std::size_t roundedToPage(std::size_t bytes) {
  const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE));
  return (bytes + page - 1) / page * page;
}

}  // namespace

PageBuffer::PageBuffer(std::size_t bytes, Pages pages) : bytes_(roundedToPage(bytes)) {
  if (bytes_ == 0) return;
  void* memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  data_ = memory;
#ifdef MADV_HUGEPAGE
  // Rays visit nodes all over the tree: fewer, larger pages spare look-ups of addresses.
  if (pages == Pages::large && bytes_ >= 2 * kHugePage) madvise(memory, bytes_, MADV_HUGEPAGE);
#else
  (void)pages;
#endif
}

PageBuffer::~PageBuffer() {
  if (data_) munmap(data_, bytes_);
}

void PageBuffer::shrink(std::size_t bytes) {
  const std::size_t kept = roundedToPage(bytes);
  if (!data_ || kept >= bytes_) return;
  munmap(static_cast<char*>(data_) + kept, bytes_ - kept);
  bytes_ = kept;
  if (kept == 0) data_ = nullptr;
}

void PageBuffer::discard(std::size_t begin, std::size_t end) {
  const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE));
  const std::size_t from = roundedToPage(begin), to = end / page * page;
  if (data_ && from < to) madvise(static_cast<char*>(data_) + from, to - from, MADV_DONTNEED);
}
