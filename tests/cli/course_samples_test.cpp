// Pixels and samples by course: where rays go, -jitter and -filter, names of patterns; what depths,
// normals and names without endings become.
#include <cmath>
#include <iterator>
#include <limits>

#include "check.h"
#include "cli/command_words.h"
#include "image/picture_file.h"
#include "render/sampler.h"
#include "vectors.h"

using check::contains, check::Desk, check::mistake, check::parse, check::split;

namespace {

using Pattern = SamplingOptions::Pattern;

RenderOptions optionsOf(const std::string& words) {
  return parse(split(words)).render.picture.render;
}

/// Of the first ray that -pixel prints.
Vec3d directionOf(const Desk& desk, const std::string& words) {
  const std::string text = desk.run("-input scene.txt -pixel " + words).output;
  double x = 0, y = 0, z = 0;
  std::sscanf(text.c_str() + text.find("direction"), "direction %lf %lf %lf", &x, &y, &z);
  return {x, y, z};
}

/// A ball before a camera of 90 degrees that looks along -z.
std::string ballBefore(const std::string& sphere) {
  return "PerspectiveCamera { center 0 0 0 direction 0 0 -1 up 0 1 0 angle 90 }\n"
         "Background { color 0.5 0.5 0.5 ambientLight 1 1 1 }\n"
         "Materials { numMaterials 1 Material { diffuseColor 0.25 0.5 1 } }\n"
         "Group { numObjects 1 MaterialIndex 0 Sphere { " +
         sphere + " } }\n";
}

}  // namespace

TEST("each course sends the ray of the top left pixel of 8 x 4 where its pages do") {
  const Desk desk;
  desk.write("scene.txt", ballBefore("center 0 0 9 radius 1"));
  // With 90 degrees -1 to 1 are the tangents. Row 0 from the top is row 3 from the bottom.
  const struct {
    const char* course;
    double x, y;
  } cases[] = {{"2003", -7.0 / 8, 3.0 / 8},
               {"2004", -7.0 / 8, 3.0 / 8},
               {"2012", -1, 1},
               {"2016", -1, 1},
               {"aalto", -7.0 / 4, 3.0 / 4}};
  for (const auto& [course, x, y] : cases) {
    const Vec3d found = directionOf(desk, std::string("0 0 -size 8 4 -course ") + course);
    check::report(length(found * (-1 / found.z()) - Vec3d(x, y, -1)) < 1e-8, __FILE__, __LINE__,
                  std::string(course) + ": " + check::show(found));
  }
  // thu: 2 i / W - 1, with i = 0 and j = 3.
  const RenderOptions thu = optionsOf("-course thu");
  CHECK(thu.places.unit == PixelPlaces::Unit::bothSides);
  CHECK_EQUAL(thu.places.inset, 0.0);
  CHECK_EQUAL(thu.places.shift, 0.5);
}

TEST("-jitter is one sample in each of nine cells, around their middles") {
  const RenderOptions options = optionsOf("-course 2012 -jitter");
  CHECK(options.sampling.pattern == Pattern::jittered);
  CHECK_NEAR(options.places.inset, 1 / 3.0, 1e-16);
  const Sampler sampler(options.sampling);
  CHECK_EQUAL(sampler.getNumSamples(), 9);
  double sumX = 0, sumY = 0;
  bool areInCells = true;
  for (int pixel = 0; pixel < 64 * 64; ++pixel) {
    for (int n = 0; n < 9; ++n) {
      // From the middle of the cell, in cells.
      const Vec2d offset = sampler.getSamplePosition(pixel % 64, pixel / 64, n);
      const double x = offset.x() * 3 - (n % 3 + 0.5), y = offset.y() * 3 - (n / 3 + 0.5);
      areInCells = areInCells && std::fabs(x) <= 0.5 && std::fabs(y) <= 0.5;
      sumX += x;
      sumY += y;
    }
  }
  CHECK(areInCells);
  // The mean of 36864 has a deviation of sqrt(1/12 / 36864) = 0.0015.
  CHECK_NEAR(sumX / (64 * 64 * 9), 0, 0.006);
  CHECK_NEAR(sumY / (64 * 64 * 9), 0, 0.006);
}

