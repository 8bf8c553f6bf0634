// Transmittance: how much of a light comes through the transparent objects in its way.
#pragma once
#include "geometry/object3d.h"
#include "math/vec3.h"

/// The factor by which the light of a source at parameter `distance` (perhaps infinity) of the unit
/// shadow ray is tinted and dimmed. Black where an opaque surface lies at epsilon < t < distance.
/// Each closed transparent object multiplies on its own by transparentColor^length, length being
/// what the light travels inside it in world units; an open transparent surface multiplies by its
/// colour once for each crossing at epsilon < t < distance. Light does not bend.
Vec3f transmittance(const Object3D& geometry, const Ray& ray, double epsilon, double distance);
