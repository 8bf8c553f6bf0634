// Numbers by printf, which rounds correctly.
#include "render/number_text.h"

#include <cstdio>
#include <cstdlib>

namespace {

constexpr int kFewestDigits = 1, kMostDigits = 9;  // 9 tell any two floats apart

std::string printed(double number, int digits) {
  if (number != number) return "nan";  // printf may give it a sign
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, number == 0 ? 0.0 : number);
  return text;
}

}  // namespace

std::string textOf(float number) {
  int digits = kFewestDigits;
  while (digits < kMostDigits &&
         std::strtof(printed(double(number), digits).c_str(), nullptr) != number) {
    ++digits;
  }
  return printed(double(number), digits);
}

std::string textOf(double number) { return printed(number, kMostDigits); }

std::string textOf(const Vec3f& v) {
  return textOf(v.x()) + " " + textOf(v.y()) + " " + textOf(v.z());
}

std::string textOf(const Vec3d& v) {
  return textOf(v.x()) + " " + textOf(v.y()) + " " + textOf(v.z());
}
