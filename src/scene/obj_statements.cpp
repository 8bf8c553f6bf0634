// Reading OBJ statements: v and f count, all others are passed over.
// Source: Wavefront, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.
//
// A statement ends with its line, unless that ends in a backslash; a comment is never continued.
// Most statements are `v x y z` and `f a b c`, and most of the time goes by in their digits: those
// are read eight bytes at a time where so many are there (decimal.h), which takes half as long.
//
// The place in the statements is handed along apart from the reader, so that it can stay in a
// register; with numbers read in line this took 0.92 of the time.
#include <algorithm>
#include <cstring>

#include "scene/decimal.h"
#include "scene/number_reader.h"
#include "scene/obj_reader.h"
#include "scene/wording.h"

namespace {

/// A corner of a face: the index, plus kRelative where it was counted backwards; it then counts
/// from the chunk's first vertex. One number, as a struct of two was copied by way of memory.
using Corner = std::uint64_t;
constexpr Corner kRelative = Corner(1) << 32;

bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }

/// Statements and the words in them, up to the end of a text.
class Words {
 public:
  explicit Words(const char* end) : end_(end) {}

  const char* end() const { return end_; }

  /// The first letter of the next statement at or behind `p`; the end where there is none.
  const char* findStatement(const char* p) const {
    while (p != end_ && (isBlank(*p) || *p == '\n')) ++p;
    return p;
  }
  /// True when the statement at `p` begins with the one letter `name`.
  bool isStatement(char name, const char* p) const { return *p == name && isWordEnd(p + 1); }

  /// Where the line behind the statement begins; `p` is a place in the statement.
  const char* skipStatement(const char* p) const {
    if (p != end_ && *p == '\n') return p + 1;
    const bool isComment = p != end_ && *p == '#';
    while (p != end_) {
      const void* const found = std::memchr(p, '\n', std::size_t(end_ - p));
      const char* const newline = found ? static_cast<const char*>(found) : end_;
      const bool goesOn = !isComment && isContinuedLine(p, newline);
      p = newline == end_ ? end_ : newline + 1;
      if (!goesOn) break;
    }
    return p;
  }

  /// Where the next word of the statement begins; where the statement ends if it has no more.
  const char* findWord(const char* p) const {
    while (p != end_) {
      const std::size_t length = isBlank(*p) ? 1 : continuation(p);
      if (length == 0) break;
      p += length;
    }
    return p;
  }
  /// True where findWord has found no word.
  bool isStatementEnd(const char* p) const { return p == end_ || *p == '\n' || *p == '#'; }
  bool isWordEnd(const char* p) const {
    return p == end_ || *p == '\n' || isBlank(*p) || continuation(p) > 0;
  }
  /// The word that begins at `start`.
  std::string_view wordAt(const char* start) const {
    const char* p = start;
    while (!isWordEnd(p)) ++p;
    return {start, std::size_t(p - start)};
  }

 private:
  /// Length of a backslash with the line end behind it, 0 for anything else.
  std::size_t continuation(const char* p) const {
    if (*p != '\\') return 0;
    const char* next = p + 1;
    if (next != end_ && *next == '\r') ++next;
    if (next == end_) return std::size_t(next - p);
    return *next == '\n' ? std::size_t(next + 1 - p) : 0;
  }

  const char* end_;
};

class ChunkReader {
 public:
  ChunkReader(std::string_view statements, const ObjSurroundings& around, const ObjReport& report,
              ObjChunk& chunk)
      : start_(statements.data()),
        words_(start_ + statements.size()),
        around_(around),
        report_(report),
        chunk_(chunk) {}

  void read();

 private:
  // Each takes the place where it begins and returns the one behind what it has read.
  const char* readVertex(const char* start);
  const char* readFace(const char* start);
  const char* readPlainCorner(const char* p, Corner& corner);
  const char* readCorner(const char* start, Corner& corner);
  const char* skipReferences(const char* p) const;

  void addFace(Corner a, Corner b, Corner c, const char* start);
  void noteRelative(Corner corner, std::size_t number);
  void reportVertex(const char* start, const char* at, int found);
  void reportRange(std::string_view word, std::uint64_t number, bool isNegative);

