// Reading OBJ statements: v and f count, and vt and vn where they are asked for; all others are
// passed over.
// Source: Wavefront, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.
//
// Most statements are `v x y z` and `f a b c`, and most of the time goes by in their digits: those
// are read eight bytes at a time where so many are there (decimal.h), which takes half as long.
//
// A corner of a face is a vertex, its texture coordinates and its normal, as in 3/1/2 or 3//2. The
// vertices are read at once; where the others are asked for, the words of the face are gone through
// once more for each: what stands behind so many slashes is the reference that is wanted. Indices
// count from 1, or backwards from -1, the last one before the face; a forward reference may be to
// one that comes later, so all are counted first. What is wrong is told the same way for all three.
#include <algorithm>
#include <cstdlib>

#include "scene/decimal.h"
#include "scene/number_reader.h"
#include "scene/obj_reader.h"
#include "scene/obj_words.h"
#include "scene/wording.h"

namespace {

/// Something that statements define and faces refer to by number.
struct Element {
  std::string_view statement;
  const char *one, *many;  // what it is called
  const char* index;       // what the number is called
  int slashes;             // before it in the corner of a face
  const char* numbers;     // what is expected of a statement:
  int fewest, most;        // so many numbers count
};
constexpr Element kVertex = {"v", "vertex", "vertices", "face index", 0, "three numbers", 3, 3};
constexpr Element kCoordinates = {
    "vt", "texture coordinate", "texture coordinates", "texture index", 1, "one or two numbers", 1,
    2};
constexpr Element kNormal = {"vn", "normal", "normals", "normal index", 2, "three numbers", 3, 3};

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
        wanted_(details),
        coordinateCount_(wanted_.coordinates ? countObjStatements(statements, "vt") : 0),
        normalCount_(wanted_.normals ? countObjStatements(statements, "vn") : 0) {}

  void read() {
    words_.forEachStatement(start_, [this](const char* p) { return readStatement(p); });
  }

 private:
  /// How many elements are defined before a face, and in the whole file.
  struct Defined {
    std::size_t before, inAll;
  };

  // Statements. Each function takes the place where one begins and returns the one behind what it
  // has read.

  [[gnu::always_inline]] const char* readStatement(const char* start) {
    if (words_.isStatement('v', start)) return readVertex(start);
    if (words_.isStatement('f', start)) return readFace(start);
    if (wanted_.any()) readDetail(start);
    return start;
  }

  /// A vt or vn, where it is wanted. Kept apart from the vertices, which are read in line.
  [[gnu::noinline]] void readDetail(const char* start) {
    Vec3f numbers;
    if (wanted_.coordinates && words_.isStatement(kCoordinates.statement, start)) {
      readNumbers(kCoordinates, start, numbers);
      chunk_.shading.coordinates.emplace_back(numbers.x(), numbers.y());
    } else if (wanted_.normals && words_.isStatement(kNormal.statement, start)) {
      readNumbers(kNormal, start, numbers);
      chunk_.shading.normals.push_back(numbers);
    }
  }

  const char* readVertex(const char* start) {
    Vec3f position;
    const char* const stop = readNumbers(kVertex, start, position);
    if (chunk_.vertices.size() == kMostObjElements) {
      report_(start, "more vertices than 32 bits can number");
    }
    chunk_.vertices.push_back(position);
    return stop;
  }

  /// Those that are left out stay as they are. What stands behind them (a weight, a colour) does
  /// not count.
  [[gnu::always_inline]] const char* readNumbers(const Element& element, const char* start,
                                                 Vec3f& numbers) {
    const char* p = start + element.statement.size();
    for (int k = 0; k < element.most; ++k) {
      const char* stop = decimal::scanBehindBlank(p, words_.end(), numbers[k]);
      if (!stop) {
        p = words_.findWord(p);
        const bool isEnd = words_.isStatementEnd(p);
        if (isEnd && k >= element.fewest) break;
        if (!isEnd) stop = scanNumber(p, words_.end(), numbers[k]);
        if (!stop || !words_.isWordEnd(stop)) {
          reportNumbers(element, start, p, k);
          break;
        }
      }
      p = stop;
    }
    return p;
  }

  /// A face of n corners becomes the n - 2 triangles of a fan around its first corner. One of less
  /// than three (what others write as points and lines) is none.
  const char* readFace(const char* start) {
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
    MeshShading& shading = chunk_.shading;
    if (wanted_.coordinates) {
      addReferences(kCoordinates, {shading.coordinates.size(), coordinateCount_}, start,
                    shading.coordinateFaces);
    }
    if (wanted_.normals) {
      addReferences(kNormal, {shading.normals.size(), normalCount_}, start, shading.normalFaces);
    }
    return p;
  }

  // Corners.

