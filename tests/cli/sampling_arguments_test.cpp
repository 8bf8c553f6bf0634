// The arguments about samples and filters, and runs of the program with them.
#include <iterator>
#include <sstream>

#include "cli/arguments.h"
#include "render/render_options.h"
#include "run_program.h"

namespace {

using Words = std::vector<std::string>;
using Pattern = SamplingOptions::Pattern;
using FilterKind = SamplingOptions::FilterKind;

Request parse(const std::string& words) {
  std::istringstream in("-input scene.txt -output out.tga " + words);
  return parseRequest(Words(std::istream_iterator<std::string>(in), {}));
}

SamplingOptions sampling(const std::string& words) {
  return parse(words).render.picture.render.sampling;
}

std::string mistake(const std::string& words) {
  try {
    parse(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A folder with scene.txt, where the program is run.
struct Desk : check::ScratchFolder {
  Desk() { write("scene.txt", check::smallScene()); }
  check::ProgramRun run(const std::string& arguments, const std::string& before = "") const {
    return check::runProgram("-input scene.txt " + arguments, path(), before);
  }
  std::string content(const std::string& name) const { return check::contentOf(file(name)); }
};

/// Bytes of a TGA of w x h pixels: 18 of the header and 3 for each pixel.
std::size_t tgaSize(std::size_t w, std::size_t h) { return 18 + 3 * w * h; }

}  // namespace

TEST("without arguments about samples a pixel is its centre") {
  CHECK(sampling("").isPlain());
  CHECK(sampling("-bounces 3 -shade_back").isPlain());
  CHECK(!sampling("-tent_filter 0.5").isPlain());
  CHECK(!sampling("-random_samples 1").isPlain());
}

TEST("patterns and filters are read, and the last of each counts") {
  CHECK(sampling("-random_samples 7").pattern == Pattern::random);
  CHECK(sampling("-uniform_samples 7").pattern == Pattern::uniform);
  CHECK(sampling("-jittered_samples 7").pattern == Pattern::jittered);
  CHECK_EQUAL(sampling("-jittered_samples 65536").samples, 65536);
  const SamplingOptions adaptive = sampling("-random_samples 9 -adaptive_samples 4 64 0.125");
  CHECK(adaptive.pattern == Pattern::adaptive);
  CHECK_EQUAL(adaptive.samples, 4);
  CHECK_EQUAL(adaptive.maxSamples, 64);
  CHECK_EQUAL(adaptive.tolerance, 0.125);
  CHECK(sampling("-adaptive_samples 4 64 0 -random_samples 9").pattern == Pattern::random);
  CHECK_EQUAL(sampling("-adaptive_samples 4 64 0 -random_samples 9").samples, 9);
  const SamplingOptions gaussian = sampling("-tent_filter 2 -box_filter 0.5 -gaussian_filter 0.4");
  CHECK(gaussian.filter == FilterKind::gaussian);
  CHECK_EQUAL(gaussian.filterSize, 0.4);
  CHECK(sampling("-gaussian_filter 1 -tent_filter 32").filter == FilterKind::tent);
  CHECK_EQUAL(sampling("-gaussian_filter 16 -tent_filter 1.5").filterSize, 1.5);
}

TEST("numbers beyond the limits are mistakes that name the argument and what was found") {
  for (const char* name : {"random", "uniform", "jittered"}) {
    for (const char* wrong : {"0", "-1", "65537", "2.5", "4x"}) {
      const std::string argument = std::string("-") + name + "_samples";
      const std::string message = mistake(argument + " " + wrong);
      CHECK(contains(message, argument + ": expected a whole number from 1 to 65536 for N"));
      CHECK(contains(message, std::string("found '") + wrong + "'"));
    }
  }
  CHECK(contains(mistake("-adaptive_samples 257 300 0"), "from 1 to 256 for MIN, found '257'"));
  CHECK(contains(mistake("-adaptive_samples 4 3 0"), "from 4 to 65536 for MAX, found '3'"));
  CHECK(contains(mistake("-adaptive_samples 4 8 1.5"), "0 to 1 for TOLERANCE, found '1.5'"));
  CHECK(contains(mistake("-adaptive_samples 4 8 -0.1"), "found '-0.1'"));
  for (const char* wrong : {"0", "-1", "32.1", "nan", "1e999", "1e-999"}) {
    CHECK(contains(mistake(std::string("-box_filter ") + wrong), "above 0 and up to 32"));
    CHECK(contains(mistake(std::string("-tent_filter ") + wrong), "above 0 and up to 32"));
    CHECK(contains(mistake(std::string("-gaussian_filter ") + wrong), "above 0 and up to 16"));
  }
  CHECK(contains(mistake("-render_samples a 0"), "from 1 to 65535 for ZOOM"));
  CHECK_EQUAL(mistake("-render_filter - 5"), "");
}

TEST("an enlarged picture must not be larger than any") {
  CHECK_EQUAL(mistake("-size 100 200 -render_samples a 327"), "");  // 65400
  CHECK_EQUAL(mistake("-render_samples a 327 -size 100 200"), "");
  CHECK(contains(mistake("-size 100 200 -render_samples a 328"), "a ZOOM of at most 327"));
  CHECK(contains(mistake("-render_samples a 328 -size 200 100"), "200 x 100 pixels, found '328'"));
  CHECK_EQUAL(mistake("-size 1 1 -render_filter a 65534"), "");  // and one line more
  CHECK(contains(mistake("-size 1 1 -render_filter a 65535"), "a ZOOM of at most 65534"));
  CHECK(contains(mistake("-size 65535 1 -render_filter a 1"), "a ZOOM of at most 0"));
}

TEST("pictures of samples and of the filter stand alone") {
  const Desk desk;
  const auto samples = desk.run("-size 9 9 -render_samples s.tga 20 -jittered_samples 4");
  CHECK_EQUAL(samples.status, 0);
  CHECK_EQUAL(samples.errors + samples.output, "");
  CHECK_EQUAL(desk.content("s.tga").size(), tgaSize(180, 180));
  CHECK_EQUAL(desk.run("-size 9 7 -render_filter f.tga 20 -gaussian_filter 0.8").status, 0);
  CHECK_EQUAL(desk.content("f.tga").size(), tgaSize(181, 141));
  CHECK_EQUAL(desk.fileCount(), 3u);
  CHECK_EQUAL(desk.run("-render_filter f.tga 2 -stats").status, 0);
}

TEST("all pictures come from one run and are the ones of single runs") {
  const Desk desk;
  const std::string how = "-size 30 20 -random_samples 5 -tent_filter 1 ";
  CHECK_EQUAL(desk.run(how + "-output a -render_samples b 3 -render_filter c 4 -normals d").status,
              0);
  CHECK_EQUAL(desk.run(how + "-output e -threads 1").status, 0);
  CHECK_EQUAL(desk.run(how + "-render_samples f 3 -threads 3 -accel tree").status, 0);
  CHECK_EQUAL(desk.run(how + "-render_filter g 4").status, 0);
  CHECK_EQUAL(desk.run("-size 30 20 -normals h").status, 0);
  for (const char* pair : {"ae", "bf", "cg", "dh"})
    CHECK(desk.content({pair[0]}) == desk.content({pair[1]}));
  CHECK_EQUAL(desk.run("-size 30 20 -output i").status, 0);
  CHECK(desk.content("a") != desk.content("i"));
}

TEST("numbers that are rounded up are told, unless -quiet") {
  const Desk desk;
  CHECK_EQUAL(desk.run("-size 5 5 -output a -jittered_samples 5").errors,
              "raytracer: warning: -jittered_samples 5: rounded up to 9, a square\n");
  CHECK_EQUAL(desk.run("-size 5 5 -output a -uniform_samples 2").errors,
              "raytracer: warning: -uniform_samples 2: rounded up to 4, a square\n");
  CHECK_EQUAL(desk.run("-size 5 5 -output a -adaptive_samples 4 20 0.1").errors,
              "raytracer: warning: -adaptive_samples 4 20: rounded up to 4 and 64, a square and "
              "this times a power of 4\n");
  for (const char* silent : {"-quiet -uniform_samples 2", "-uniform_samples 16",
                             "-random_samples 5", "-adaptive_samples 4 64 0.1", "-tent_filter 1"})
    CHECK_EQUAL(desk.run(std::string("-size 5 5 -output a ") + silent).errors, "");
}

TEST("two arguments must not name the same file, pictures of samples and filters included") {
  const Desk desk;
  for (const char* clash : {"-render_samples scene.txt 2", "-render_filter scene.txt 2",
                            "-render_samples a 2 -render_filter ./a 2"})
    CHECK_EQUAL(desk.run(clash).status, 2);
  CHECK_EQUAL(desk.content("scene.txt"), check::smallScene());
}

TEST("a signal ends a run with many samples in a pixel") {
  const Desk desk;
  for (const char* many : {"-random_samples 65536", "-adaptive_samples 256 65536 0"}) {
    const auto run = desk.run(std::string("-size 4000 4000 -output out.tga ") + many,
                              "timeout --preserve-status -s TERM 0.2");
    CHECK(run.status > 128);
    CHECK_EQUAL(desk.fileCount(), 1u);
  }
}

TEST("memory does not grow with the number of samples") {
  const Desk desk;
  const std::string limit = "ulimit -v 30000;";
  if (desk.run("-size 5 5 -output a", limit).status != 0) SKIP("so little memory is not enough");
  // 40 x 40 pixels with 2000 samples of 12 bytes each would be 38 megabytes; 30 are allowed.
  std::string nothing = check::smallScene();
  nothing.replace(nothing.find("0 0 0 radius 1"), 14, "0 99 0 radius 1");
  desk.write("scene.txt", nothing);
  const auto run =
      desk.run("-size 40 40 -threads 1 -random_samples 2000 -tent_filter 2 -output a", limit);
  CHECK_EQUAL(run.errors, "");
  CHECK_EQUAL(run.status, 0);
}
