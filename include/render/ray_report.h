// The tree of one ray as text, and the numbers of all reports as people read them. The same text on
// every machine.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "math/vec3.h"
#include "render/watched_tracer.h"
#include "scene/object_places.h"

/// The fewest digits that give the same float back. Minus zero is 0; a NaN has no sign.
std::string textOf(float number);
/// Up to 9 significant digits.
std::string textOf(double number);
/// Three numbers with blanks between.
template <class T>
std::string textOf(const Vec3<T>& v) {
  return textOf(v.x()) + " " + textOf(v.y()) + " " + textOf(v.z());
}

/// An observer that writes the tree of rays as text: a line for each fact, in plain ASCII, two
/// blanks for each step down. `writeLine` takes one line after the other, each with its end.
/// The rays are traced as by `tracer`, whose scene was read with `places`; neither is owned.
std::unique_ptr<RayObserver> makeRayReport(const RayTracer& tracer, const ObjectPlaces& places,
                                           std::function<void(const std::string& line)> writeLine);
