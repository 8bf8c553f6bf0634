// Arena: blocks of memory one behind the other. A table that does not fit into the rest of a block
// goes to the next one, which is made where there is none.
#include "system/arena.h"

#include <algorithm>

/// Goes on to the next block that has room for so many bytes.
void Arena::findRoom(std::size_t bytes) {
  constexpr std::size_t kLeastBlock = std::size_t(1) << 16;
  std::size_t block = blocks_.empty() ? 0 : block_ + 1;
  while (block < blocks_.size() && blocks_[block].size < bytes) ++block;
  if (block == blocks_.size()) {
    // Each block is as large as all before it, so that there are few.
    const std::size_t last = blocks_.empty() ? 0 : blocks_.back().size;
    const std::size_t size = roundedUp(std::max({bytes, kLeastBlock, 2 * last}), kAlignment);
    blocks_.push_back({std::make_unique<Line[]>(size / kAlignment), size});
  }
  goTo(block, blocks_[block].begin());
}