TEST("-jitter and -filter belong to some courses, and stand for all samples and filters") {
  for (const char* course : {"2012", "2016", "2020"}) {
    const std::string words = std::string("-course ") + course + " -jitter";
    CHECK(optionsOf(words).sampling.filter == SamplingOptions::FilterKind::box);
    CHECK(optionsOf(words + " -filter").sampling.filter ==
          SamplingOptions::FilterKind::blurredCells);
    CHECK(optionsOf("-filter " + words).sampling.pattern == Pattern::jittered);
  }
  for (const char* course : {"2003", "2004", "thu", "aalto"}) {
    for (const char* argument : {"-jitter", "-filter"}) {
      CHECK_EQUAL(mistake({argument, "-course", course}),
                  std::string(argument) +
                      ": expected -course 2012, 2016 or 2020 too, found the course of " + course);
    }
  }
  for (const char* other : {"-random_samples 9", "-uniform_samples 1", "-jittered_samples 9",
                            "-adaptive_samples 4 16 0.1", "-tent_filter 1"}) {
    CHECK(contains(mistake(split(std::string("-course 2012 -jitter ") + other)),
                   "-jitter cannot be given together with other samples or filters"));
  }
  // A whole name is needed: none is short for another.
  CHECK(optionsOf("-course 2012 -jittered_samples 4").sampling.samples == 4);
  // The row that holds where there are bounces has them too.
  CHECK(optionsOf("-course 2012 -jitter -bounces 2").sampling.samples == 9);
}

TEST("-filter without -jitter filters nothing and says so in a line") {
  const Desk desk;
  const std::string run = "-input scene.txt -size 9 9 -course 2012 -output ";
  const check::ProgramRun filtered = desk.run(run + "a.tga -filter -tent_filter 1");
  CHECK_EQUAL(filtered.errors,
              "raytracer: note: nothing is filtered: -filter without -jitter has no effect\n");
  CHECK_EQUAL(desk.run(run + "b.tga -tent_filter 1").errors, "");
  CHECK(check::contentOf(desk.file("a.tga")) == check::contentOf(desk.file("b.tga")));
}

TEST("-jitter and -filter give one picture in any parts, threads and instruction sets") {
  const Desk desk;
  const std::string common = "-input scene.txt -quiet -course 2012 -size 37 29 -shadows -jitter";
  for (const char* filter : {"", " -filter"}) {
    const std::string run = common + filter;
    CHECK_EQUAL(desk.run(run + " -output whole.tga -threads 3").status, 0);
    const std::string whole = check::contentOf(desk.file("whole.tga"));
    for (const char* way : {" -threads 1", " -accel tree", " -grid 5 5 5", " -simd baseline",
                            " -simd avx2", " -simd avx512 -threads 16"}) {
      CHECK_EQUAL(desk.run(run + way + " -output other.tga").status, 0);
      CHECK(check::contentOf(desk.file("other.tga")) == whole);
    }
    CHECK_EQUAL(desk.run(run + " -output a.tga -region 0 0 20 29").status, 0);
    CHECK_EQUAL(desk.run(run + " -output b.tga -region 20 0 17 29").status, 0);
    CHECK_EQUAL(desk.run("-merge merged.tga a.tga b.tga").status, 0);
    CHECK(check::contentOf(desk.file("merged.tga")) == whole);
  }
}

TEST("what is of one colour stays so under -jitter and -filter, up to the border") {
  const Desk desk;
  desk.write("scene.txt", ballBefore("center 0 0 9 radius 1"));
  CHECK_EQUAL(
      desk.run("-input scene.txt -course 2016 -size 5 4 -jitter -filter -output a.pfm").status, 0);
  FloatImage exact;
  readImage(desk.file("a.pfm"), &exact);
  for (int k = 0; k < 20; ++k) CHECK_NEAR(exact.getPixel(k % 5, k / 5).r(), 0.5, 1e-6);
}

