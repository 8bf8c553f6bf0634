// Lanes: every lane of every formula has the bits that the formula has for a double, in each
// instruction set that this processor has.
#include "math/lanes.h"

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "accel/compiled_scene.h"
#include "check.h"
#include "random.h"
#include "wide_formulas.h"

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kSpecial[] = {0.0,
                               -0.0,
                               1.0,
                               -1.0,
                               kInf,
                               -kInf,
                               kNan,
                               0x1p-1074,
                               -0x1p-1030,
                               0x1p-1022,
                               0x1.fffffffffffffp+1023,
                               0.5,
                               2.5,
                               -0.5,
                               1e-200,
                               1e200,
                               709.785,
                               -745.135,
                               -708.5,
                               4503599627370497.5,
                               -4503599627370495.5,
                               0x1.fffffefp+127};

struct Set {
  std::string name;
  wide::Lanes lanes;
  int width;  // of a vector
};

/// Those of this processor; the first is of what the tests are compiled for.
std::vector<Set> sets() {
  std::vector<Set> all = {{"baseline", wide::ofThisUnit(), lanes::kDoubles}};
#ifdef RAYTRACER_WIDE_TESTS
  const SimdLevel most = availableSimd(SimdLevel::avx512);
  if (most != SimdLevel::baseline) all.push_back({"avx2", wide::avx2Lanes(), 4});
  if (most == SimdLevel::avx512) all.push_back({"avx512", wide::avx512Lanes(), 8});
#endif
  return all;
}

bool isSame(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b); }

double anyNumber(Random& random) {
  switch (random.index(8)) {
    case 0:
      return kSpecial[random.index(int(sizeof kSpecial / sizeof *kSpecial))];
    case 1: {
      const double size = random.logUniform(1e-300, 1e300);
      return random.index(2) ? size : -size;
    }
    case 2:
      return random.uniform(-800, 800);
    case 3:
      return double(random.index(5) - 2);
    default:
      return random.uniform(-2, 2);
  }
}

/// Numbers of all kinds, or such as rays and surfaces have: unit vectors, the usual sizes, a bound
/// of 0 and a far one.
void setRow(Random& random, double (*in)[wide::kRows], int row) {
  const bool isUsual = random.index(4) != 0;
  for (int k = 0; k < wide::kInputs; ++k) {
    in[k][row] = isUsual ? random.uniform(-2, 2) : anyNumber(random);
  }
  if (!isUsual) return;
  for (int k = 0; k < 15; k += 3) {
    const int kind = random.index(8);
    if (kind == 0) continue;
    // At times the vector before once more, or none: ways of no length.
    const Vec3d v =
        kind == 1   ? Vec3d()
        : kind == 2 ? Vec3d(in[(k + 12) % 15][row], in[(k + 13) % 15][row], in[(k + 14) % 15][row])
                    : random.unitVector();
    for (int axis = 0; axis < 3; ++axis) in[k + axis][row] = v[axis];
  }
  if (random.index(4) == 0) in[1][row] = in[16][row] = 1;  // of an index
  in[17][row] = random.index(2) ? 0 : -kInf;
  in[18][row] = random.index(2) ? kInf : random.uniform(0, 3);
  in[19][row] = random.index(3) ? random.uniform(0, 100) : 0;
}

/// How often a formula gave a number, and each of 0 and 1 as its first result.
struct Exercised {
  int numbers = 0, zeros = 0, ones = 0, others = 0;
};

/// "" or the first difference between a lane and a double.
std::string firstDifference(const Set& set, int formula, int blocks, Exercised& exercised) {
  Random random(std::uint64_t(formula) + 1);
  for (int block = 0; block < blocks; ++block) {
    double in[wide::kInputs][wide::kRows], out[wide::kOutputs][wide::kRows];
    for (int row = 0; row < wide::kRows; ++row) setRow(random, in, row);
    double rows[3][4];
    for (auto& each : rows) {
      for (double& m : each) m = random.uniform(-3, 3);
    }
    const Matrix matrix(rows);
    set.lanes.apply(formula, matrix, in, out);
    for (int row = 0; row < wide::kRows; ++row) {
      double one[wide::kInputs], expected[wide::kOutputs] = {};
      for (int k = 0; k < wide::kInputs; ++k) one[k] = in[k][row];
      wide::apply(formula, matrix, one, expected);
      exercised.numbers += expected[0] == expected[0];
      exercised.zeros += expected[0] == 0;
      exercised.ones += expected[0] == 1;
      exercised.others += expected[0] != 0 && expected[0] != 1 && expected[0] == expected[0];
      for (int k = 0; k < wide::kOutputs; ++k) {
        if (isSame(out[k][row], expected[k])) continue;
        std::string text = set.name + ", " + wide::kNames[formula] + ", result " +
                           std::to_string(k) + ": " + check::show(out[k][row]) + " for " +
                           check::show(expected[k]) + " of";
        for (double x : one) text += " " + check::show(x);
        return text;
      }
    }
  }
  return "";
}

}  // namespace

TEST("each lane of each formula has the bits of a double's, for numbers of all kinds") {
  for (const Set& set : sets()) {
    for (int formula = 0; formula < wide::kFormulas; ++formula) {
      Exercised exercised;
      CHECK_EQUAL(firstDifference(set, formula, 4000, exercised), "");
      // Of 32,000 rows a third at least give numbers, and decisions go both ways.
      CHECK(exercised.numbers > 10000);
      if (exercised.others == 0) CHECK(exercised.zeros > 1000 && exercised.ones > 1000);
    }
  }
}

TEST("lanes whose bits are set are packed together, for every set of bits") {
  double numbers[wide::kRows];
  std::uint16_t rows[wide::kRows];
  for (int k = 0; k < wide::kRows; ++k) {
    numbers[k] = k == 3 ? -0.0 : 1.5 * k;
    rows[k] = std::uint16_t(65535 - k);
  }
  for (const Set& set : sets()) {
    for (unsigned bits = 0; bits < 256; ++bits) {
      double packed[2 * wide::kRows];
      std::uint16_t packedRows[2 * wide::kRows];
      const int count = set.lanes.compress(numbers, rows, bits, packed, packedRows);
      int expected = 0;
      bool isGood = true;
      for (int k = 0; k < wide::kRows; ++k) {
        if ((bits >> k & 1) == 0) continue;
        isGood &= isSame(packed[expected], numbers[k]) && packedRows[expected] == rows[k];
        ++expected;
      }
      CHECK(isGood);
      CHECK_EQUAL(count, expected);
    }
  }
}

TEST("rows are gathered") {
  double column[300];
  for (int k = 0; k < 300; ++k) column[k] = k + 0.25;
  const std::uint16_t rows[] = {299, 0, 5, 5, 256, 17, 1, 255};
  for (const Set& set : sets()) {
    double gathered[wide::kRows];
    set.lanes.gather(column, rows, gathered);
    for (int k = 0; k < wide::kRows; ++k) CHECK_EQUAL(gathered[k], column[rows[k]]);
  }
}

TEST("a number that is the same in all lanes keeps its sign") {
  double zeros[lanes::kDoubles];
  lanes::Doubles(-0.0).store(zeros);
  for (double zero : zeros) CHECK(isSame(zero, -0.0));
}
