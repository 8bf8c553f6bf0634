// The run of `raytracer -merge`: every part is looked at before a pixel is read, and each mistake
// named; then the picture is put together row by row.
//
// The header of a part is that of our TGAs (see image/tga.cpp), but that byte 0 is the length of
// the image ID, which follows its 18 bytes, and bytes 8 to 11 are X and Y. Whatever has another
// header, ID or length is no part, or a damaged one: each check has its own message, from "no such
// thing" to "cut off", so that a user with hundreds of files sees at once what happened to one.
//
// Then it is checked whether the parts cover the picture, and their pixels are read. Both go down
// the picture with the same list, PartsInRow: the parts that hold pixels of the row at hand. From
// left to right each part must begin where the one before ended. Where it begins later there is a
// gap, where it begins earlier two parts overlap.
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "cli/part_file.h"
#include "cli/program.h"
#include "cli/runs.h"
#include "image/bytes.h"
#include "image/output_file.h"
#include "scene/input_error.h"
#include "scene/wording.h"
#include "system/files.h"
#include "system/worker_threads.h"

namespace {

constexpr std::size_t kMostComplaints = 20;
constexpr std::size_t kMostOpen = 256;  // files at a time
constexpr std::size_t kHeader = 18, kMostId = 255;

/// Pixels left <= x < right of rows top <= y < bottom, counted from 0 at the top and left.
struct Area {
  int left, top, right, bottom;
};

struct Part : Area {  // in the whole picture
  std::string path;
  PartId id{};
  std::size_t headSize = 0;  // bytes before the pixels

  int width() const { return right - left; }
  /// Where row `y` of the picture begins in the file.
  std::int64_t rowStart(int y) const {
    return std::int64_t(headSize) + std::int64_t(3) * width() * (y - top);
  }
};
using Parts = std::vector<Part>;

[[noreturn]] void failPart(const std::string& path, const std::string& message) {
  throw InputError(path, 0, message);
}

[[noreturn]] void failRead(const std::string& path) {
  failPart(path, std::string("cannot be read: ") + std::strerror(errno));
}

void checkPart(bool isRight, const std::string& path, const std::string& found) {
  if (isRight) return;
  failPart(path, "expected a TGA that -region or -tile has written, found " + found);
}

/// Fewer bytes than `size` only at the end of the file. Throws InputError.
std::size_t readAt(const Part& part, const OpenFile& file, std::int64_t offset,
                   std::uint8_t* target, std::size_t size) {
  const ssize_t count = file.isOpen() ? file.readAt(off_t(offset), target, size) : -1;
  if (count < 0) failRead(part.path);
  return std::size_t(count);
}

/// Apart from sizes and places, the header that a part has.
bool isHeader(const std::uint8_t* header) {
  static constexpr std::uint8_t kStart[] = {0, 2, 0, 0, 0, 0, 0};
  return std::equal(std::begin(kStart), std::end(kStart), header + 1) && header[16] == 24 &&
         header[17] == 0x20;
}

/// The words are read back and written anew: so every other spelling (blanks, leading zeros, a
/// sign) is refused without a rule for each. True where `text` is what textOf gives for some `id`,
/// which is then set.
bool readId(const std::string& text, PartId& id) {
  std::istringstream words(text);
  std::string word;
  words >> word >> word >> word >> id.kind >> id.width >> id.height >> id.fingerprint;
  const auto isSide = [](int side) { return side >= 1 && side <= kMaxImageSide; };
  return !words.fail() && textOf(id) == text && isSide(id.width) && isSide(id.height);
}

/// Reads all but the pixels, and checks that these are all there. Throws InputError where the file
/// cannot be read, is no part, reaches out of its picture, or does not end with its last pixel.
Part readPart(const std::string& path) {
  const OpenFile file(path);
  if (!file.isOpen()) failRead(path);
  Part part = {{}, path};
  std::uint8_t header[kHeader + kMostId] = {};
  const auto size = std::int64_t(file.regularSize());
  checkPart(size >= 0, path, "no plain file");
  const std::size_t found = readAt(part, file, 0, header, sizeof header);
  checkPart(found >= kHeader, path, joined(size, " bytes"));
  checkPart(isHeader(header), path, "another kind of file");
  checkPart(header[0] > 0, path, "a TGA without an image ID, which is no part");
  part.headSize = kHeader + header[0];
  checkPart(found >= part.headSize, path, joined(size, " bytes"));
  const std::string id(header + kHeader, header + part.headSize);
  checkPart(readId(id, part.id), path, "a TGA with another image ID");
  const auto field = [&header](int at) { return int(littleEndian16(header + at)); };
  static_cast<Area&>(part) = {field(8), field(10), field(8) + field(12), field(10) + field(14)};
  if (part.width() == 0 || part.bottom == part.top || part.right > part.id.width ||
      part.bottom > part.id.height) {
    failPart(path, "damaged: its place is not in the picture that it is a part of");
  }
  const std::int64_t expected = part.rowStart(part.bottom);
  if (size == expected) return part;
  failPart(path, joined(size < expected ? "cut off: " : "", "expected ", expected, " bytes, found ",
                        size, " bytes"));
}

/// The parts that hold pixels of a row, from left to right.
class PartsInRow {
 public:
  using Row = std::multimap<int, const Part*>;  // by their left ends

