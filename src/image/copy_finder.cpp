// CopyFinder: chains of places with the same hash, the newest first.
#include "image/copy_finder.h"

#include <algorithm>

#include "image/deflate_tables.h"

using deflate::kLongestCopy;
using deflate::kShortestCopy;
using deflate::kWindow;

CopyFinder::CopyFinder(const std::uint8_t* bytes, std::size_t size, unsigned depth)
    : bytes_(bytes),
      size_(size),
      depth_(depth),
      newest_(std::size_t{1} << kHashBits, kNone),
      previous_(kWindow, kNone) {}

std::size_t CopyFinder::hashAt(std::size_t at) const {
  const std::uint32_t three =
      bytes_[at] | std::uint32_t{bytes_[at + 1]} << 8 | std::uint32_t{bytes_[at + 2]} << 16;
  return (three * 0x9E3779B1u) >> (32 - kHashBits);  // 2^32 over the golden ratio (Knuth, TAOCP 3)
}

void CopyFinder::add(std::size_t at) {
  if (size_ - at < kShortestCopy) return;
  std::size_t& newest = newest_[hashAt(at)];
  previous_[at % kWindow] = newest;
  newest = at;
}

void CopyFinder::remove(std::size_t from, std::size_t to) {
  for (std::size_t at = to; at-- > from;) {
    if (size_ - at >= kShortestCopy) newest_[hashAt(at)] = previous_[at % kWindow];
  }
}

void CopyFinder::find(std::size_t at, std::size_t end, std::vector<Copy>& copies) const {
  const std::size_t most = std::min<std::size_t>(end - at, kLongestCopy);
  if (most < kShortestCopy) return;
  std::size_t longest = kShortestCopy - 1;
  std::size_t place = newest_[hashAt(at)];
  for (unsigned tries = depth_; tries > 0 && place != kNone && at - place <= kWindow; --tries) {
    const std::uint8_t *a = bytes_ + place, *b = bytes_ + at;
    if (a[longest] == b[longest]) {
      std::size_t length = 0;
      while (length < most && a[length] == b[length]) ++length;
      if (length > longest) {
        longest = length;
        copies.push_back(
            {static_cast<std::uint16_t>(length), static_cast<std::uint16_t>(at - place)});
        if (length == most) return;
      }
    }
    const std::size_t before = previous_[place % kWindow];
    if (before >= place) return;  // overwritten by a newer place, or none
    place = before;
  }
}
