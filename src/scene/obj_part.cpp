// Reading OBJ statements: v and f count, all others are passed over.
// Source: Wavefront, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.
#include "scene/obj_part.h"

#include <algorithm>

#include "scene/digits.h"
#include "scene/obj_cursor.h"
#include "scene/quick_decimal.h"
#include "scene/wording.h"

namespace {

/// A corner of a face: the index, plus kRelative where it was counted backwards; it then counts
/// from the part's first vertex. One number, as a struct of two was copied by way of memory.
using Corner = std::uint64_t;
constexpr Corner kRelative = Corner(1) << 32;

/// Goes behind a line's end that stands here and is not continued; null where none does.
const char* passLineEnd(const char* p) {
  p += *p == '\r';
  return *p == '\n' ? p + 1 : nullptr;
}

/// How many bytes must be there where a plain statement begins: its letter, three times a blank and
/// a number or a corner (24 digits, two slashes), and the line's end.
constexpr int kPlainBytes = 1 + 3 * (1 + std::max(kQuickBytes, 26)) + 2;

/// Goes behind the digits of a corner, of which `corner` becomes the number, and then up to twice
/// behind a slash and digits: at most eight bytes each time.
[[gnu::always_inline]] inline const char* scanPlainCorner(const char* p, std::uint64_t& corner) {
  const digits::Run index = digits::leading(eight_bytes::load(p));
  corner = index.number;
  p += index.count;
  for (int reference = 0; reference < 2 && *p == '/'; ++reference) {
    ++p;
    p += digits::aligned(eight_bytes::load(p)).count;
  }
  return p;
}

/// The place in the statements is handed along apart from the reader, so that it can stay in a
/// register; with numbers read in line this took 0.92 of the time.
class PartReader {
 public:
  PartReader(const ObjSurroundings& around, const ObjReport& report, ObjPart& part)
      : around_(around), report_(report), part_(part) {}

  void read(ObjCursor cursor);

 private:
  void readPlainStatements(ObjCursor& cursor);
  const char* readPlainVertex(const char* p);
  const char* readPlainTriangle(const char* p);
  void readVertex(ObjCursor& cursor);
  void reportVertex(ObjCursor cursor, const char* start, int found);
  void readFace(ObjCursor& cursor);
  bool readCorner(ObjCursor& cursor, Corner& corner);
  void reportCorner(std::string_view word);
  void reportRange(std::string_view word, std::uint64_t number, bool isNegative);
  void addFace(Corner a, Corner b, Corner c, const char* start);
  void appendFace(Corner a, Corner b, Corner c);
  void noteRelative(Corner corner, std::size_t number);

