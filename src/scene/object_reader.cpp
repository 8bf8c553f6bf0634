// Objects of a scene file: primitives, meshes, Groups, and Transforms with their steps.
#include <cmath>
#include <cstdio>

#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"
#include "geometry/triangle_mesh.h"
#include "scene/scene_reader.h"

const Object3D* ObjectReader::read() {
  if (!places_) return readKind(in_.word());
  places_->begin(in_.word(), in_.at());
  const Object3D* const object = readKind(in_.word());
  places_->end(object);
  return object;
}

const Object3D* ObjectReader::readKind(std::string_view word) {
  if (word == "Sphere") return readSphere();
  if (word == "Triangle") return readTriangle();
  if (word == "Transform") return readTransform();
  if (word == "TriangleMesh") return readTriangleMesh();
  if (word == "Plane") return readPlane();
  return readGroup();
}

const Object3D* ObjectReader::keep(std::unique_ptr<Object3D> object, const char* at) {
  const Object3D* const borrowed = object.get();
  if (at) notes_.objectStarts.emplace_back(borrowed, at);
  objects_.push_back(std::move(object));
  return borrowed;
}

// Primitives: the material that holds, the fields, their ranges, and the object.

const Object3D* ObjectReader::readSphere() {
  const char* const at = in_.at();
  const Material* const material = materials_.materialFor("Sphere", at);
  in_.advance();
  SphereFields fields;
  const bool isGood = in_.readFields("Sphere", {fields});
  if (!in_.checkRanges(fields) || !isGood || !material) return nullptr;
  return keep(std::make_unique<Sphere>(fields.center.value, fields.radius.value, material), at);
}

const Object3D* ObjectReader::readPlane() {
  const Material* const material = materials_.materialFor("Plane", in_.at());
  in_.advance();
  PlaneFields fields;
  const bool isGood = in_.readFields("Plane", {fields});
  if (!in_.checkRanges(fields) || !isGood || !material) return nullptr;
  return keep(std::make_unique<Plane>(fields.normal.value, fields.offset.value, material));
}

const Object3D* ObjectReader::readTriangle() {
  const char* const at = in_.at();
  const Material* const material = materials_.materialFor("Triangle", at);
  in_.advance();
  TriangleFields fields;
  if (!in_.readFields("Triangle", {fields}) || !material) return nullptr;
  auto triangle = std::make_unique<Triangle>(fields.vertex0.value, fields.vertex1.value,
                                             fields.vertex2.value, material);
  if (!triangle->hasArea() && ++notes_.flatTriangles <= kFlatTrianglesNamed) {
    notes_.warn(at, "the triangle has no area: it will not be seen");
  }
  return keep(std::move(triangle), at);
}

const Object3D* ObjectReader::readTriangleMesh() {
  const char* const at = in_.at();
  const Material* const material = materials_.materialFor("TriangleMesh", at);
  in_.advance();
  MeshFields fields;
  if (!in_.readFields("TriangleMesh", {fields})) return nullptr;
  bool isNew = false;
  const MeshGeometry* const mesh = meshes_.find(fields.file.value, isNew);
  if (!mesh || !material) return nullptr;
  if (isNew) warnOfMesh(*mesh, fields.file.at);
  return keep(std::make_unique<TriangleMesh>(mesh, material), at);
}

void ObjectReader::warnOfMesh(const MeshGeometry& mesh, const char* at) {
  const std::string name = "the mesh " + in_.quotedAt(at);
  if (mesh.faceCount() == 0) {
    notes_.warn(at, name + " has no faces: it will not be seen");
  } else if (const std::uint32_t count = mesh.countFlatFaces()) {
    notes_.warn(at,
                name + " has " + std::to_string(count) +
                    (count == 1 ? " triangle without area: it" : " triangles without area: they") +
                    " will not be seen");
  }
}

// Groups and Transforms.

/// Reports, and passes over the block, where a Group or Transform stands too deep: reading them
/// takes the stack.
bool ObjectReader::isTooDeep() {
  if (depth_ < kMaxNesting) return false;
  in_.report(in_.at(), "expected Groups and Transforms at most " + std::to_string(kMaxNesting) +
                           " deep inside each other, found another " + quoted(in_.word()));
  in_.skipWordAndBlock();
  return true;
}

const Object3D* ObjectReader::readGroup() {
  if (isTooDeep()) return nullptr;
  ++depth_;
  in_.advance();
  auto group = std::make_unique<Group>();
  const auto readItem = [&] {
    if (const Object3D* object = read()) group->addObject(object);
  };
  const auto readOther = [this] {
    const bool isIndex = in_.word() == "MaterialIndex";
    if (!isIndex && !WordList(kMaterialWords).contains(in_.word())) return false;
    isIndex ? materials_.readIndex() : materials_.readInline();
    return true;
  };
  in_.readCounted({"Group", "numObjects", kObjectWords, kGroupWords}, readItem, readOther);
  --depth_;
  return keep(std::move(group));
}

