// The courses, one function that fills in each row: what it does not mention is as in 2003.
// Sources: MIT 6.837, "Introduction to Computer Graphics", assignments of 2003, 2004, 2012 and 2016
// to 2020; the courses of Tsinghua University (thu) and Aalto University (aalto) that follow it.
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
  render.backs = RenderOptions::Backs::nothing;
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

/// What the years from 2012 on have in common: one ray a pixel, and nothing more unless it is asked
/// for.
Course laterCourse(std::string_view name, Language language) {
  Course course = course2003();
  course.name = name;
  course.render.maxBounces = 0;
  course.render.minWeight = 0;
  course.render.shadows = false;
  course.render.epsilon = {Epsilon::Kind::fixed, Epsilon::kCourse};
  course.render.places.unit = PixelPlaces::Unit::bothSides;
  course.render.places.inset = 1;
  course.scene.language = language;
  course.scene.areHighlightsEverywhere = true;
  course.format = PictureFormat::bmp;
  course.hasJitter = true;
  return course;
}

/// The words of 2012: meshes are smooth and may have a picture on them.
Course course2012() {
  Course course = laterCourse(kCourseNames[2], Language::of2012);
  course.scene.meshNormals = MeshNormals::byArea;
  course.scene.keepsTextureCoordinates = true;
  return course;
}

/// Assignment 5 of 2012: colours of secondary rays in place of highlights.
Course rayTracing2012() {
  Course course = course2012();
  course.render.maxBounces = 4;
  course.render.blendsGlass = true;
  course.render.isAmbientPlain = true;
  course.scene.areHighlightsEverywhere = false;
  course.scene.haveHighlights = false;
  course.scene.leastMirror = 0.001f;
  course.scene.mostFlatVertices = 120;
  return course;
}

/// Assignment 4 of 2012: ray casting.
Course rayCasting2012(const Course& withBounces) {
  Course course = course2012();
  course.withBounces = &withBounces;
  return course;
}

Course course2016() {
  Course course = laterCourse(kCourseNames[3], Language::of2016);
  course.render.epsilon.value = 0.01;
  course.scene.cubeMapEnding = "png";
  course.scene.cameraUp = SceneRules::CameraUp::asWritten;
  course.scene.nearFalloff = 0;
  course.scene.meshNormals = MeshNormals::equal;
  course.scene.leastMirror = 0;
  course.format = PictureFormat::png;
  course.isNearBlack = true;
  course.hasSignedNormals = true;
  return course;
}

Course course2020() {
  Course course = course2016();
  course.name = kCourseNames[4];
  course.scene.language = Language::of2020;
  course.scene.cameraUp = SceneRules::CameraUp::unit;
  course.scene.meshNormals = MeshNormals::byArea;
  course.scene.usesFileNormals = true;
  return course;
}

Course courseThu() {
  Course course = laterCourse(kCourseNames[5], Language::ofThu);
  course.render.places.inset = 0;
  course.render.places.shift = 0.5;
  course.scene.cameraUp = SceneRules::CameraUp::unscaled;
  course.hasBareFiles = true;
  course.hasJitter = false;
  return course;
}

Course courseAalto() {
  Course course = laterCourse(kCourseNames[6], Language::of2003);
  course.render.minWeight = 0.1f;
  course.render.backs = RenderOptions::Backs::ambient;
  course.render.places = {};
  course.render.places.unit = PixelPlaces::Unit::height;
  course.scene.areHighlightsEverywhere = false;
  course.format = PictureFormat::png;
  course.hasJitter = false;
  course.uniformSamples = SamplingOptions::Pattern::random;
  return course;
}

}  // namespace

const Course& courseAt(std::size_t number) {
  static const Course kRayTracing2012 = rayTracing2012();
  static const Course kCourses[] = {course2003(), course2004(), rayCasting2012(kRayTracing2012),
                                    course2016(), course2020(), courseThu(),
                                    courseAalto()};
  return kCourses[number];
}
