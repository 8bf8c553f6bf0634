// PageBuffer: a large array that costs memory only where it has been written.
// The builder reserves for the worst case, fills the front, and gives the rest back.
#pragma once
#include <cstddef>
#include <utility>

/// Raw zeroed memory, aligned to a page. Movable, not copyable.
class PageBuffer {
 public:
  PageBuffer() = default;
  /// Large pages are faster, but memory is then had in pieces of megabytes, so they are for what is
  /// filled from the front; `large` of a small size are small ones all the same.
  enum class Pages { small, large };
  /// Reserves `bytes`; throws std::bad_alloc where the system has no such room.
  explicit PageBuffer(std::size_t bytes, Pages pages = Pages::large);
  ~PageBuffer();
  PageBuffer(PageBuffer&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  PageBuffer& operator=(PageBuffer&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }

  void* data() { return data_; }
  const void* data() const { return data_; }
  std::size_t size() const { return bytes_; }

  /// Gives back everything behind the first `bytes`.
  void shrink(std::size_t bytes);
  /// Gives back the whole pages within bytes [begin, end), which must not be read any more.
  void discard(std::size_t begin, std::size_t end);

 private:
  void* data_ = nullptr;
  std::size_t bytes_ = 0;
};