TEST("aalto's -uniform_samples are random, and -regular_samples a grid in any course") {
  CHECK(optionsOf("-course aalto -uniform_samples 5").sampling.pattern == Pattern::random);
  CHECK(optionsOf("-uniform_samples 5 -course aalto").sampling.pattern == Pattern::random);
  for (const char* words : {"-course aalto -regular_samples 4", "-regular_samples 4",
                            "-uniform_samples 4", "-course 2012 -uniform_samples 4"}) {
    CHECK(optionsOf(words).sampling.pattern == Pattern::uniform);
    CHECK_EQUAL(optionsOf(words).sampling.samples, 4);
  }
  const Desk desk;
  const std::string run = "-input scene.txt -size 5 5 -output a.tga ";
  CHECK_EQUAL(desk.run(run + "-course aalto -regular_samples 2").errors,
              "raytracer: warning: -regular_samples 2: rounded up to 4, a square\n");
  CHECK_EQUAL(desk.run(run + "-course aalto -uniform_samples 2").errors, "");
}

TEST("depth is black at MIN and normals are (n + 1) / 2 in 2016, but not in the others") {
  const Desk desk;
  // The middle pixel of 3 x 3 meets the ball at t = 4 with the normal (0, 0, 1).
  desk.write("scene.txt", ballBefore("center 0 0 -5 radius 1"));
  for (const bool is2016 : {true, false}) {
    for (const char* ending : {"tga", "pfm"}) {
      const std::string run = std::string("-input scene.txt -size 3 3 -depth 2 12 d.") + ending +
                              " -normals n." + ending + " -course ";
      CHECK_EQUAL(desk.run(run + (is2016 ? "2016" : "2012")).status, 0);
    }
    FloatImage depth, normals;
    const Image depthBytes = readImage(desk.file("d.tga"));
    const Image normalBytes = readImage(desk.file("n.tga"));
    readImage(desk.file("d.pfm"), &depth);
    readImage(desk.file("n.pfm"), &normals);
    // (4 - 2) / 10, or (12 - 4) / 10; times 255 these are 51 and 204 but for rounding.
    CHECK_NEAR(depth.getPixel(1, 1).r(), is2016 ? 0.2 : 0.8, 1e-6);
    CHECK_NEAR(depthBytes.getPixel(1, 1).r, is2016 ? 51 : 204, 1);
    CHECK_EQUAL(depth.getPixel(0, 0).r(),
                (is2016 ? 1 : -1) * std::numeric_limits<float>::infinity());
    CHECK_EQUAL(int(depthBytes.getPixel(0, 0).r), 0);
    CHECK_EQUAL(normals.getPixel(1, 1), is2016 ? Vec3f(0.5f, 0.5f, 1) : Vec3f(0, 0, 1));
    CHECK_EQUAL(normals.getPixel(0, 0), is2016 ? Vec3f(0.5f, 0.5f, 0.5f) : Vec3f());
    CHECK_EQUAL(int(normalBytes.getPixel(0, 0).g), is2016 ? 127 : 0);
  }
}

TEST("a name without an ending is a picture of the course's format, but a part a TGA") {
  const Desk desk;
  const std::string run = "-input scene.txt -size 3 3 -output out -normals n. -course ";
  const struct {
    const char* course;
    std::string start;
  } cases[] = {{"2003", std::string(2, '\0')},
               {"2004", std::string(2, '\0')},
               {"2012", "BM"},
               {"2016", "\x89PNG"},
               {"aalto", "\x89PNG"}};
  for (const auto& [course, start] : cases) {
    CHECK_EQUAL(desk.run(run + course).status, 0);
    for (const char* name : {"out", "n."}) {
      CHECK_EQUAL(check::contentOf(desk.file(name)).substr(0, start.size()), start);
    }
  }
  CHECK_EQUAL(desk.run("-input scene.txt -size 3 3 -course 2012 -output a.png").status, 0);
  CHECK_EQUAL(check::contentOf(desk.file("a.png")).substr(1, 3), "PNG");
  CHECK_EQUAL(courseAt(std::size(kCourseNames) - 2).name, "thu");
  CHECK(courseAt(std::size(kCourseNames) - 2).format == PictureFormat::bmp);
  CHECK(contains(mistake(split("-course 2016 -output a.jpg")), "without ending or with one of"));
  for (const char* part : {"1", "2"}) {
    CHECK_EQUAL(desk.run(run + "2016 -tile " + part + " 2 -output p" + part).status, 0);
  }
  CHECK_EQUAL(desk.run("-merge whole.png p1 p2").status, 0);
  CHECK_EQUAL(desk.run(run + "2016").status, 0);
  CHECK(check::contentOf(desk.file("whole.png")) == check::contentOf(desk.file("out")));
}
