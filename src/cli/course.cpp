// The courses, one function that fills in each row: what it does not mention is as in 2003.
// Sources: MIT 6.837, "Introduction to Computer Graphics", assignments of 2003 and 2004.
#include "cli/course.h"

#include <limits>

namespace {

Course course2003() {
  Course course;
  course.name = kCourseNames[0];
  course.cells.paints = {
      {1, {1, 1, 1}},          {2, {0.6f, 0.3f, 0.9f}},  {3, {0.2f, 0.3f, 1}},
      {4, {0.2f, 0.8f, 0.9f}}, {8, {0.2f, 0.8f, 0.2f}},  {16, {1, 0.9f, 0.1f}},
      {32, {1, 0.5f, 0.1f}},   {33, {0.9f, 0.1f, 0.1f}},
  };
  return course;
}

Course course2004() {
  Course course;
  course.name = kCourseNames[1];

  RenderOptions& render = course.render;
  render.maxBounces = 0;
  render.minWeight = 0;
  render.shadows = false;
  render.darkBacks = true;
  render.epsilon = {Epsilon::Kind::fixed, Epsilon::kCourse};
  SamplingOptions& sampling = render.sampling;
  sampling.numbers = SamplingOptions::Numbers::sequence;
  sampling.isGridExact = true;
  sampling.gaussianCut = std::numeric_limits<double>::infinity();
  sampling.isFilterSingle = true;
  sampling.hasBorderSamples = false;

  course.scene.isHighlightHalfway = true;
  course.scene.noiseSlope = -1;
  course.scene.marbleHeight = -1;
  course.scene.isWoodGrained = true;

  course.cells.areTouched = true;
  course.cells.alwaysCounts = true;
  course.cells.haveShadows = false;
  // From white over violet, blue, green and yellow to red.
  course.cells.paints = {
      {1, {1, 1, 1}},     {2, {1, 0, 1}},     {3, {0.7f, 0, 1}},  {4, {0.3f, 0, 1}},
      {5, {0, 0, 1}},     {6, {0, 0.3f, 1}},  {7, {0, 0.7f, 1}},  {8, {0, 1, 1}},
      {9, {0, 1, 0.7f}},  {10, {0, 1, 0.3f}}, {11, {0, 1, 0}},    {12, {0.3f, 1, 0}},
      {13, {0.7f, 1, 0}}, {14, {1, 1, 0}},    {15, {1, 0.7f, 0}}, {16, {1, 0.3f, 0}},
      {17, {1, 0, 0}},
  };
  course.hasWindows = true;
  return course;
}

}  // namespace

const Course& courseAt(std::size_t place) {
  static const Course kCourses[] = {course2003(), course2004()};
  return kCourses[place];
}