  /// `parts` are in the order of their tops, those of the same top of their left ends. Not owned.
  explicit PartsInRow(const Parts& parts) : next_(parts.begin()), end_(parts.end()) {}

  /// To be called for each row from the top down.
  const Row& goTo(int y) {
    for (auto part = row_.begin(); part != row_.end();) {
      part = part->second->bottom <= y ? row_.erase(part) : std::next(part);
    }
    for (; next_ != end_ && next_->top == y; ++next_) row_.emplace(next_->left, &*next_);
    return row_;
  }

 private:
  Parts::const_iterator next_;  // the first part that no row has reached
  const Parts::const_iterator end_;
  Row row_;
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

std::string overlapText(const Part& a, const Part& b, int width) {
  const Area both = {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
                     std::min(a.bottom, b.bottom)};
  return a.path + " and " + b.path + ": expected parts that do not overlap, found " +
         areaText(both, width) + " in both";
}

/// With the argument that would render it: -region takes X Y W H.
std::string gapText(const Area& gap, int width) {
  const int rows = gap.bottom - gap.top;
  const bool isOne = rows == 1 && gap.left == 0 && gap.right == width;
  return joined("no part holds ", areaText(gap, width), "; -region ", gap.left, ' ', gap.top, ' ',
                gap.right - gap.left, ' ', rows, " renders ", isOne ? "it" : "them");
}

/// Joined to a gap of the same pixels in the row above. At most kMostComplaints are kept.
void addGap(const Area& area, std::vector<Area>& gaps) {
  for (Area& gap : gaps) {
    if (gap.bottom != area.top || gap.left != area.left || gap.right != area.right) continue;
    gap.bottom = area.bottom;
    return;
  }
  if (gaps.size() < kMostComplaints) gaps.push_back(area);
}

/// Whether parts make up a whole picture: which files overlap and where, which pixels no part
/// holds. At most kMostComplaints of each are found; none where each pixel is in one part. Each two
/// parts are told of once, although they may meet in many rows.
std::vector<std::string> coverMistakes(const Parts& parts, const PartId& whole) {
  std::vector<std::string> mistakes;
  std::vector<Area> gaps;
  std::set<std::pair<const Part*, const Part*>> overlapping;
  PartsInRow inRow(parts);
  for (int y = 0; y < whole.height; ++y) {
    // From left to right, `end` being the first pixel that no part so far holds. A part may lie
    // inside an earlier one, which then still reaches furthest.
    int end = 0;
    const Part* reaching = nullptr;  // the part that ends there
    for (const auto& [x, part] : inRow.goTo(y)) {
      if (x > end) addGap({end, y, x, y + 1}, gaps);
      if (x < end && overlapping.size() < kMostComplaints &&
          overlapping.insert({reaching, part}).second) {
        mistakes.push_back(overlapText(*reaching, *part, whole.width));
      }
      if (part->right <= end) continue;
      end = part->right;
      reaching = part;
    }
    if (end < whole.width) addGap({end, y, whole.width, y + 1}, gaps);
  }
  for (const Area& gap : gaps) mistakes.push_back(gapText(gap, whole.width));
  return mistakes;
}

/// Leaves the files that are no parts out, and says so in `mistakes`.
Parts readParts(const std::vector<std::string>& paths, std::vector<std::string>& mistakes) {
  Parts parts;
  for (const std::string& path : paths) {
    try {
      parts.push_back(readPart(path));
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
  for (const Part& part : parts) ++counts[textOf(part.id)];
  const auto isRarer = [&](const Part& a, const Part& b) {
    return counts[textOf(a.id)] < counts[textOf(b.id)];
  };
  const Part& usual = *std::max_element(parts.begin(), parts.end(), isRarer);
  for (const Part& part : parts) {
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
  std::map<const Part*, OpenFile> files;
  const auto rowAt = [&](int y) -> const Bytes& {
    for (const auto& [x, part] : inRow.goTo(y)) {
      // Files stay open for the rows to come, until there are too many: then all are closed.
      if (files.size() == kMostOpen && files.count(part) == 0) files.clear();
      const OpenFile& file = files.try_emplace(part, part->path).first->second;
      const std::size_t size = 3 * std::size_t(part->width());
      if (readAt(*part, file, part->rowStart(y), &row[3 * std::size_t(x)], size) < size) {
        failPart(part->path, "has become shorter");
      }
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
  for (const std::string& part : request.parts) {
    checkDifferent("-merge: OUT and PART", request.output, part);
  }
  checkOutput(request.output);
  std::vector<std::string> mistakes;
  Parts parts = readParts(request.parts, mistakes);
  if (mistakes.empty()) checkSamePicture(parts, mistakes);
  if (mistakes.empty()) {
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
      return std::tie(a.top, a.left, a.path) < std::tie(b.top, b.left, b.path);
    });
    mistakes = coverMistakes(parts, parts[0].id);
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