  const char* const start_;
  const Words words_;
  const ObjSurroundings around_;
  const ObjReport& report_;
  ObjChunk& chunk_;
};

void ChunkReader::read() {
  for (const char* p = start_;;) {
    p = words_.findStatement(p);
    if (p == words_.end()) return;
    if (words_.isStatement('v', p)) {
      p = readVertex(p);
    } else if (words_.isStatement('f', p)) {
      p = readFace(p);
    }
    p = words_.skipStatement(p);
  }
}

/// Three numbers; what stands behind them (a weight, a colour) does not count.
const char* ChunkReader::readVertex(const char* start) {
  const char* p = start + 1;
  float position[3] = {0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const char* stop = decimal::scanBehindBlank(p, words_.end(), position[axis]);
    if (!stop) {
      p = words_.findWord(p);
      if (!words_.isStatementEnd(p)) stop = scanFloat(p, words_.end(), position[axis]);
      if (!stop || !words_.isWordEnd(stop)) {
        reportVertex(start, p, axis);
        break;
      }
    }
    p = stop;
  }
  if (chunk_.vertices.size() == kMostObjElements) {
    report_(start, "more vertices than 32 bits can number");
  }
  chunk_.vertices.emplace_back(position[0], position[1], position[2]);
  return p;
}

/// Says what is wrong at `at` with the vertex at `start`, of which `found` numbers are good.
void ChunkReader::reportVertex(const char* start, const char* at, int found) {
  if (words_.isStatementEnd(at)) {
    report_(start, "expected three numbers for a vertex, found " + std::to_string(found));
    return;
  }
  const std::string_view word = words_.wordAt(at);
  const char* const expected = isNumber(word)
                                   ? "expected a number within float range for a vertex, found "
                                   : "expected a number for a vertex, found ";
  report_(at, expected + quoted(word));
}

/// A face of n corners becomes the n - 2 triangles of a fan around its first corner. One of less
/// than three (what others write as points and lines) is none.
const char* ChunkReader::readFace(const char* start) {
  const std::size_t facesBefore = chunk_.faces.size();
  Corner first = 0, last = 0, corner = 0;
  std::size_t count = 0;
  const char* p = start + 1;
  for (;; ++count) {
    const char* stop = readPlainCorner(p, corner);
    if (!stop) {
      p = words_.findWord(p);
      if (words_.isStatementEnd(p)) break;
      stop = readCorner(p, corner);
      if (!stop) return p;
    }
    if (count == 0) first = corner;
    if (count >= 2) addFace(first, last, corner, start);
    last = corner;
    p = stop;
  }
  const auto at = std::size_t(start - start_);
  if (count == 0) report_(start, "expected at least three corners for a face, found 0");
  if (count < 3) chunk_.slivers.push_back(at);
  if (count > 3) {
    chunk_.polygons.push_back({at, std::uint32_t(facesBefore), std::uint32_t(count - 2)});
  }
  return p;
}

/// Takes a good index of at most seven digits, behind one blank and before white space. Null, and
/// nothing has changed, where a corner is written in any other way.
[[gnu::always_inline]] inline const char* ChunkReader::readPlainCorner(const char* p,
                                                                       Corner& corner) {
  if (words_.end() - p <= 8 || *p != ' ') return nullptr;
  const decimal::Digits index = decimal::leadingDigits(p + 1);
  const char* const stop = p + 1 + index.count;
  if (index.count == 8 || !(*stop == ' ' || *stop == '\n')) return nullptr;
  if (index.number - 1 >= around_.vertices) return nullptr;
  chunk_.highest = std::max(chunk_.highest, index.number);
  corner = index.number - 1;
  return stop;
}

