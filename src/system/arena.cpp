// Arena: blocks of memory one behind the other. A table that does not fit into the rest of a block
// goes to the next one, which is made where there is none.
#include "system/arena.h"

#include <algorithm>
#include <cstdint>

namespace {

constexpr std::size_t kLeastBlock = std::size_t(1) << 16;

constexpr std::size_t roundedUp(std::size_t bytes) {
  return (bytes + Arena::kAlignment - 1) / Arena::kAlignment * Arena::kAlignment;
}

}  // namespace

void* Arena::takeBytes(std::size_t bytes) {
  bytes = roundedUp(bytes);
  while (block_ < blocks_.size() && blocks_[block_].size - used_ < bytes) {
    ++block_;
    used_ = 0;
  }
  if (block_ == blocks_.size()) {
    // Each block is as large as all before it, so that there are few.
    const std::size_t last = blocks_.empty() ? 0 : blocks_.back().size;
    const std::size_t size = roundedUp(std::max({bytes, kLeastBlock, 2 * last}));
    Block block{std::unique_ptr<unsigned char[]>(new unsigned char[size + kAlignment]), nullptr,
                size};
    const auto address = reinterpret_cast<std::uintptr_t>(block.memory.get());
    block.begin = block.memory.get() + (roundedUp(address) - address);
    blocks_.push_back(std::move(block));
  }
  void* memory = blocks_[block_].begin + used_;
  used_ += bytes;
  return memory;
}
