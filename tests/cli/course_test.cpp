// -course: defaults, which arguments win over, the rules that come with it, and messages.
#include "cli/course.h"

#include "check.h"
#include "cli/command_words.h"
#include "run_program.h"

using check::contains, check::Desk, check::mistake, check::parse, check::split;

namespace {

const RenderOptions& optionsOf(const Request& request) { return request.render.picture.render; }

RenderOptions optionsOf(const std::string& words) { return optionsOf(parse(split(words))); }

}  // namespace

TEST("without -course, and with -course 2003, everything is as in 2003") {
  for (const char* words : {"", "-course 2003", "-course 2004 -course 2003"}) {
    const Request request = parse(split(words));
    const RenderOptions& options = optionsOf(request);
    CHECK(options.shadows && !options.darkBacks);
    CHECK_EQUAL(options.maxBounces, 5);
    CHECK_EQUAL(options.minWeight, 0.01f);
    CHECK(options.epsilon.kind == Epsilon::Kind::automatic);
    CHECK(options.sampling.numbers == SamplingOptions::Numbers::hashed);
    CHECK(options.sampling.hasBorderSamples && options.sampling.gaussianCut == 2);
    CHECK(!request.render.picture.rules.isHighlightHalfway);
    CHECK_EQUAL(request.render.picture.rules.noiseSlope, 0.5);
  }
}

TEST("-course 2004 brings its defaults and rules") {
  const Request request = parse({"-course", "2004"});
  const RenderOptions& options = optionsOf(request);
  CHECK(!options.shadows && options.darkBacks);
  CHECK_EQUAL(options.maxBounces, 0);
  CHECK_EQUAL(options.minWeight, 0.0f);
  CHECK(options.epsilon.kind == Epsilon::Kind::fixed && options.epsilon.value == 0.001);
  CHECK(options.sampling.numbers == SamplingOptions::Numbers::sequence);
  CHECK(!options.sampling.hasBorderSamples && options.sampling.gaussianCut > 1e300);
  const SceneRules& rules = request.render.picture.rules;
  CHECK(rules.isHighlightHalfway && !rules.areHighlightsDimmed && rules.isWoodGrained);
  CHECK_EQUAL(request.render.picture.course->cells.paints.size(), std::size_t(17));
}

TEST("an explicit argument wins over the course's default, before it and behind it") {
  for (const char* words :
       {"-course 2004 -bounces 3 -weight 0.1 -shadows -epsilon adaptive",
        "-bounces 3 -weight 0.1 -shadows -epsilon adaptive --course 2004",
        "-course 2003 -bounces 3 -weight 0.1 -shadows -epsilon adaptive -course 2004"}) {
    const RenderOptions options = optionsOf(words);
    CHECK_EQUAL(options.maxBounces, 3);
    CHECK_EQUAL(options.minWeight, 0.1f);
    CHECK(options.shadows && options.darkBacks);
    CHECK(options.epsilon.kind == Epsilon::Kind::adaptive);
  }
  CHECK(parse({"-specular_fix"}).render.picture.rules.areHighlightsDimmed);
  CHECK(parse({"-specular_fix", "-course", "2004"}).render.picture.rules.areHighlightsDimmed);
}

TEST("a wrong or missing name of a course lists the courses") {
  CHECK_EQUAL(mistake({"-course", "1999"}), "-course: expected 2003 or 2004, found '1999'");
  CHECK_EQUAL(mistake({"-course"}), "-course: expected 2003|2004, found the end of the command");
  CHECK_EQUAL(mistake({"-course", "-size", "3", "4"}),
              "-course: expected 2003|2004, found '-size'");
}

TEST("the window arguments of the pages are taken where the course has them, and said to be idle") {
  CHECK(mistake(split("-course 2004 -gui -gouraud -tessellation 20 10")).empty());
  CHECK(contains(mistake({"-gui"}), "-gui: expected -course 2004 too"));
  CHECK(contains(mistake({"-course", "2004", "-tessellation", "20"}), "expected A B"));
  CHECK(contains(mistake(split("-course 2004 -tessellation 20 x")), "for B, found 'x'"));
  const Desk desk;
  const check::ProgramRun run =
      desk.run("-input scene.txt -output out.tga -size 3 3 -course 2004 -gui -tessellation 9 9");
  CHECK_EQUAL(run.status, 0);
  CHECK(contains(run.errors, "-gui, -tessellation"));
  CHECK_EQUAL(std::count(run.errors.begin(), run.errors.end(), '\n'), 1);
}

TEST("the cells of a grid are always counted in 2004, and have no shadows") {
  const Request request = parse(split("-course 2004 -shadows -grid 4 4 4 -visualize_grid"));
  CHECK(!optionsOf(request).shadows);
  const Desk desk;
  desk.write("two.txt",
             check::smallScene() + "Group { numObjects 1 Sphere { center 0 0 0 radius 1 } }");
  const std::string run = "-input two.txt -size 20 20 -grid 3 3 3 -course 2004";
  CHECK_EQUAL(desk.run(run + " -visualize_grid -output a.tga").status, 0);
  CHECK_EQUAL(desk.run(run + " -visualize_grid_count -output b.tga").status, 0);
  CHECK(check::contentOf(desk.file("a.tga")) == check::contentOf(desk.file("b.tga")));
}

TEST("tiles, threads and instruction sets give one picture, drawn numbers or not") {
  const Desk desk;
  const std::string common =
      "-input scene.txt -course 2004 -size 37 29 -shadows -bounces 3 -gaussian_filter 0.6";
  for (const char* samples :
       {" -random_samples 3", " -jittered_samples 4", " -uniform_samples 9"}) {
    const std::string run = common + samples;
    CHECK_EQUAL(desk.run(run + " -output whole.tga -threads 3").status, 0);
    const std::string whole = check::contentOf(desk.file("whole.tga"));
    for (const char* way : {" -threads 1", " -accel tree", " -grid 5 5 5", " -simd baseline",
                            " -simd avx2", " -simd avx512 -threads 16"}) {
      CHECK_EQUAL(desk.run(run + way + " -quiet -output other.tga").status, 0);
      CHECK(check::contentOf(desk.file("other.tga")) == whole);
    }
    CHECK_EQUAL(desk.run(run + " -output a.tga -tile 1 2").status, 0);
    CHECK_EQUAL(desk.run(run + " -output b.tga -tile 2 2").status, 0);
    CHECK_EQUAL(desk.run("-merge merged.tga a.tga b.tga").status, 0);
    CHECK(check::contentOf(desk.file("merged.tga")) == whole);
  }
}

TEST("parts of different courses are not put together") {
  const Desk desk;
  CHECK_EQUAL(desk.run("-input scene.txt -size 9 8 -output a.tga -tile 1 2").status, 0);
  CHECK_EQUAL(desk.run("-input scene.txt -size 9 8 -output b.tga -tile 2 2 -course 2004").status,
              0);
  CHECK_EQUAL(desk.run("-merge out.tga a.tga b.tga").status, 3);
}