/// Takes a, a/b, a//c or a/b/c. Only a matters; of b and c it is checked that they are numbers.
/// Returns null after a mistake.
const char* ChunkReader::readCorner(const char* start, Corner& corner) {
  const char* const digits = start + (*start == '-' || *start == '+');
  constexpr std::uint64_t kBeyondAll = std::uint64_t(1) << 40;
  std::uint64_t number = 0;
  const char* stop = digits;
  for (; stop != words_.end() && decimal::isDigit(*stop); ++stop) {
    if (number < kBeyondAll) number = number * 10 + std::uint64_t(*stop - '0');
  }
  const bool hasDigits = stop != digits;
  if (!words_.isWordEnd(stop)) stop = *stop == '/' ? skipReferences(stop) : nullptr;
  if (!stop || !hasDigits) {
    report_(start, "expected a vertex index for a face, found " + quoted(words_.wordAt(start)));
    return nullptr;
  }
  const std::size_t here = chunk_.vertices.size();
  const bool isNegative = *start == '-';
  if (number - 1 >= (isNegative ? here + around_.before : around_.vertices)) {
    reportRange({start, std::size_t(stop - start)}, number, isNegative);
    return nullptr;
  }
  if (isNegative) {
    corner = std::uint32_t(here - number) | kRelative;
    if (number > here) chunk_.reachBack = std::max(chunk_.reachBack, number - here);
  } else {
    corner = number - 1;
    chunk_.highest = std::max(chunk_.highest, number);
  }
  return stop;
}

/// Goes behind the `/b/c` of a corner; null where anything else stands before the word's end.
const char* ChunkReader::skipReferences(const char* p) const {
  int slashes = 0;
  for (; !words_.isWordEnd(p); ++p) {
    slashes += *p == '/';
    const bool isAllowed = *p == '/' || *p == '-' || *p == '+' || decimal::isDigit(*p);
    if (!isAllowed || slashes > 2) return nullptr;
  }
  return p;
}

void ChunkReader::reportRange(std::string_view word, std::uint64_t number, bool isNegative) {
  const std::string found = ", found " + quoted(word);
  if (number == 0) {
    report_(word.data(), "face index 0: expected indices that count from 1" + found);
    return;
  }
  const std::size_t available =
      isNegative ? chunk_.vertices.size() + around_.before : around_.vertices;
  report_(word.data(),
          std::string("face index out of range: there ") + (available == 1 ? "is " : "are ") +
              counted(available, "vertex", "vertices") + (isNegative ? " before it" : "") + found);
}

void ChunkReader::addFace(Corner a, Corner b, Corner c, const char* start) {
  if (chunk_.faces.size() == kMostObjElements) {
    report_(start, "more triangles than 32 bits can number");
  }
  if (((a | b | c) & kRelative) != 0 && around_.before > 0) {
    noteRelative(a, 0);
    noteRelative(b, 1);
    noteRelative(c, 2);
  }
  MeshGeometry::Face& face = chunk_.faces.emplace_back();  // filled in place: see Corner
  face[0] = std::uint32_t(a);
  face[1] = std::uint32_t(b);
  face[2] = std::uint32_t(c);
}

/// Keeps that corner `number` of the next face counts from the chunk's first vertex.
void ChunkReader::noteRelative(Corner corner, std::size_t number) {
  if ((corner & kRelative) != 0) {
    chunk_.relativeCorners.push_back(3 * chunk_.faces.size() + number);
  }
}

}  // namespace

void readObjChunk(std::string_view statements, const ObjSurroundings& around,
                  const ObjReport& report, ObjChunk& chunk) {
  ChunkReader(statements, around, report, chunk).read();
}

std::size_t countObjVertices(std::string_view statements) {
  const Words words(statements.data() + statements.size());
  std::size_t count = 0;
  const char* p = words.findStatement(statements.data());
  while (p != words.end()) {
    count += words.isStatement('v', p);
    p = words.findStatement(words.skipStatement(p));
  }
  return count;
}

void readObjPlaces(std::string_view statements, std::vector<Vec3d>& places) {
  const Words words(statements.data() + statements.size());
  const char* p = words.findStatement(statements.data());
  for (; p != words.end(); p = words.findStatement(words.skipStatement(p))) {
    if (!words.isStatement('v', p)) continue;
    Vec3d& place = places.emplace_back();
    ++p;
    for (int axis = 0; axis < 3; ++axis) {
      const char* const stop = scanDouble(words.findWord(p), words.end(), place[axis]);
      if (stop) p = stop;
    }
  }
}

bool isContinuedLine(const char* start, const char* newline) {
  if (newline != start && newline[-1] == '\r') --newline;
  return newline != start && newline[-1] == '\\';
}
