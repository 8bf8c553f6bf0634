// Reading OBJ meshes in two passes over the bytes: the first counts statements, so that the
// second allocates once and can judge every index where it stands.
// Source: Wavefront, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.
#include "scene/obj_reader.h"

#include <cstring>
#include <limits>

#include "scene/number_reader.h"
#include "scene/wording.h"

namespace {

/// Vertices and faces are numbered in 32 bits.
constexpr std::size_t kMaxParts = std::numeric_limits<std::uint32_t>::max();

bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }

/// Walks over statements and the words in them.
class ObjCursor {
 public:
  explicit ObjCursor(std::string_view bytes)
      : place_(bytes.data()), end_(bytes.data() + bytes.size()) {
    if (bytes.substr(0, 3) == "\xEF\xBB\xBF") place_ += 3;
  }

  const char* place() const { return place_; }

  /// Goes to the next statement's first letter; false at the end.
  bool findStatement() {
    while (place_ != end_ && (isBlank(*place_) || *place_ == '\n')) ++place_;
    return place_ != end_;
  }
  /// True when the statement here begins with the one letter `name`.
  bool isStatement(char name) const {
    if (*place_ != name) return false;
    const char* const next = place_ + 1;
    return next == end_ || isBlank(*next) || *next == '\n' || continuation(next) > 0;
  }
  void skipName() { ++place_; }

  /// Goes behind the statement's last line. A comment is never continued.
  void skipStatement() {
    const bool isComment = place_ != end_ && *place_ == '#';
    while (place_ != end_) {
      const char* const start = place_;
      const void* const found = std::memchr(start, '\n', std::size_t(end_ - start));
      if (!found) {
        place_ = end_;
        return;
      }
      const char* const newline = static_cast<const char*>(found);
      place_ = newline + 1;
      if (isComment || !isContinued(start, newline)) return;
    }
  }

  /// The statement's next word, empty where it has no more.
  std::string_view nextWord() {
    skipBlanks();
    const char* const start = place_;
    if (place_ == end_ || *place_ == '#') return {start, 0};
    while (place_ != end_ && !isBlank(*place_) && *place_ != '\n' && continuation(place_) == 0) {
      ++place_;
    }
    return {start, std::size_t(place_ - start)};
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
  static bool isContinued(const char* start, const char* newline) {
    if (newline != start && newline[-1] == '\r') --newline;
    return newline != start && newline[-1] == '\\';
  }
  void skipBlanks() {
    while (place_ != end_) {
      const std::size_t length = isBlank(*place_) ? 1 : continuation(place_);
      if (length == 0) return;
      place_ += length;
    }
  }

  const char* place_;
  const char* end_;
};

class ObjReader {
 public:
  ObjReader(const SourceText& text, MistakeLog& log, std::size_t place)
      : text_(text), log_(log), scenePlace_(place), cursor_(text.bytes()) {}

  MeshGeometry read();

 private:
  void countStatements();
  void readVertex();
  void readFace();
  bool readCorner(std::string_view word, std::uint32_t& index);
  bool toIndex(std::string_view word, bool isNegative, std::size_t number, std::uint32_t& index);
  void report(const char* at, const std::string& message);

  const SourceText& text_;
  MistakeLog& log_;
  std::size_t scenePlace_;
  ObjCursor cursor_;
  std::size_t vertexCount_ = 0;
  std::vector<Vec3f> vertices_;
  std::vector<MeshGeometry::Face> faces_;
};

MeshGeometry ObjReader::read() {
  const std::size_t mistakesBefore = log_.count();
  countStatements();
  while (cursor_.findStatement()) {
    if (cursor_.isStatement('v')) {
      readVertex();
    } else if (cursor_.isStatement('f')) {
      readFace();
    }
    cursor_.skipStatement();
  }
  if (log_.count() > mistakesBefore) return {};
  return MeshGeometry(std::move(vertices_), std::move(faces_));
}

void ObjReader::countStatements() {
  std::size_t faceCount = 0;
  for (ObjCursor cursor = cursor_; cursor.findStatement(); cursor.skipStatement()) {
    vertexCount_ += cursor.isStatement('v');
    faceCount += cursor.isStatement('f');
  }
  vertices_.reserve(vertexCount_);
  faces_.reserve(faceCount);
}

void ObjReader::readVertex() {
  const char* const start = cursor_.place();
  cursor_.skipName();
  float position[3] = {0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = cursor_.nextWord();
    if (readFloat(word, position[axis])) continue;
    if (word.empty()) {
      report(start, "expected three numbers for a vertex, found " + std::to_string(axis));
    } else {
      const char* const expected = isNumber(word)
                                       ? "expected a number within float range for a vertex, found "
                                       : "expected a number for a vertex, found ";
      report(word.data(), expected + quoted(word));
    }
    break;
  }
  if (vertices_.size() == kMaxParts) report(start, "more vertices than 32 bits can number");
  vertices_.emplace_back(position[0], position[1], position[2]);
}

void ObjReader::readFace() {
  const char* const start = cursor_.place();
  cursor_.skipName();
  MeshGeometry::Face face{};
  std::size_t corners = 0;
  for (std::string_view word = cursor_.nextWord(); !word.empty(); word = cursor_.nextWord()) {
    std::uint32_t index = 0;
    if (!readCorner(word, index)) return;
    face = {corners == 0 ? index : face[0], face[2], index};
    if (++corners < 3) continue;
    if (faces_.size() == kMaxParts) report(start, "more triangles than 32 bits can number");
    faces_.push_back(face);
  }
  if (corners < 3) {
    report(start, "expected at least three corners for a face, found " + std::to_string(corners));
  }
}

/// Takes a, a/b, a//c or a/b/c. Only a matters; of b and c it is checked that they are numbers.
bool ObjReader::readCorner(std::string_view word, std::uint32_t& index) {
  const char* p = word.data();
  const char* const end = p + word.size();
  const bool isNegative = *p == '-';
  if (*p == '-' || *p == '+') ++p;
  const char* const digits = p;
  std::size_t number = 0;
  for (; p != end && *p >= '0' && *p <= '9'; ++p) {
    if (number <= kMaxParts) number = number * 10 + std::size_t(*p - '0');
  }
  bool isGood = p != digits && (p == end || *p == '/');
  int slashes = 0;
  for (; isGood && p != end; ++p) {
    slashes += *p == '/';
    isGood = slashes <= 2 && (*p == '/' || *p == '-' || *p == '+' || (*p >= '0' && *p <= '9'));
  }
  if (isGood) return toIndex(word, isNegative, number, index);
  report(word.data(), "expected a vertex index for a face, found " + quoted(word));
  return false;
}

bool ObjReader::toIndex(std::string_view word, bool isNegative, std::size_t number,
                        std::uint32_t& index) {
  const std::size_t available = isNegative ? vertices_.size() : vertexCount_;
  if (number >= 1 && number <= available) {
    index = std::uint32_t(isNegative ? vertices_.size() - number : number - 1);
    return true;
  }
  const std::string found = ", found " + quoted(word);
  if (number == 0) {
    report(word.data(), "face index 0: expected indices that count from 1" + found);
  } else {
    report(word.data(), "face index out of range: there are " + std::to_string(available) +
                            (isNegative ? " vertices before it" : " vertices") + found);
  }
  return false;
}

void ObjReader::report(const char* at, const std::string& message) {
  log_.add(scenePlace_, InputError(text_.name(), text_.lineAt(at), message));
}

}  // namespace

MeshGeometry readObj(const SourceText& text, MistakeLog& log, std::size_t place) {
  return ObjReader(text, log, place).read();
}
