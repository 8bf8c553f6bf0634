// Numbers as people read them: the same text on every machine. Vectors are three numbers with
// blanks between; minus zero is 0.
#pragma once
#include <string>

#include "math/vec3.h"

/// The fewest digits that give the same float back.
std::string textOf(float number);
/// Up to 9 significant digits.
std::string textOf(double number);
std::string textOf(const Vec3f& vector);
std::string textOf(const Vec3d& vector);
