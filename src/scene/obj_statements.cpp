// Reading OBJ statements: v and f count, and perhaps vt and vn (obj_details.cpp); all others are
// passed over.
// Source: Wavefront, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.
//
// A statement ends with its line, unless that ends in a backslash; a comment is never continued.
// Most statements are `v x y z` and `f a b c`, and most of the time goes by in their digits: those
// are read eight bytes at a time where so many are there (decimal.h), which takes half as long.
#include <algorithm>

#include "scene/decimal.h"
#include "scene/number_reader.h"
#include "scene/obj_details.h"
#include "scene/wording.h"

namespace {

/// A corner of a face: the index, plus kRelative where it was counted backwards; it then counts
/// from the chunk's first vertex. One number, as a struct of two was copied by way of memory.
using Corner = std::uint64_t;
constexpr Corner kRelative = Corner(1) << 32;

class ChunkReader {
 public:
  ChunkReader(std::string_view statements, const ObjSurroundings& around, const ObjReport& report,
              ObjChunk& chunk, const ObjDetails& details)
      : start_(statements.data()),
        words_(start_ + statements.size()),
        around_(around),
        report_(report),
        chunk_(chunk),
        details_(statements, details, report, chunk.shading) {}

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

  const char* const start_;
  const ObjWords words_;
  const ObjSurroundings around_;
  const ObjReport& report_;
  ObjChunk& chunk_;
  ObjDetailReader details_;
};

void ChunkReader::read() {
  for (const char* p = start_;;) {
    p = words_.findStatement(p);
    if (p == words_.end()) return;
    if (words_.isStatement('v', p)) {
      p = readVertex(p);
    } else if (words_.isStatement('f', p)) {
      p = readFace(p);
    } else if (details_.areWanted()) {
      details_.readStatement(p);
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
        reportObjNumbers(words_, report_, kObjVertex, start, p, axis);
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
  if (details_.areWanted()) details_.readFace(start);
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

/// Takes a, a/b, a//c or a/b/c. Only a matters; of b and c it is checked that they are numbers (see
/// also ObjDetailReader). Returns null after a mistake.
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
    reportObjRange(report_, kObjVertex, {start, std::size_t(stop - start)}, number,
                   isNegative ? here + around_.before : around_.vertices, isNegative);
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
                  const ObjReport& report, ObjChunk& chunk, const ObjDetails& details) {
  ChunkReader(statements, around, report, chunk, details).read();
}

std::size_t countObjStatements(std::string_view statements, std::string_view name) {
  const ObjWords words(statements.data() + statements.size());
  std::size_t count = 0;
  const char* p = words.findStatement(statements.data());
  while (p != words.end()) {
    count += words.isStatement(name, p);
    p = words.findStatement(words.skipStatement(p));
  }
  return count;
}

void readObjPlaces(std::string_view statements, std::vector<Vec3d>& places) {
  const ObjWords words(statements.data() + statements.size());
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
