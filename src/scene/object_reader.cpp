// Objects of a scene file: primitives, meshes, Groups, and Transforms with their steps.
//
// A Group and a Transform are read by recursion, the object inside before the one around it, so
// that each is made of what is there already. The steps of a Transform become one matrix, the first
// step leftmost: what is in it meets the last one first. An object with a mistake in it is null and
// left out; what stands around it is read on.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"
#include "geometry/triangle_mesh.h"
#include "scene/scene_reader.h"

/// Where a Group or Transform stands too deep, that is reported, and its block passed over: reading
/// it takes the stack.
const Object3D* ObjectReader::read() {
  const std::string_view word = in_.word();
  if (places_) places_->begin(word, in_.at());
  const Object3D* object = nullptr;
  if (word != "Group" && word != "Transform") {
    object = readShape();
  } else if (depth_ < kMaxNesting) {
    ++depth_;
    object = word == "Group" ? readGroup() : readTransform();
    --depth_;
  } else {
    in_.report(in_.at(), "expected Groups and Transforms at most " + std::to_string(kMaxNesting) +
                             " deep inside each other, found another " + quoted(word));
    in_.skipWordAndBlock();
  }
  if (places_) places_->end(object);
  return object;
}

const Object3D* ObjectReader::keep(std::unique_ptr<Object3D> object) {
  objects_.push_back(std::move(object));
  return objects_.back().get();
}

// Shapes: the material that holds, the fields, their ranges, and the object.

const Object3D* ObjectReader::readShape() {
  const std::string_view owner = in_.word();
  const char* const at = in_.at();
  const Material* const material = materials_.materialFor(owner, at);
  in_.advance();
  const Fields fields = in_.readFields(owner, {owner});
  return fields.areGood ? addShape(owner, at, fields, material) : nullptr;
}

const Object3D* ObjectReader::addShape(std::string_view owner, const char* at, const Fields& fields,
                                       const Material* material) {
  std::unique_ptr<Object3D> shape = makeShape(owner, at, fields, material);
  if (!shape) return nullptr;
  notes_.objectStarts.emplace_back(shape.get(), at);
  return keep(std::move(shape));
}

/// Null where there is no material, or no mesh.
std::unique_ptr<Object3D> ObjectReader::makeShape(std::string_view owner, const char* at,
                                                  const Fields& fields, const Material* material) {
  if (owner == "TriangleMesh") {
    const Value& file = fields["obj_file"];
    bool isNew = false;
    const MeshGeometry* const mesh = meshes_.find(in_.fileNameAt(file.at), isNew);
    if (!mesh || !material) return nullptr;
    if (isNew) warnOfMesh(*mesh, file.at);
    return std::make_unique<TriangleMesh>(mesh, material);
  }
  if (!material) return nullptr;
  if (owner == "Sphere") {
    return std::make_unique<Sphere>(fields["center"].vector(), fields["radius"].number(), material);
  }
  if (owner == "Plane") {
    return std::make_unique<Plane>(fields["normal"].direction(), fields["offset"].number(),
                                   material);
  }
  auto triangle = std::make_unique<Triangle>(fields["vertex0"].vector(), fields["vertex1"].vector(),
                                             fields["vertex2"].vector(), material);
  if (!triangle->hasArea() && ++notes_.flatTriangles <= kFlatTrianglesNamed) {
    notes_.warn(at, "the triangle has no area: it will not be seen");
  }
  return triangle;
}

void ObjectReader::warnOfMesh(const MeshGeometry& mesh, const char* at) {
  const std::string name = "the mesh " + quoted(in_.fileNameAt(at)) + " ";
  for (const std::string& warning : meshes_.warnings()) notes_.warn(at, name + warning);
  if (mesh.faceCount() == 0) {
    notes_.warn(at, name + "has no faces: it will not be seen");
  } else if (const std::uint32_t count = mesh.countFlatFaces()) {
    notes_.warn(at, name + "has " + counted(count, "triangle") +
                        " without area: " + (count == 1 ? "it" : "they") + " will not be seen");
  }
}

// Groups and Transforms.

const Object3D* ObjectReader::readGroup() {
  in_.advance();
  auto group = std::make_unique<Group>();
  const auto readItem = [&] {
    if (const Object3D* object = read()) group->addObject(object);
  };
  const auto readOther = [this] {
    const bool isIndex = in_.word() == "MaterialIndex";
    if (!isIndex && !isOneOf(in_.word(), kMaterialWords)) return false;
    isIndex ? materials_.readIndex() : materials_.readInline();
    return true;
  };
  in_.readCounted({"Group", "numObjects", kObjectWords, kGroupWords}, readItem, readOther);
  return keep(std::move(group));
}

