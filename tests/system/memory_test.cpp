// Memory by pages: where it begins, and what is left of it.
#include "system/memory.h"

#include <cstdint>
#include <cstring>

#include "check.h"

TEST("a large buffer begins at a large page, whose first touch gives 2 MB at once") {
  constexpr std::size_t kLargePage = std::size_t(1) << 21;
  for (const std::size_t bytes : {2 * kLargePage, 5 * kLargePage + 1, 16 * kLargePage - 4096}) {
    PageBuffer buffer(bytes);
    CHECK_EQUAL(reinterpret_cast<std::uintptr_t>(buffer.data()) % kLargePage, 0u);
    CHECK(buffer.size() >= bytes);
    std::memset(buffer.data(), 1, bytes);  // all of it is there
    buffer.shrink(bytes / 2);
    CHECK(buffer.size() >= bytes / 2 && buffer.size() < bytes / 2 + 65536);
  }
}
