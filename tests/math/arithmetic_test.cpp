// Same bytes everywhere: what the program computes with, and that a build cannot change it.
#include "math/arithmetic.h"

#include <cmath>
#include <cstdlib>

#include "check.h"
#include "math/vec3.h"
#include "run_program.h"

namespace {

/// What the compiler says of a file that includes math/arithmetic.h; "" where it compiles.
std::string faultsWith(const std::string& options) {
  const check::ScratchFolder folder;
  const std::string said = folder.file("said"), include = check::testsFolder() + "/../include";
  const std::string command = std::string("echo '#include \"math/arithmetic.h\"' | ") +
                              RAYTRACER_COMPILER + " -std=c++17 -x c++ -fsyntax-only -I " +
                              check::quoted(include) + " " + options + " - >" +
                              check::quoted(said) + " 2>&1";
  if (std::system(command.c_str()) == 0) return "";
  return check::contentOf(said) + "(refused)";
}

bool isRefused(const std::string& options, const std::string& reason) {
  return faultsWith(options).find(reason) != std::string::npos;
}

TEST("a product is rounded before it is added to") {
  // (1 + u)(1 - u) = 1 - u^2 with u = 2^-30 lies 2^-60 below 1, and rounds to 1 (the spacing below
  // 1 is 2^-53): minus 1 that is 0, while a fused multiply-add would keep -2^-60.
  const volatile double a = 1 + 0x1p-30, b = 1 - 0x1p-30, one = 1;
  const double x = a, y = b, z = one;
  CHECK_EQUAL(x * y - z, 0.0);
  // In float u = 2^-15, and the spacing below 1 is 2^-24.
  const volatile float c = 1 + 0x1p-15f, d = 1 - 0x1p-15f, unit = 1;
  const float p = c, q = d, r = unit;
  CHECK_EQUAL(p * q - r, 0.0f);
}

TEST("numbers too small for full precision are kept, not flushed to zero") {
  const volatile double least = std::numeric_limits<double>::min();
  CHECK(least / 4 > 0);
  CHECK_EQUAL(least / 4 * 4, double(least));
  const volatile float small = std::numeric_limits<float>::min();
  CHECK(small / 4 > 0);
}

TEST("roots are rounded to the nearest number") {
  // (1 + 2^-52)^2 = 1 + 2^-51 + 2^-104; 1 + 2^-51 has the root 1 + 2^-52 - 2^-105 + ..., which is
  // nearest to 1 + 2^-52.
  const volatile double square = 1 + 0x1p-51;
  CHECK_EQUAL(std::sqrt(square), 1 + 0x1p-52);
}

TEST("a compiler that may bend the rules of arithmetic is refused, with the reason") {
  if (!faultsWith("").empty()) SKIP("the compiler of this build cannot be run here");
  for (const char* options : {"-ffast-math", "-Ofast", "-ffinite-math-only"}) {
    check::report(isRefused(options, "build without -ffast-math"), __FILE__, __LINE__, options);
  }
}

TEST("a compiler that takes 0.1 for a float is refused") {
  const std::string option = "-fsingle-precision-constant";
  if (!faultsWith("").empty()) SKIP("the compiler of this build cannot be run here");
  const bool isKnown = !isRefused(option + " -Werror", "not supported");
  if (!isKnown) SKIP("this compiler has no such option");
  CHECK(isRefused(option, "build without " + option));
}

TEST("a processor mode that computes with more digits is refused, with the reason") {
  if (!faultsWith("-msse2 -mfpmath=sse").empty()) SKIP("no x87 here");
  CHECK(isRefused("-mfpmath=387", "sums and products must be rounded"));
}

/// The colour that stands for `sum`, as a float and, to be computed with, widened again. Kept apart,
/// so that no compiler knows the numbers.
[[gnu::noinline]] void roundSideBySide(const double* sum, Vec3f* color, Vec3d* widened) {
  *color = Vec3f(Vec3d(sum[0], sum[1], sum[2]));
  *widened = Vec3d(*color);
}

TEST("a double that was rounded to float and widened again stays rounded, three side by side") {
  // g++ 12, where it makes vectors of single statements, widens what was not rounded.
  const volatile double third = 1.0 / 3;  // 0x1.5555555555555p-2; as a float 0x1.555556p-2
  const double sum[3] = {third, -third, 2 * third};
  Vec3f color;
  Vec3d widened;
  roundSideBySide(sum, &color, &widened);
  CHECK_EQUAL(widened.x(), 0x1.555556p-2);
  CHECK_EQUAL(widened.y(), -0x1.555556p-2);
  CHECK_EQUAL(widened.z(), 0x1.555556p-1);
  CHECK(color == Vec3f(0x1.555556p-2f, -0x1.555556p-2f, 0x1.555556p-1f));
}

}  // namespace
