// ObjDetailReader: reads the words of a face once more, after the reader of vertices, which is made
// for speed and so knows nothing of this.
//
// A corner is a vertex, its texture coordinates and its normal, as in 3/1/2 or 3//2: what stands
// behind so many slashes is the reference that is wanted. Indices count from 1, or backwards from
// -1, the last one before the face; a forward reference may be to one that comes later, so all are
// counted first. A face of more than three corners gives a fan here; where its outline is cut
// otherwise, the cut takes these references along.
#include "scene/obj_details.h"

#include <algorithm>
#include <cstdlib>

#include "scene/number_reader.h"
#include "scene/wording.h"

void reportObjNumbers(const ObjWords& words, const ObjReport& report, const ObjElement& element,
                      const char* start, const char* at, int found) {
  const std::string tail = std::string(" for a ") + element.one + ", found ";
  if (words.isStatementEnd(at)) {
    report(start, std::string("expected ") + element.numbers + tail + std::to_string(found));
    return;
  }
  const std::string_view word = words.wordAt(at);
  const char* const expected =
      isNumber(word) ? "expected a number within float range" : "expected a number";
  report(at, expected + tail + quoted(word));
}

void reportObjRange(const ObjReport& report, const ObjElement& element, std::string_view word,
                    std::uint64_t number, std::size_t available, bool isNegative) {
  const std::string found = ", found " + quoted(word);
  if (number == 0) {
    report(word.data(),
           std::string(element.index) + " 0: expected indices that count from 1" + found);
    return;
  }
  report(word.data(), std::string(element.index) + " out of range: there " +
                          (available == 1 ? "is " : "are ") +
                          counted(available, element.one, element.many) +
                          (isNegative ? " before it" : "") + found);
}

ObjDetailReader::ObjDetailReader(std::string_view statements, const ObjDetails& wanted,
                                 const ObjReport& report, MeshShading& shading)
    : words_(statements.data() + statements.size()),
      wanted_(wanted),
      report_(report),
      shading_(shading),
      coordinateCount_(wanted.coordinates ? countObjStatements(statements, "vt") : 0),
      normalCount_(wanted.normals ? countObjStatements(statements, "vn") : 0) {}

/// A vt or vn; any other statement is no business of this reader.
void ObjDetailReader::readStatement(const char* start) {
  if (wanted_.coordinates && words_.isStatement(kObjCoordinates.statement, start)) {
    const Vec3f numbers = readNumbers(kObjCoordinates, start);
    shading_.coordinates.emplace_back(numbers.x(), numbers.y());
  } else if (wanted_.normals && words_.isStatement(kObjNormal.statement, start)) {
    shading_.normals.push_back(readNumbers(kObjNormal, start));
  }
}

/// The numbers of a statement; those that are left out are 0.
Vec3f ObjDetailReader::readNumbers(const ObjElement& element, const char* start) {
  Vec3f numbers;
  const char* p = start + element.statement.size();
  for (int k = 0; k < element.most; ++k) {
    p = words_.findWord(p);
    const bool isEnd = words_.isStatementEnd(p);
    if (isEnd && k >= element.fewest) break;
    const char* const stop = isEnd ? nullptr : scanFloat(p, words_.end(), numbers[k]);
    if (!stop || !words_.isWordEnd(stop)) {
      reportObjNumbers(words_, report_, element, start, p, k);
      break;
    }
    p = stop;
  }
  return numbers;
}

void ObjDetailReader::readFace(const char* start) {
  if (wanted_.coordinates) {
    addReferences(kObjCoordinates, {shading_.coordinates.size(), coordinateCount_}, start,
                  shading_.coordinateFaces);
  }
  if (wanted_.normals) {
    addReferences(kObjNormal, {shading_.normals.size(), normalCount_}, start, shading_.normalFaces);
  }
}

/// Appends a fan, of the references of the face at `start`.
void ObjDetailReader::addReferences(const ObjElement& element, const Defined& defined,
                                    const char* start, std::vector<MeshShading::Face>& faces) {
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
std::uint32_t ObjDetailReader::referenceIn(std::string_view word, const ObjElement& element,
                                           const Defined& defined) {
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
  if (size - 1 >= available) reportObjRange(report_, element, word, size, available, isNegative);
  return std::uint32_t(isNegative ? defined.before - size : size - 1);
}
