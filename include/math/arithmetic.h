// Refuses to compile where float and double are not IEC 60559 numbers, rounded after every
// operation.
//
// The image is the same bytes on every machine because + - * / and sqrt are exact to the last bit
// there. A compiler told to be quicker than that (-ffast-math and its parts), or one that keeps
// more digits than a type has (x87: -m32 without -msse2 -mfpmath=sse), draws other pictures, so it
// draws none. That products are not fused with sums (-ffp-contract=off, given in CMakeLists.txt) no
// macro tells; tests/math/arithmetic_test.cpp looks at what the program computes.
#pragma once
#include <cfloat>
#include <limits>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "the image would depend on the compiler: build without -ffast-math and without its parts"
#endif

static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<float>::digits == 24 &&
                  std::numeric_limits<double>::is_iec559 &&
                  std::numeric_limits<double>::digits == 53,
              "float and double must be IEC 60559 (IEEE 754) binary32 and binary64");
static_assert(FLT_EVAL_METHOD == 0,
              "sums and products must be rounded to their own type (for x87: -mfpmath=sse -msse2)");
static_assert(sizeof(1.0) == sizeof(double), "build without -fsingle-precision-constant");