  const ObjSurroundings around_;
  const ObjReport& report_;
  ObjPart& part_;
};

void PartReader::read(ObjCursor cursor) {
  // Every vertex and triangle takes two bytes at least: there will not be too many of them.
  const bool isCountSafe = std::size_t(cursor.end() - cursor.place()) < kMaxObjParts;
  for (;;) {
    if (isCountSafe) readPlainStatements(cursor);
    if (!cursor.findStatement()) return;
    if (cursor.isStatement('v')) {
      readVertex(cursor);
    } else if (cursor.isStatement('f')) {
      readFace(cursor);
    }
    cursor.skipStatement();
  }
}

/// Reads what most files consist of at a stretch, up to the first statement that is written in any
/// other way: half the instructions of reading each word for itself.
void PartReader::readPlainStatements(ObjCursor& cursor) {
  const char* p = cursor.place();
  while (cursor.end() - p >= kPlainBytes && p[1] == ' ') {
    const char* behind = nullptr;
    if (*p == 'f') behind = readPlainTriangle(p + 1);
    if (*p == 'v') behind = readPlainVertex(p + 1);
    if (!behind) break;
    p = behind;
  }
  cursor.moveTo(p);
}

/// Takes the ` x y z` of a vertex with one blank before each number, all of them QuickDecimals, and
/// nothing behind them. Returns where the next line begins; null, and nothing has changed, for any
/// other vertex.
[[gnu::always_inline]] inline const char* PartReader::readPlainVertex(const char* p) {
  float position[3];
  for (float& coordinate : position) {
    if (*p != ' ') return nullptr;
    QuickDecimal number;
    p = scanQuickly(p + 1, number);
    if (!p || !toFloat(number, coordinate)) return nullptr;
  }
  p = passLineEnd(p);
  if (!p) return nullptr;
  Vec3f& vertex = part_.vertices.emplace_back();  // filled in place: see Corner
  for (int axis = 0; axis < 3; ++axis) vertex[axis] = position[axis];
  return p;
}

/// The same for the ` a b c` of a face, the corners being a, a/b, a//c or a/b/c, counted from the
/// file's start, all numbers of at most eight digits.
[[gnu::always_inline]] inline const char* PartReader::readPlainTriangle(const char* p) {
  std::uint64_t corners[3];
  for (std::uint64_t& corner : corners) {
    if (*p != ' ') return nullptr;
    p = scanPlainCorner(p + 1, corner);
  }
  p = passLineEnd(p);
  const auto [a, b, c] = corners;
  const std::uint64_t highest = std::max({a, b, c});
  if (!p || a == 0 || b == 0 || c == 0 || highest > around_.vertices) return nullptr;
  part_.highest = std::max(part_.highest, highest);
  appendFace(a - 1, b - 1, c - 1);
  return p;
}

void PartReader::readVertex(ObjCursor& cursor) {
  const char* const start = cursor.place();
  cursor.skipName();
  float position[3] = {0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const char* stop = nullptr;
    if (cursor.findWord()) stop = scanFloat(cursor.place(), cursor.end(), position[axis]);
    if (!stop || !cursor.isWordEnd(stop)) {
      reportVertex(cursor, start, axis);
      break;
    }
    cursor.moveTo(stop);
  }
  if (part_.vertices.size() == kMaxObjParts) {
    report_(start, "more vertices than 32 bits can number");
  }
  part_.vertices.emplace_back(position[0], position[1], position[2]);
}

/// Says what is wrong with the vertex at `start`, of which `found` numbers are good.
void PartReader::reportVertex(ObjCursor cursor, const char* start, int found) {
  if (!cursor.findWord()) {
    report_(start, "expected three numbers for a vertex, found " + std::to_string(found));
    return;
  }
  const std::string_view word = cursor.wordTo(cursor.place());
  const char* const expected = isNumber(word)
                                   ? "expected a number within float range for a vertex, found "
                                   : "expected a number for a vertex, found ";
  report_(word.data(), expected + quoted(word));
}

void PartReader::readFace(ObjCursor& cursor) {
  const char* const start = cursor.place();
  cursor.skipName();
  Corner first = 0, last = 0, corner = 0;
  std::size_t count = 0;
  for (; cursor.findWord(); ++count) {
    if (!readCorner(cursor, corner)) return;
    if (count == 0) first = corner;
    if (count >= 2) addFace(first, last, corner, start);
    last = corner;
  }
  if (count >= 3) return;
  report_(start, "expected at least three corners for a face, found " + std::to_string(count));
}

void PartReader::addFace(Corner a, Corner b, Corner c, const char* start) {
  if (part_.faces.size() == kMaxObjParts) {
    report_(start, "more triangles than 32 bits can number");
  }
  if (((a | b | c) & kRelative) != 0 && around_.before > 0) {
    noteRelative(a, 0);
    noteRelative(b, 1);
    noteRelative(c, 2);
  }
  appendFace(a, b, c);
}

void PartReader::appendFace(Corner a, Corner b, Corner c) {
  MeshGeometry::Face& face = part_.faces.emplace_back();  // filled in place: see Corner
  face[0] = std::uint32_t(a);
  face[1] = std::uint32_t(b);
  face[2] = std::uint32_t(c);
}

/// Keeps that corner `number` of the next face counts from the part's first vertex.
void PartReader::noteRelative(Corner corner, std::size_t number) {
  if ((corner & kRelative) != 0) part_.relativeCorners.push_back(3 * part_.faces.size() + number);
}

/// Goes behind `digits`, adding them to `number`, which becomes the largest there is where it
/// would be larger.
const char* scanIndex(const char* p, const char* end, std::uint64_t& number) {
  const char* start = p;
  p = digits::append(p, end, number);
  if (p - start <= digits::kMost) return p;
  while (start != p && *start == '0') ++start;
  number = 0;
  digits::append(start, p, number);
  if (p - start > digits::kMost) number = std::numeric_limits<std::uint64_t>::max();
  return p;
}

/// Goes behind the `/b/c` of a corner; null where anything else stands before the word's end.
const char* skipReferences(const ObjCursor& cursor, const char* p) {
  int slashes = 0;
  for (; !cursor.isWordEnd(p); ++p) {
    slashes += *p == '/';
    const bool isPart = *p == '/' || *p == '-' || *p == '+' || digits::isDigit(*p);
    if (!isPart || slashes > 2) return nullptr;
  }
  return p;
}

/// Takes a, a/b, a//c or a/b/c. Only a matters; of b and c it is checked that they are numbers.
bool PartReader::readCorner(ObjCursor& cursor, Corner& corner) {
  const char* const start = cursor.place();
  const char* const first = start + (*start == '-' || *start == '+');
  std::uint64_t number = 0;
  const char* stop = scanIndex(first, cursor.end(), number);
  if (!cursor.isWordEnd(stop)) stop = *stop == '/' ? skipReferences(cursor, stop) : nullptr;
  if (!stop || stop == first || *first == '/') {
    reportCorner(cursor.wordTo(start));
    return false;
  }
  const std::size_t here = part_.vertices.size();
  const bool isNegative = *start == '-';
  if (number - 1 >= (isNegative ? here + around_.before : around_.vertices)) {
    reportRange({start, std::size_t(stop - start)}, number, isNegative);
    return false;
  }
  if (isNegative) {
    corner = std::uint32_t(here - number) | kRelative;
    if (number > here) part_.reachBack = std::max(part_.reachBack, number - here);
  } else {
    corner = number - 1;
    part_.highest = std::max(part_.highest, number);
  }
  cursor.moveTo(stop);
  return true;
}

void PartReader::reportCorner(std::string_view word) {
  report_(word.data(), "expected a vertex index for a face, found " + quoted(word));
}

void PartReader::reportRange(std::string_view word, std::uint64_t number, bool isNegative) {
  const std::string found = ", found " + quoted(word);
  if (number == 0) {
    report_(word.data(), "face index 0: expected indices that count from 1" + found);
    return;
  }
  const std::size_t available =
      isNegative ? part_.vertices.size() + around_.before : around_.vertices;
  report_(word.data(), "face index out of range: there are " + std::to_string(available) +
                           (isNegative ? " vertices before it" : " vertices") + found);
}

}  // namespace

void readObjPart(std::string_view statements, const ObjSurroundings& around,
                 const ObjReport& report, ObjPart& part) {
  PartReader(around, report, part).read(ObjCursor(statements));
}

std::size_t countObjVertices(std::string_view statements) {
  std::size_t count = 0;
  for (ObjCursor cursor(statements); cursor.findStatement(); cursor.skipStatement()) {
    count += cursor.isStatement('v');
  }
  return count;
}
