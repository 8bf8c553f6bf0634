// Arena: memory for one thread's tables, taken and given back like a stack.
#pragma once
#include <cstddef>
#include <type_traits>
#include <vector>

#include "system/memory.h"

/// Hands out memory by moving an end forward; a Frame moves it back. What it once had from the
/// system it keeps, so that tables which are needed again and again cost no allocation.
/// Not copyable; for one thread at a time.
class Arena {
 public:
  /// Everything is aligned to this: a cache line, and the widest vector.
  static constexpr std::size_t kAlignment = 64;

  Arena() = default;
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  /// Room for `count` objects of T, not initialised, until the innermost Frame ends. Behind it are
  /// kAlignment bytes more, so that a vector may run over its end. Throws std::bad_alloc.
  template <class T>
  T* take(std::size_t count) {
    static_assert(std::is_trivially_destructible<T>::value, "nobody calls destructors");
    // NOLINTNEXTLINE(bugprone-sizeof-expression): T may be a pointer.
    return static_cast<T*>(takeBytes(count * sizeof(T) + kAlignment));
  }

  /// Gives back what has been taken since it was made.
  class Frame {
   public:
    explicit Frame(Arena& arena) : arena_(arena), block_(arena.block_), next_(arena.next_) {}
    ~Frame() { arena_.goTo(block_, next_); }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

   private:
    Arena& arena_;
    const std::size_t block_;
    unsigned char* const next_;
  };

 private:
  unsigned char* beginOf(std::size_t block) {
    return static_cast<unsigned char*>(blocks_[block].data());
  }
  void* takeBytes(std::size_t bytes) {
    bytes = roundedUp(bytes, kAlignment);
    if (bytes > std::size_t(end_ - next_)) findRoom(bytes);
    void* const memory = next_;
    next_ += bytes;
    return memory;
  }
  void findRoom(std::size_t bytes);
  void goTo(std::size_t block, unsigned char* next) {
    // Before the first block there is nothing to go back to but the first one.
    block_ = block;
    next_ = next || blocks_.empty() ? next : beginOf(block);
    end_ = blocks_.empty() ? next : beginOf(block) + blocks_[block].size();
  }

  std::vector<PageBuffer> blocks_;
  std::size_t block_ = 0;                           // the one in use; those before it are full
  unsigned char *next_ = nullptr, *end_ = nullptr;  // what is free of it
};