  /// Takes a good index of at most seven digits, behind one blank and before white space. Null, and
  /// nothing has changed, where a corner is written in any other way.
  [[gnu::always_inline]] const char* readPlainCorner(const char* p, Corner& corner) {
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
  const char* readCorner(const char* start, Corner& corner) {
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
    const std::size_t available = isNegative ? here + around_.before : around_.vertices;
    if (number - 1 >= available) {
      reportRange(kVertex, {start, std::size_t(stop - start)}, number, available, isNegative);
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
  const char* skipReferences(const char* p) const {
    int slashes = 0;
    for (; !words_.isWordEnd(p); ++p) {
      slashes += *p == '/';
      const bool isAllowed = *p == '/' || *p == '-' || *p == '+' || decimal::isDigit(*p);
      if (!isAllowed || slashes > 2) return nullptr;
    }
    return p;
  }

  void addFace(Corner a, Corner b, Corner c, const char* start) {
    if (chunk_.faces.size() == kMostObjElements) {
      report_(start, "more triangles than 32 bits can number");
    }
    if (((a | b | c) & kRelative) != 0 && around_.before > 0) {
      std::size_t number = 3 * chunk_.faces.size();
      for (const Corner corner : {a, b, c}) {
        if ((corner & kRelative) != 0) chunk_.relativeCorners.push_back(number);
        ++number;
      }
    }
    MeshGeometry::Face& face = chunk_.faces.emplace_back();  // filled in place: see Corner
    face[0] = std::uint32_t(a);
    face[1] = std::uint32_t(b);
    face[2] = std::uint32_t(c);
  }

  /// Appends a fan, of the references of the face at `start`, whose corners are well formed. (Where
  /// its outline is cut otherwise, the cut takes them along.)
  void addReferences(const Element& element, const Defined& defined, const char* start,
                     std::vector<MeshShading::Face>& faces) {
    MeshShading::Face fan{};  // the first corner, the last one and this one
    const char* p = words_.findWord(start + 1);
    for (std::size_t count = 0; !words_.isStatementEnd(p); ++count) {
      const std::string_view word = words_.wordAt(p);
      fan[2] = referenceIn(word, element, defined);
      if (count == 0) fan[0] = fan[2];
      if (count >= 2) faces.push_back(fan);
      fan[1] = fan[2];
      p = words_.findWord(p + word.size());
    }
  }

  /// The number, from 0 on, of the element that a corner refers to; kNone where it refers to none.
  std::uint32_t referenceIn(std::string_view word, const Element& element, const Defined& defined) {
    // What stands behind the last of its slashes, or nothing where there are fewer.
    std::string_view reference = word;
    for (int slash = 0; slash < element.slashes; ++slash) {
      reference.remove_prefix(std::min(reference.find('/'), reference.size() - 1) + 1);
    }
    reference = reference.substr(0, reference.find('/'));
    if (reference.empty()) return MeshShading::kNone;
    int number = 0;
    if (!readInt(reference, number)) {
      report_(word.data(),
              std::string("expected a ") + element.index + " for a face, found " + quoted(word));
      return MeshShading::kNone;
    }
    const bool isNegative = number < 0;
    const std::size_t available = isNegative ? defined.before : defined.inAll;
    const auto size = std::uint64_t(std::abs(std::int64_t(number)));
    if (size - 1 >= available) reportRange(element, word, size, available, isNegative);
    return std::uint32_t(isNegative ? defined.before - size : size - 1);
  }

  // Mistakes.

  /// Says what is wrong at `at` with the statement at `start`, of which `found` numbers are good.
  void reportNumbers(const Element& element, const char* start, const char* at, int found) {
    const std::string tail = std::string(" for a ") + element.one + ", found ";
    if (words_.isStatementEnd(at)) {
      report_(start, std::string("expected ") + element.numbers + tail + std::to_string(found));
      return;
    }
    const std::string_view word = words_.wordAt(at);
    const char* const range = isNumber(word) ? " within float range" : "";
    report_(at, std::string("expected a number") + range + tail + quoted(word));
  }

  /// Says that `number`, in a face's `word`, is not from 1 to `available`, counted forwards or
  /// backwards.
  void reportRange(const Element& element, std::string_view word, std::uint64_t number,
                   std::size_t available, bool isNegative) {
    const std::string problem =
        number == 0
            ? " 0: expected indices that count from 1"
            : std::string(" out of range: there ") + (available == 1 ? "is " : "are ") +
                  counted(available, element.one, element.many) + (isNegative ? " before it" : "");
    report_(word.data(), element.index + problem + ", found " + quoted(word));
  }

  const char* const start_;
  const ObjWords words_;
  const ObjSurroundings around_;
  const ObjReport& report_;
  ObjChunk& chunk_;
  const ObjDetails wanted_;
  const std::size_t coordinateCount_, normalCount_;  // in the whole file; 0 where not wanted
};

}  // namespace

void readObjChunk(std::string_view statements, const ObjSurroundings& around,
                  const ObjReport& report, ObjChunk& chunk, const ObjDetails& details) {
  ChunkReader(statements, around, report, chunk, details).read();
}

std::size_t countObjStatements(std::string_view statements, std::string_view name) {
  const ObjWords words(statements.data() + statements.size());
  std::size_t count = 0;
  words.forEachStatement(statements.data(), [&](const char* p) {
    count += words.isStatement(name, p);
    return p;
  });
  return count;
}
