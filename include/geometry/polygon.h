// Polygon: cuts a flat outline of any shape into triangles.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "math/vec3.h"

/// The corners of a triangle, as places in the outline.
using OutlineTriangle = std::array<std::uint32_t, 3>;

/// What an outline is.
enum class OutlineShape {
  convex,   ///< it turns one way all around, or has no area
  concave,  ///< it can be cut, see below
  crossing  ///< it crosses itself
};

/// Cuts the polygon with these corners (at least 3), which lie in a plane or nearly, into
/// corners.size() - 2 triangles that cover it once and turn as it does. Corners may be repeated and
/// lie on lines between others, and the outline may touch itself, as where a slit joins that of a
/// hole to the one around it. What is covered does not depend on the corner that comes first.
/// Everything is decided exactly, in the coordinate plane that the polygon is least slanted to.
/// `triangles` is set where the result is `concave`: of the others none is found better than the
/// fan around the first corner. Takes time n^2 for n corners, mostly far less.
OutlineShape cutOutline(const std::vector<Vec3f>& corners, std::vector<OutlineTriangle>& triangles);
