// Arena: what it hands out is aligned, apart and kept until a frame gives it back.
#include "system/arena.h"

#include <cstdint>
#include <cstring>
#include <vector>

#include "check.h"

namespace {

bool isAligned(const void* memory) {
  return reinterpret_cast<std::uintptr_t>(memory) % Arena::kAlignment == 0;
}

/// Whether all of `size` bytes have the value.
bool isFilled(const unsigned char* bytes, std::size_t size, unsigned char value) {
  for (std::size_t i = 0; i < size; ++i) {
    if (bytes[i] != value) return false;
  }
  return true;
}

}  // namespace

TEST("all that an arena hands out is aligned, whatever its type and count") {
  Arena arena;
  for (std::size_t count = 0; count < 200; ++count) {
    CHECK(isAligned(arena.take<char>(count)));
    CHECK(isAligned(arena.take<double>(count)));
    CHECK(isAligned(arena.take<std::uint16_t>(count)));
  }
}

TEST("what an arena hands out stays as it was written, in blocks of any size") {
  struct Piece {
    unsigned char* bytes;
    std::size_t size;
  };
  Arena arena;
  std::vector<Piece> pieces;
  // Each is 1.6 times as large as the one before: 1 byte to 2 MB, blocks of 64 KB and more.
  for (double size = 1; size < 2e6; size *= 1.6) {
    const auto bytes = std::size_t(size);
    pieces.push_back({arena.take<unsigned char>(bytes), bytes});
    // The bytes behind its end are its own too.
    std::memset(pieces.back().bytes, int(pieces.size()), bytes + Arena::kAlignment);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    CHECK(isFilled(pieces[i].bytes, pieces[i].size + Arena::kAlignment, (unsigned char)(i + 1)));
  }
}

TEST("a frame gives back what was taken in it, and nothing else") {
  Arena arena;
  auto* const before = arena.take<unsigned char>(100);
  std::memset(before, 7, 100);
  unsigned char* outer;
  {
    const Arena::Frame frame(arena);
    outer = arena.take<unsigned char>(1000);
    std::memset(outer, 8, 1000);
    unsigned char* inner;
    {
      const Arena::Frame nested(arena);
      inner = arena.take<unsigned char>(10);
      std::memset(inner, 9, 10);
    }
    CHECK(arena.take<unsigned char>(10) == inner);
    CHECK(isFilled(outer, 1000, 8));
  }
  CHECK(arena.take<unsigned char>(1000) == outer);
  CHECK(isFilled(before, 100, 7));
}

TEST("the blocks of an arena are kept: the same tables again lie where they lay") {
  Arena arena;
  std::vector<unsigned char*> first;
  for (int time = 0; time < 3; ++time) {
    const Arena::Frame frame(arena);
    for (std::size_t i = 0; i < 40; ++i) {  // 1.6 MB, more than one block
      auto* const memory = arena.take<unsigned char>(2000 * i);
      if (time == 0) {
        first.push_back(memory);
      } else {
        CHECK(memory == first[i]);
      }
    }
  }
}

TEST("a table too large for the blocks that are there gets a new one, and small ones fit again") {
  Arena arena;
  unsigned char* small;
  {
    const Arena::Frame frame(arena);
    small = arena.take<unsigned char>(10);
  }
  {
    const Arena::Frame frame(arena);
    auto* const large = arena.take<unsigned char>(3000000);
    std::memset(large, 5, 3000000);
    CHECK(isFilled(large, 3000000, 5));
  }
  CHECK(arena.take<unsigned char>(10) == small);
}
