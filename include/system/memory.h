// Memory as the operating system gives it: by pages, some larger than others, and up to a limit.
#pragma once
#include <cstddef>
#include <utility>

/// The least multiple of `unit` that is not below `bytes`.
constexpr std::size_t roundedUp(std::size_t bytes, std::size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

/// A large array that costs memory only where it has been written: who fills it reserves for the
/// worst case, fills the front, and gives the rest back. Raw zeroed memory, aligned to a page.
/// Movable, not copyable.
class PageBuffer {
 public:
  PageBuffer() = default;
  /// Reserves `bytes`, in large pages where there are many: memory is then had in pieces of
  /// megabytes. Throws std::bad_alloc where the system has no such room.
  explicit PageBuffer(std::size_t bytes);
  ~PageBuffer();
  PageBuffer(PageBuffer&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  PageBuffer& operator=(PageBuffer&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }

  /// Null where nothing is reserved. Owned by the buffer.
  void* data() { return data_; }
  const void* data() const { return data_; }
  /// In bytes, a multiple of the page.
  std::size_t size() const { return bytes_; }

  /// Gives back everything behind the first `bytes`.
  void shrink(std::size_t bytes);
  /// Gives back the whole pages within bytes [begin, end), which must not be read any more.
  void discard(std::size_t begin, std::size_t end);

 private:
  void* data_ = nullptr;
  std::size_t bytes_ = 0;
};

/// Says that `bytes` bytes from `memory` on will be filled soon, so that the system gives large
/// pages for them where it can. Changes nothing but the time that takes: the pages touched are
/// fewer (filling 38 MB by one thread took 0.7 of the time).
void preferLargePages(const void* memory, std::size_t bytes);

/// From now on, asking for memory that would take the process above `bytes` fails: `new` and
/// PageBuffer throw std::bad_alloc, and a thread whose stack does not fit is not started. Counted
/// is what the process may write to, used or only reserved: its data, heap, mappings and stacks
/// (but the first thread's), not its code. A stricter limit that holds already stays. Never lifted
/// again. Throws std::system_error where the system refuses.
void limitMemory(std::size_t bytes);