namespace {

const Step* findStep(std::string_view word) {
  for (const Step& step : kSteps) {
    if (step.name == word) return &step;
  }
  return nullptr;
}

/// True when the inverse exists and undoes the map to two digits at least: a map that is singular
/// but for rounding errors, or too large or small for its determinant, does not pass. Infinities
/// and NaN anywhere give NaN in the product.
bool hasInverse(const Matrix& matrix) {
  Matrix inverse;
  if (!matrix.inverse(inverse)) return false;
  const Matrix product = matrix * inverse;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double identity = row == column ? 1 : 0;
      if (!(std::fabs(product.at(row, column) - identity) <= 0.01)) return false;
    }
    if (!std::isfinite(product.at(row, 3))) return false;
  }
  return true;
}

std::string shown(const double* numbers, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    char number[32];
    std::snprintf(number, sizeof number, " %g", numbers[i]);
    text += number;
  }
  return text;
}

/// What is wrong with a step, or nothing: then `matrix` is what it does.
std::string problemOf(const Step& step, const double* n, bool mustInvert, Matrix& matrix) {
  if (step.name == "Rotate" && n[0] == 0 && n[1] == 0 && n[2] == 0) {
    return "expected an axis of Rotate that is not zero, found 0 0 0";
  }
  if (step.name == "Matrix" && !(n[12] == 0 && n[13] == 0 && n[14] == 0 && n[15] == 1)) {
    return "expected 0 0 0 1 as the last row of Matrix, found" + shown(n + 12, 4);
  }
  matrix = step.toMatrix(n);
  if (!mustInvert || !step.canBeSingular || hasInverse(matrix)) return {};
  return "singular transform: expected a step that can be inverted, found " +
         std::string(step.name) + shown(n, step.numbers);
}

/// Reads the numbers of a step, with or without braces, from its name on. False after a mistake.
bool readStepNumbers(FieldReader& in, const Step& step, double* numbers) {
  if (in.readPlainNumbers(numbers, step.numbers)) return true;
  in.advance();
  const bool hasBraces = in.word() == "{";
  if (hasBraces) in.advance();
  bool isGood = true;
  for (std::size_t i = 0; i < step.numbers; ++i) {
    const char* const before = in.at();
    isGood &= in.readNumber(step.name, numbers[i]);
    if (in.at() == before) break;
  }
  if (hasBraces) in.closeBlock(step.name);
  return isGood;
}

bool readStep(FieldReader& in, const Step& step, bool mustInvert, Matrix& product) {
  const char* const at = in.at();
  double numbers[kMostStepNumbers] = {};
  if (!readStepNumbers(in, step, numbers)) return false;
  Matrix matrix;
  const std::string problem = problemOf(step, numbers, mustInvert, matrix);
  if (!problem.empty()) {
    in.report(at, problem);
    return false;
  }
  product = product * matrix;
  return true;
}

}  // namespace

bool readSteps(FieldReader& in, WordList allowed, bool mustInvert, Matrix& product) {
  bool isGood = true;
  for (;;) {
    if (const Step* step = findStep(in.word())) {
      isGood &= readStep(in, *step, mustInvert, product);
    } else if (in.atEnd() || in.word() == "}" || in.isAtBlock()) {
      return isGood;
    } else {
      in.skipUnknown("Transform", allowed);
      isGood = false;
    }
  }
}

const Object3D* ObjectReader::readTransform() {
  if (isTooDeep()) return nullptr;
  const char* const at = in_.at();
  in_.advance();
  if (!in_.openBlock("Transform")) return nullptr;
  ++depth_;
  Matrix matrix;
  const bool areStepsGood = readSteps(in_, kTransformWords, true, matrix);
  const Object3D* const object = readMovedObject(areStepsGood);
  --depth_;
  if (!areStepsGood) return nullptr;
  if (!hasInverse(matrix)) {
    in_.report(at,
               "singular transform: expected steps that, multiplied, can be inverted, found their "
               "product singular");
    return nullptr;
  }
  return object ? keep(std::make_unique<Transform>(matrix, object)) : nullptr;
}

/// Reads the object of a Transform and the `}` behind it. After a mistake in the steps a missing
/// object is no news: its name may have been the mistake.
const Object3D* ObjectReader::readMovedObject(bool areStepsGood) {
  if (!WordList(kObjectWords).contains(in_.word())) {
    if (areStepsGood || in_.word() != "}") {
      in_.reportExpected("an object in Transform (" + listed(kObjectWords) + ")");
    }
    in_.closeBlock("Transform");
    return nullptr;
  }
  const Object3D* const object = read();
  while (WordList(kObjectWords).contains(in_.word())) {
    in_.report(in_.at(),
               "expected '}' behind the one object of Transform, found " + quoted(in_.word()));
    read();
  }
  in_.closeBlock("Transform");
  return object;
}
