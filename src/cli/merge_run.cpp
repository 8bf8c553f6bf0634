// The run of `raytracer -merge`: every part is looked at before a pixel is read, and each mistake
// named; then the picture is put together row by row.
//
// Both go down the picture with the same list, PartsInRow: the parts that hold pixels of the row at
// hand. Whether they cover the picture is asked once for each band of rows in which the list stays
// the same: from left to right each part must begin where the one before ended. Where it begins
// later there is a gap, where it begins earlier two parts overlap. For n parts in the widest band
// that is O(n) a band, however large the picture.
#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

#include "cli/part_file.h"
#include "cli/program.h"
#include "cli/runs.h"
#include "image/output_file.h"
#include "image/picture_file.h"
#include "scene/input_error.h"
#include "scene/wording.h"
#include "system/worker_threads.h"

namespace {

using Parts = std::vector<PartFile>;

constexpr std::size_t kMostComplaints = 20;
constexpr std::size_t kMostOpen = 256;  // files at a time

/// The parts that hold pixels of a row, from left to right.
class PartsInRow {
 public:
  using Row = std::multimap<int, const PartFile*>;  // by their x

  /// `parts` are in the order of their y, those of the same y of their x. Not owned.
  explicit PartsInRow(const Parts& parts) : next_(parts.begin()), end_(parts.end()) {}

  /// To be called for rows further and further down, none in which a part begins left out.
  const Row& goTo(int y) {
    for (auto part = row_.begin(); part != row_.end();) {
      part = part->second->bottom() <= y ? row_.erase(part) : std::next(part);
    }
    for (; next_ != end_ && next_->y == y; ++next_) row_.emplace(next_->x, &*next_);
    return row_;
  }

 private:
  Parts::const_iterator next_;  // the first part that no row has reached
  const Parts::const_iterator end_;
  Row row_;
};

/// Pixels left <= x < right of rows top <= y < bottom, counted from 0 at the top and left.
struct Area {
  int left, top, right, bottom;
};

/// "row 3", or "rows 3 to 7": `to` is the first one that no longer belongs.
std::string spanText(const char* one, int from, int to) {
  if (to - from == 1) return std::string(one) + " " + std::to_string(from);
  return std::string(one) + "s " + std::to_string(from) + " to " + std::to_string(to - 1);
}

std::string areaText(const Area& area, int width) {
  std::string rows = spanText("row", area.top, area.bottom);
  if (area.left == 0 && area.right == width) return rows;
  return spanText("pixel", area.left, area.right) + " of " + rows;
}

/// Whether parts make up a whole picture: which files overlap and where, which pixels no part holds
/// and the argument that would render them. At most kMostComplaints of each are found.
class Cover {
 public:
  Cover(const Parts& parts, const PartId& whole) : width_(whole.width) {
    // The list of parts in a row can only change where one of them begins or ends.
    std::set<int> edges = {0, whole.height};
    for (const PartFile& part : parts) edges.insert({part.y, part.bottom()});
    PartsInRow inRow(parts);
    auto edge = edges.begin();
    for (int top = *edge++; edge != edges.end(); top = *edge++) {
      checkBand(top, *edge, inRow.goTo(top));
    }
    for (const Area& gap : gaps_) report(gap);
  }

  /// Empty where each pixel is in one part.
  const std::vector<std::string>& mistakes() const { return mistakes_; }

 private:
  /// Rows top <= y < bottom: from left to right, `end` being the first pixel that no part so far
  /// holds. A part may lie inside an earlier one, which then still reaches furthest.
  void checkBand(int top, int bottom, const PartsInRow::Row& row) {
    int end = 0;
    const PartFile* reaching = nullptr;  // the part that ends there
    for (const auto& [x, part] : row) {
      if (x > end) addGap({end, top, x, bottom});
      if (x < end) addOverlap(*reaching, *part);
      if (part->right() <= end) continue;
      end = part->right();
      reaching = part;
    }
    if (end < width_) addGap({end, top, width_, bottom});
  }

  /// Joined to a gap of the same pixels in the band above.
  void addGap(const Area& area) {
    for (Area& gap : gaps_) {
      if (gap.bottom != area.top || gap.left != area.left || gap.right != area.right) continue;
      gap.bottom = area.bottom;
      return;
    }
    if (gaps_.size() < kMostComplaints) gaps_.push_back(area);
  }

  /// Each two parts are told of once, although they may meet in many rows.
  void addOverlap(const PartFile& a, const PartFile& b) {
    if (mistakes_.size() >= kMostComplaints || !overlapping_.insert({&a, &b}).second) return;
    const Area both = {std::max(a.x, b.x), std::max(a.y, b.y), std::min(a.right(), b.right()),
                       std::min(a.bottom(), b.bottom())};
    mistakes_.push_back(a.path + " and " + b.path + ": expected parts that do not overlap, found " +
                        areaText(both, width_) + " in both");
  }

