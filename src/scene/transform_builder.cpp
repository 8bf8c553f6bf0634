// Transforms of a scene file: their steps, and the one object that they move.
#include <cmath>
#include <cstdio>

#include "geometry/transform.h"
#include "scene/scene_builder.h"
#include "scene/scene_words.h"

namespace {

struct StepKind {
  std::string_view name;
  int numbers;  // how many follow the name
  Matrix (*toMatrix)(const double* numbers);
  bool canBeSingular;  // no translation by finite numbers is, nor a turn about an axis
};

constexpr int kMostNumbers = 16;

Matrix toTranslation(const double* n) { return Matrix::translation({n[0], n[1], n[2]}); }
Matrix toScale(const double* n) { return Matrix::scale({n[0], n[1], n[2]}); }
Matrix toUniformScale(const double* n) { return Matrix::scale({n[0], n[0], n[0]}); }
Matrix toXRotation(const double* n) { return Matrix::rotation({1, 0, 0}, n[0]); }
Matrix toYRotation(const double* n) { return Matrix::rotation({0, 1, 0}, n[0]); }
Matrix toZRotation(const double* n) { return Matrix::rotation({0, 0, 1}, n[0]); }
Matrix toRotation(const double* n) { return Matrix::rotation({n[0], n[1], n[2]}, n[3]); }
Matrix toAffineMap(const double* n) {
  double rows[3][4];
  for (int i = 0; i < 12; ++i) rows[i / 4][i % 4] = n[i];
  return Matrix(rows);
}

constexpr StepKind kSteps[] = {
    {"Translate", 3, toTranslation, false},    {"Scale", 3, toScale, true},
    {"UniformScale", 1, toUniformScale, true}, {"XRotate", 1, toXRotation, false},
    {"YRotate", 1, toYRotation, false},        {"ZRotate", 1, toZRotation, false},
    {"Rotate", 4, toRotation, true},           {"Matrix", 16, toAffineMap, true}};

const StepKind* findStep(std::string_view word) {
  for (const StepKind& kind : kSteps) {
    if (kind.name == word) return &kind;
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

std::string shown(const double* numbers, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    char number[32];
    std::snprintf(number, sizeof number, " %g", numbers[i]);
    text += number;
  }
  return text;
}

/// What is wrong with a step, or nothing: then `step` is what it does.
std::string problemOf(const StepKind& kind, const double* n, bool mustInvert, Matrix& step) {
  if (kind.name == "Rotate" && n[0] == 0 && n[1] == 0 && n[2] == 0) {
    return "expected an axis of Rotate that is not zero, found 0 0 0";
  }
  if (kind.name == "Matrix" && !(n[12] == 0 && n[13] == 0 && n[14] == 0 && n[15] == 1)) {
    return "expected 0 0 0 1 as the last row of Matrix, found" + shown(n + 12, 4);
  }
  step = kind.toMatrix(n);
  if (!mustInvert || !kind.canBeSingular || hasInverse(step)) return {};
  return "singular transform: expected a step that can be inverted, found " +
         std::string(kind.name) + shown(n, kind.numbers);
}

}  // namespace

const Object3D* SceneBuilder::readTransform() {
  if (isTooDeep()) return nullptr;
  const char* const at = in_.at();
  in_.advance();
  if (!in_.openBlock("Transform")) return nullptr;
  ++depth_;
  Matrix matrix;
  const bool areStepsGood = readSteps(matrix, kTransformWords, true);
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

/// Multiplies the steps, the first one leftmost, up to the first word that is none of them.
bool SceneBuilder::readSteps(Matrix& product, WordList allowed, bool mustInvert) {
  bool isGood = true;
  for (;;) {
    if (findStep(in_.word())) {
      isGood &= readStep(product, mustInvert);
    } else if (in_.atEnd() || in_.word() == "}" || isBlockWord(in_.word())) {
      return isGood;
    } else {
      in_.skipUnknown("Transform", allowed);
      isGood = false;
    }
  }
}

bool SceneBuilder::readStep(Matrix& product, bool mustInvert) {
  const StepKind& kind = *findStep(in_.word());
  const char* const at = in_.at();
  double numbers[kMostNumbers] = {};
  if (!readStepNumbers(kind.name, numbers, kind.numbers)) return false;
  Matrix step;
  const std::string problem = problemOf(kind, numbers, mustInvert, step);
  if (!problem.empty()) {
    in_.report(at, problem);
    return false;
  }
  product = product * step;
  return true;
}

/// Reads the numbers of a step, with or without braces, from its name on. False after a mistake.
bool SceneBuilder::readStepNumbers(std::string_view name, double* numbers, int count) {
  if (in_.readPlainNumbers(numbers, count)) return true;
  in_.advance();
  const bool hasBraces = in_.word() == "{";
  if (hasBraces) in_.advance();
  bool isGood = true;
  for (int i = 0; i < count; ++i) {
    const char* const before = in_.at();
    isGood &= in_.readNumber(name, numbers[i]);
    if (in_.at() == before) break;
  }
  if (hasBraces) in_.closeBlock(name);
  return isGood;
}

/// Reads the object of a Transform and the `}` behind it. After a mistake in the steps a missing
/// object is no news: its name may have been the mistake.
const Object3D* SceneBuilder::readMovedObject(bool areStepsGood) {
  if (!WordList(kObjectWords).contains(in_.word())) {
    if (areStepsGood || in_.word() != "}")
      in_.reportExpected("an object in Transform (" + listed(kObjectWords) + ")");
    in_.closeBlock("Transform");
    return nullptr;
  }
  const Object3D* const object = readObject();
  while (WordList(kObjectWords).contains(in_.word())) {
    in_.report(in_.at(),
               "expected '}' behind the one object of Transform, found " + quoted(in_.word()));
    readObject();
  }
  in_.closeBlock("Transform");
  return object;
}
