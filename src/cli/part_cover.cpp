// Whether parts make up a whole picture.
#include "cli/part_cover.h"

#include <algorithm>
#include <set>
#include <utility>

namespace {

/// Pixels left <= x < right of rows top <= y < bottom.
struct Place {
  int left, top, right, bottom;
};

std::string spanText(const char* one, int from, int to) {
  if (to - from == 1) return std::string(one) + " " + std::to_string(from);
  return std::string(one) + "s " + std::to_string(from) + " to " + std::to_string(to - 1);
}

std::string placeText(const Place& place, int width) {
  std::string rows = spanText("row", place.top, place.bottom);
  if (place.left == 0 && place.right == width) return rows;
  return spanText("pixel", place.left, place.right) + " of " + rows;
}

/// Goes down the picture in bands, in each of which the same parts lie beside each other.
class Cover {
 public:
  Cover(const std::vector<PartFile>& parts, int width, int height) : parts_(parts), width_(width) {
    std::set<int> edges = {0, height};
    for (const PartFile& part : parts) edges.insert({part.y, part.y + part.height});
    auto edge = edges.begin();
    for (int top = *edge++; edge != edges.end(); top = *edge++) checkBand(top, *edge);
    for (const Place& gap : gaps_) report(gap);
  }

  std::vector<std::string> takeMistakes() { return std::move(mistakes_); }

 private:
  void checkBand(int top, int bottom) {
    advance(top);
    int end = 0;
    const PartFile* reaching = nullptr;  // the part that ends there
    for (const PartFile* part : active_) {
      if (part->x > end) addGap({end, top, part->x, bottom});
      if (part->x < end) addOverlap(*reaching, *part);
      if (part->x + part->width <= end) continue;
      end = part->x + part->width;
      reaching = part;
    }
    if (end < width_) addGap({end, top, width_, bottom});
  }

  /// Makes active_ the parts that hold pixels of row `top`, by their x.
  void advance(int top) {
    const auto isOver = [top](const PartFile* part) { return part->y + part->height <= top; };
    active_.erase(std::remove_if(active_.begin(), active_.end(), isOver), active_.end());
    const std::size_t old = active_.size();
    for (; next_ < parts_.size() && parts_[next_].y == top; ++next_) {
      active_.push_back(&parts_[next_]);
    }
    const auto isLeft = [](const PartFile* a, const PartFile* b) { return a->x < b->x; };
    std::inplace_merge(active_.begin(), active_.begin() + std::ptrdiff_t(old), active_.end(),
                       isLeft);
  }

  /// Joined to a gap of the same pixels in the band above.
  void addGap(const Place& place) {
    for (Place& gap : gaps_) {
      if (gap.bottom != place.top || gap.left != place.left || gap.right != place.right) continue;
      gap.bottom = place.bottom;
      return;
    }
    if (gaps_.size() < kMost) gaps_.push_back(place);
  }

  void addOverlap(const PartFile& a, const PartFile& b) {
    if (mistakes_.size() >= kMost || !overlapping_.insert({&a, &b}).second) return;
    const Place both = {std::max(a.x, b.x), std::max(a.y, b.y),
                        std::min(a.x + a.width, b.x + b.width),
                        std::min(a.y + a.height, b.y + b.height)};
    mistakes_.push_back(a.path + " and " + b.path + ": expected parts that do not overlap, found " +
                        placeText(both, width_) + " in both");
  }

  void report(const Place& gap) {
    const bool isOne = gap.bottom - gap.top == 1 && gap.left == 0 && gap.right == width_;
    mistakes_.push_back(
        "no part holds " + placeText(gap, width_) + "; -region " + std::to_string(gap.left) + " " +
        std::to_string(gap.top) + " " + std::to_string(gap.right - gap.left) + " " +
        std::to_string(gap.bottom - gap.top) + " renders " + (isOne ? "it" : "them"));
  }

  static constexpr std::size_t kMost = 20;  // of each kind

  const std::vector<PartFile>& parts_;
  const int width_;
  std::size_t next_ = 0;  // the first part that no band has reached
  std::vector<const PartFile*> active_;
  std::vector<Place> gaps_;
  std::set<std::pair<const PartFile*, const PartFile*>> overlapping_;
  std::vector<std::string> mistakes_;
};

}  // namespace

std::vector<std::string> coverMistakes(const std::vector<PartFile>& parts, int width, int height) {
  return Cover(parts, width, height).takeMistakes();
}
