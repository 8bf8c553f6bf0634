// Reading OBJ statements: v and f count, all others are passed over.
// Source: Wavefront, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.
#include "scene/obj_part.h"

#include <algorithm>

#include "scene/digits.h"
#include "scene/obj_cursor.h"
#include "scene/wording.h"

namespace {

/// A vertex index as it is written.
struct Index {
  std::uint64_t number = 0;
  bool isNegative = false;
};

/// Up to three indices of a face, and which of them are counted backwards (bit i: corner i).
struct Corners {
  MeshGeometry::Face indices{};
  unsigned relative = 0;
};

class PartReader {
 public:
  PartReader(std::string_view statements, const ObjSurroundings& around, const ObjReport& report,
             ObjPart& part)
      : cursor_(statements), around_(around), report_(report), part_(part) {}

  void read();

 private:
  void readVertex();
  void reportVertex(const char* start, int found);
  void readFace();
  bool readCorner(std::uint32_t& index, bool& isNegative);
  bool scanIndex(const char*& p, Index& index) const;
  bool skipReferences(const char*& p) const;
  bool isInRange(const Index& index, const char* p);
  void addFace(const Corners& corners, const char* start);

  ObjCursor cursor_;
  const ObjSurroundings& around_;
  const ObjReport& report_;
  ObjPart& part_;
};

void PartReader::read() {
  for (; cursor_.findStatement(); cursor_.skipStatement()) {
    if (cursor_.isStatement('v')) {
      readVertex();
    } else if (cursor_.isStatement('f')) {
      readFace();
    }
  }
}

void PartReader::readVertex() {
  const char* const start = cursor_.place();
  cursor_.skipName();
  float position[3] = {0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const char* stop = nullptr;
    if (cursor_.findWord()) stop = scanFloat(cursor_.place(), cursor_.end(), position[axis]);
    if (!stop || !cursor_.isWordEnd(stop)) {
      reportVertex(start, axis);
      break;
    }
    cursor_.moveTo(stop);
  }
  if (part_.vertices.size() == kMaxObjParts) {
    report_(start, "more vertices than 32 bits can number");
  }
  part_.vertices.emplace_back(position[0], position[1], position[2]);
}

/// Says what is wrong with the vertex at `start`, of which `found` numbers are good.
void PartReader::reportVertex(const char* start, int found) {
  if (!cursor_.findWord()) {
    report_(start, "expected three numbers for a vertex, found " + std::to_string(found));
    return;
  }
  const std::string_view word = cursor_.wordTo(cursor_.place());
  const char* const expected = isNumber(word)
                                   ? "expected a number within float range for a vertex, found "
                                   : "expected a number for a vertex, found ";
  report_(word.data(), expected + quoted(word));
}

void PartReader::readFace() {
  const char* const start = cursor_.place();
  cursor_.skipName();
  Corners corners;
  std::size_t count = 0;
  for (; cursor_.findWord(); ++count) {
    std::uint32_t index;
    bool isRelative;
    if (!readCorner(index, isRelative)) return;
    // The first corner stays, the last becomes the second.
    if (count == 0) {
      corners = {{index, 0, index}, isRelative ? 5u : 0u};
      continue;
    }
    corners.indices = {corners.indices[0], corners.indices[2], index};
    corners.relative = (corners.relative & 1) | (corners.relative >> 1 & 2) | (isRelative ? 4 : 0);
    if (count >= 2) addFace(corners, start);
  }
  if (count >= 3) return;
  report_(start, "expected at least three corners for a face, found " + std::to_string(count));
}

void PartReader::addFace(const Corners& corners, const char* start) {
  if (part_.faces.size() == kMaxObjParts) {
    report_(start, "more triangles than 32 bits can number");
  }
  if (corners.relative != 0 && around_.before > 0) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (corners.relative >> i & 1) part_.relativeCorners.push_back(3 * part_.faces.size() + i);
    }
  }
  part_.faces.push_back(corners.indices);
}

/// Takes a, a/b, a//c or a/b/c. Only a matters; of b and c it is checked that they are numbers.
bool PartReader::readCorner(std::uint32_t& index, bool& isNegative) {
  const char* p = cursor_.place();
  Index written;
  if (!scanIndex(p, written) || !skipReferences(p)) {
    const std::string_view word = cursor_.wordTo(p);
    report_(word.data(), "expected a vertex index for a face, found " + quoted(word));
    return false;
  }
  if (!isInRange(written, p)) return false;
  cursor_.moveTo(p);
  isNegative = written.isNegative;
  index = std::uint32_t(isNegative ? part_.vertices.size() - written.number : written.number - 1);
  return true;
}

/// Reads `[+-] digits` and goes behind them; false where there are no digits.
bool PartReader::scanIndex(const char*& p, Index& index) const {
  index.isNegative = *p == '-';
  if (*p == '-' || *p == '+') ++p;
  const char* start = p;
  p = digits::append(p, cursor_.end(), index.number);
  if (p - start > digits::kMost) {
    while (p - start > 1 && *start == '0') ++start;
    index.number = 0;
    digits::append(start, p, index.number);
    if (p - start > digits::kMost) index.number = std::numeric_limits<std::uint64_t>::max();
  }
  return p != start;
}

/// Goes behind the `/b/c` of a corner, if there is one, to the word's end; false where anything
/// else stands there.
bool PartReader::skipReferences(const char*& p) const {
  if (cursor_.isWordEnd(p)) return true;
  if (*p != '/') return false;
  for (int slashes = 0; !cursor_.isWordEnd(p); ++p) {
    slashes += *p == '/';
    if (slashes > 2 || (*p != '/' && *p != '-' && *p != '+' && !digits::isDigit(*p))) return false;
  }
  return true;
}

/// Judges the index of the word here, which ends at `p`, and notes how far it reaches.
bool PartReader::isInRange(const Index& index, const char* p) {
  const std::size_t here = part_.vertices.size();
  const std::size_t available = index.isNegative ? here + around_.before : around_.vertices;
  if (index.number >= 1 && index.number <= available) {
    if (!index.isNegative) {
      part_.highest = std::max(part_.highest, index.number);
    } else if (index.number > here) {
      part_.reachBack = std::max(part_.reachBack, index.number - here);
    }
    return true;
  }
  const std::string found = ", found " + quoted(cursor_.wordTo(p));
  report_(cursor_.place(),
          index.number == 0 ? "face index 0: expected indices that count from 1" + found
                            : "face index out of range: there are " + std::to_string(available) +
                                  (index.isNegative ? " vertices before it" : " vertices") + found);
  return false;
}

}  // namespace

void readObjPart(std::string_view statements, const ObjSurroundings& around,
                 const ObjReport& report, ObjPart& part) {
  PartReader(statements, around, report, part).read();
}

std::size_t countObjVertices(std::string_view statements) {
  std::size_t count = 0;
  for (ObjCursor cursor(statements); cursor.findStatement(); cursor.skipStatement()) {
    count += cursor.isStatement('v');
  }
  return count;
}
