// Transmittance: how much of a light comes through the transparent objects in its way.
#pragma once
#include "geometry/object3d.h"
#include "math/vec3.h"

/// The factor by which the light of a source at parameter `distance` (perhaps infinity) of the unit
/// shadow ray is tinted and dimmed. Black where an opaque surface lies at epsilon < t < distance.
/// Each closed transparent object multiplies on its own by transparentColor^length, length being
/// what the light travels inside it in world units; an open transparent surface multiplies by its
/// colour once for each crossing at epsilon < t < distance. Light does not bend.
/// Of a solid texture the colour is the mean of its parts' at the point where the light enters the
/// object (or leaves it, if it is an open surface, or the lamp is inside); where that is black the
/// surface is opaque.
Vec3f transmittance(const Object3D& geometry, const Ray& ray, double epsilon, double distance);

/// transparentColor at a point of the world; of a texture the mean of its parts' colours there.
Vec3f transparencyAt(const Material& material, const Vec3d& point);

/// transparentColor^length in each component, negative ones taken as 0; length >= 0.
Vec3f absorption(const Vec3f& transparentColor, double length);
