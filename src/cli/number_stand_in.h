// Numbers that fill a whole word.
#pragma once
#include <cmath>
#include <cstdlib>
#include <string>

inline bool readDouble(const std::string& word, double& value) {
  if (word.empty() || word.find_first_not_of("+-.0123456789eE") != std::string::npos) return false;
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return *end == '\0' && std::isfinite(value);
}
inline bool readFloat(const std::string& word, float& value) {
  if (word.empty() || word.find_first_not_of("+-.0123456789eE") != std::string::npos) return false;
  char* end = nullptr;
  value = std::strtof(word.c_str(), &end);
  return *end == '\0' && std::isfinite(value);
}
inline bool readInt(const std::string& word, int& value) {
  double number = 0;
  if (word.find_first_not_of("+-0123456789") != std::string::npos) return false;
  if (!readDouble(word, number) || std::fabs(number) > 2147483647.0) return false;
  value = int(number);
  return true;
}
