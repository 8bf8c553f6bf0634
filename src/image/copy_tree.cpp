// CopyTree: the new place becomes the root, and the way down to it is split in two.
#include "image/copy_tree.h"

#include <algorithm>
#include <cstring>

#include "image/deflate_tables.h"

using deflate::kLongestCopy;
using deflate::kShortestCopy;
using deflate::kWindow;

namespace {

/// How many bytes agree, of which `known` are known to, up to `most`.
std::size_t agreeing(const std::uint8_t* a, const std::uint8_t* b, std::size_t known,
                     std::size_t most) {
  while (known + 8 <= most && std::memcmp(a + known, b + known, 8) == 0) known += 8;
  while (known < most && a[known] == b[known]) ++known;
  return known;
}

}  // namespace

CopyTree::CopyTree(const std::uint8_t* bytes, std::size_t size, unsigned depth)
    : bytes_(bytes),
      size_(size),
      depth_(depth),
      newest_(std::size_t{1} << kHashBits, kNone),
      nodes_(kWindow) {}

std::size_t CopyTree::hashAt(std::size_t at) const {
  const std::uint32_t three =
      bytes_[at] | std::uint32_t{bytes_[at + 1]} << 8 | std::uint32_t{bytes_[at + 2]} << 16;
  return (three * 0x9E3779B1u) >> (32 - kHashBits);  // 2^32 over the golden ratio (Knuth, TAOCP 3)
}

/// A node is overwritten by the place one window further on, so the very farthest is not found.
bool CopyTree::isInWindow(std::uint32_t place, std::size_t at) const {
  return place != kNone && at - place < kWindow;
}

void CopyTree::findAndAdd(std::size_t at, std::vector<Copy>& copies) {
  const std::size_t most = std::min<std::size_t>(size_ - at, kLongestCopy);
  if (most < kShortestCopy) return;
  std::uint32_t& newest = newest_[hashAt(at)];
  std::uint32_t place = newest;
  newest = static_cast<std::uint32_t>(at);
  std::uint32_t* less = &nodes_[at % kWindow].less;
  std::uint32_t* more = &nodes_[at % kWindow].more;
  std::size_t lessAgree = 0, moreAgree = 0, longest = kShortestCopy - 1;
  for (unsigned tries = depth_; tries > 0 && isInWindow(place, at); --tries) {
    const std::uint8_t *a = bytes_ + place, *b = bytes_ + at;
    Node& node = nodes_[place % kWindow];
    const std::size_t length = agreeing(a, b, std::min(lessAgree, moreAgree), most);
    if (length > longest) {
      longest = length;
      copies.push_back(
          {static_cast<std::uint16_t>(length), static_cast<std::uint16_t>(at - place)});
    }
    if (length == most) {  // takes the place of its equal
      *less = node.less;
      *more = node.more;
      return;
    }
    if (a[length] < b[length]) {
      *less = place;
      less = &node.more;
      place = *less;
      lessAgree = length;
    } else {
      *more = place;
      more = &node.less;
      place = *more;
      moreAgree = length;
    }
  }
  *less = *more = kNone;
}
