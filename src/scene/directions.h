// Directions as scene files give them: of any length, however small or large.
#pragma once
#include "math/vec3.h"

/// `vector` times the power of two that brings its largest component into [1/2, 1): the same
/// direction exactly, and its squares neither overflow nor vanish. The zero vector stays zero.
Vec3d rescaled(const Vec3d& vector);

/// True when the two are parallel as far as decimal numbers can tell: the sine of the angle
/// between them is below 1e-14, some 50 times the rounding error of the test. Neither may be zero.
bool areParallel(const Vec3d& a, const Vec3d& b);
