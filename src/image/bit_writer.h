// BitWriter: bits in deflate's order, the lowest bit of each byte first.
#pragma once
#include "image/bytes.h"

class BitWriter {
 public:
  /// The `count` lowest bits of `value`, 0 to 32, the others being 0; the lowest bit first.
  void put(std::uint32_t value, unsigned count) {
    held_ |= std::uint64_t{value} << heldCount_;
    for (heldCount_ += count; heldCount_ >= 8; heldCount_ -= 8, held_ >>= 8) {
      bytes_.push_back(static_cast<std::uint8_t>(held_ & 255));
    }
  }
  /// Zeros to the end of the byte.
  void fillByte() { put(0, (8 - heldCount_) % 8); }
  unsigned bitsInByte() const { return heldCount_; }

  /// All whole bytes so far, which are then forgotten.
  Bytes take() {
    Bytes whole;
    whole.swap(bytes_);
    return whole;
  }

 private:
  Bytes bytes_;
  std::uint64_t held_ = 0;
  unsigned heldCount_ = 0;  // below 8 between calls
};