namespace {

/// What a step of that kind does, given the numbers behind its name.
Matrix matrixOf(std::string_view step, const double* n) {
  if (step == "Translate") return Matrix::translation({n[0], n[1], n[2]});
  if (step == "Scale") return Matrix::scale({n[0], n[1], n[2]});
  if (step == "UniformScale") return Matrix::scale({n[0], n[0], n[0]});
  if (step == "XRotate") return Matrix::rotation({1, 0, 0}, n[0]);
  if (step == "YRotate") return Matrix::rotation({0, 1, 0}, n[0]);
  if (step == "ZRotate") return Matrix::rotation({0, 0, 1}, n[0]);
  if (step == "Rotate") return Matrix::rotation({n[0], n[1], n[2]}, n[3]);
  double rows[3][4];
  for (int i = 0; i < 12; ++i) rows[i / 4][i % 4] = n[i];
  return Matrix(rows);
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
  std::ostringstream text;
  for (std::size_t i = 0; i < count; ++i) text << ' ' << numbers[i];
  return text.str();
}

/// What is wrong with a step, or nothing: then `matrix` is what it does.
std::string problemOf(const Step& step, const double* n, bool mustInvert, Matrix& matrix) {
  if (step.kind == "Rotate" && n[0] == 0 && n[1] == 0 && n[2] == 0) {
    return "expected an axis of Rotate that is not zero, found 0 0 0";
  }
  if (step.kind == "Matrix" && !(n[12] == 0 && n[13] == 0 && n[14] == 0 && n[15] == 1)) {
    return "expected 0 0 0 1 as the last row of " + std::string(step.name) + ", found" +
           shown(n + 12, 4);
  }
  matrix = matrixOf(step.kind, n);
  if (!mustInvert || !step.canBeSingular || hasInverse(matrix)) return {};
  return "singular transform: expected a step that can be inverted, found " +
         std::string(step.name) + shown(n, step.numbers);
}

/// Reads the numbers of a step, with or without braces, from its name on. False after a mistake.
bool readStepNumbers(FieldReader& in, const Step& step, double* numbers) {
  if (in.readPlainNumbers(numbers, step.numbers)) return true;
  in.advance();
  const bool hasBraces = in.isAt('{');
  if (hasBraces) in.advance();
  const bool isGood = in.readNumbers(step.name, numbers, step.numbers, false);
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
    const auto isNamed = [&](const Step& each) { return each.name == in.word(); };
    const Step* const step = std::find_if(std::begin(kSteps), std::end(kSteps), isNamed);
    const bool isStep = step != std::end(kSteps);  // be it in another language
    if (isStep && isIn(step->languages, in.language())) {
      isGood &= readStep(in, *step, mustInvert, product);
    } else if (!isStep && (in.atEnd() || in.isAt('}') || in.isAtBlock())) {
      return isGood;
    } else {
      in.skipUnknown("Transform", allowed);
      isGood = false;
    }
  }
}

bool checkInverse(FieldReader& in, const char* at, const Matrix& product) {
  if (hasInverse(product)) return true;
  in.report(at,
            "singular transform: expected steps that, multiplied, can be inverted, found their "
            "product singular");
  return false;
}

const Object3D* ObjectReader::readTransform() {
  const char* const at = in_.at();
  in_.advance();
  if (!in_.openBlock("Transform")) return nullptr;
  Matrix matrix;
  const bool areStepsGood = readSteps(in_, kTransformWords, true, matrix);
  const Object3D* const object = readMovedObject(areStepsGood);
  if (!areStepsGood || !checkInverse(in_, at, matrix)) return nullptr;
  return object ? keep(std::make_unique<Transform>(matrix, object)) : nullptr;
}

/// Reads the object of a Transform and the `}` behind it. After a mistake in the steps a missing
/// object is no news: its name may have been the mistake.
const Object3D* ObjectReader::readMovedObject(bool areStepsGood) {
  if (!isOneOf(in_.word(), kObjectWords)) {
    if (areStepsGood || !in_.isAt('}')) {
      in_.reportExpected("an object in Transform (" + listed(kObjectWords) + ")");
    }
    in_.closeBlock("Transform");
    return nullptr;
  }
  const Object3D* const object = read();
  while (isOneOf(in_.word(), kObjectWords)) {
    in_.report(in_.at(),
               "expected '}' behind the one object of Transform, found " + quoted(in_.word()));
    read();
  }
  in_.closeBlock("Transform");
  return object;
}