  /// -region takes X Y W H.
  void report(const Area& gap) {
    const int rows = gap.bottom - gap.top;
    const bool isOne = rows == 1 && gap.left == 0 && gap.right == width_;
    mistakes_.push_back("no part holds " + areaText(gap, width_) + "; -region " +
                        std::to_string(gap.left) + " " + std::to_string(gap.top) + " " +
                        std::to_string(gap.right - gap.left) + " " + std::to_string(rows) +
                        " renders " + (isOne ? "it" : "them"));
  }

  const int width_;
  std::vector<Area> gaps_;
  std::set<std::pair<const PartFile*, const PartFile*>> overlapping_;
  std::vector<std::string> mistakes_;
};

/// Leaves the files that are no parts out, and says so in `mistakes`.
Parts readParts(const std::vector<std::string>& paths, std::vector<std::string>& mistakes) {
  Parts parts;
  for (const std::string& path : paths) {
    try {
      parts.push_back(PartFile::read(path));
    } catch (const InputError& error) {
      mistakes.push_back(error.what());
    }
  }
  return parts;
}

/// How a part of another picture than `expected` differs.
std::string differenceText(const PartId& expected, const PartId& found) {
  const std::string wanted = sizeText(expected.width, expected.height) + " pixels";
  const std::string size = sizeText(found.width, found.height) + " pixels";
  if (size != wanted) return size + " instead of " + wanted;
  if (found.kind != expected.kind) return "its " + found.kind + " instead of its " + expected.kind;
  return "another scene, other meshes, pictures or arguments";
}

/// Most parts say which picture it is, of as many the first one; the others are named.
void checkSamePicture(const Parts& parts, std::vector<std::string>& mistakes) {
  std::map<std::string, std::size_t> counts;
  for (const PartFile& part : parts) ++counts[textOf(part.id)];
  const auto isRarer = [&](const PartFile& a, const PartFile& b) {
    return counts[textOf(a.id)] < counts[textOf(b.id)];
  };
  const PartFile& usual = *std::max_element(parts.begin(), parts.end(), isRarer);
  for (const PartFile& part : parts) {
    if (textOf(part.id) == textOf(usual.id)) continue;
    mistakes.push_back(part.path + ": expected a part of the same picture as " + usual.path +
                       ", found one of " + differenceText(usual.id, part.id));
  }
}

/// `parts` cover the picture, in the order that PartsInRow wants. A TGA needs no more than a row in
/// memory.
void write(const Parts& parts, const std::string& path) {
  const int width = parts[0].id.width, height = parts[0].id.height;
  PartsInRow inRow(parts);
  Bytes row(3 * std::size_t(width));  // BGR
  std::map<const PartFile*, std::unique_ptr<const OpenFile>> files;
  const auto rowAt = [&](int y) -> const Bytes& {
    for (const auto& [x, part] : inRow.goTo(y)) {
      // Files stay open for the rows to come, until there are too many: then all are closed.
      if (files.size() == kMostOpen && files.count(part) == 0) files.clear();
      std::unique_ptr<const OpenFile>& file = files[part];
      if (!file) file = PartFile::open(part->path);
      part->readRow(*file, y - part->y, &row[3 * std::size_t(x)]);
    }
    return row;
  };
  if (formatOf(path) == PictureFormat::tga) return writeTgaRows(width, height, rowAt, path);
  // Other formats want the image as a whole, whose rows are counted from the bottom.
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* pixel = rowAt(y).data();
    for (int x = 0; x < width; ++x, pixel += 3) {
      image.setPixel(x, height - 1 - y, Rgb8{pixel[2], pixel[1], pixel[0]});
    }
  }
  writePicture(image, path, hardwareThreads());
}

}  // namespace

int runMerge(const MergeRequest& request) {
  checkOutput(request.output);
  std::vector<std::string> mistakes;
  Parts parts = readParts(request.parts, mistakes);
  if (mistakes.empty()) checkSamePicture(parts, mistakes);
  if (mistakes.empty()) {
    std::sort(parts.begin(), parts.end(), [](const PartFile& a, const PartFile& b) {
      return std::tie(a.y, a.x, a.path) < std::tie(b.y, b.x, b.path);
    });
    mistakes = Cover(parts, parts[0].id).mistakes();
  }
  if (mistakes.empty()) {
    write(parts, request.output);
    return kDone;
  }
  const std::size_t shown = std::min(mistakes.size(), kMostComplaints);
  for (std::size_t i = 0; i < shown; ++i) complain(mistakes[i]);
  if (shown < mistakes.size()) {
    complain("and " + counted(mistakes.size() - shown, "more mistake"));
  }
  return kSceneAtFault;
}
