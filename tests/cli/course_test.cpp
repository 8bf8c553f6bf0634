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
    CHECK(options.shadows && options.backs == RenderOptions::Backs::litAsFront);
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
  CHECK(!options.shadows && options.backs == RenderOptions::Backs::nothing);
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
    CHECK(options.shadows && options.backs == RenderOptions::Backs::nothing);
    CHECK(options.epsilon.kind == Epsilon::Kind::adaptive);
  }
  CHECK(parse({"-specular_fix"}).render.picture.rules.areHighlightsDimmed);
  CHECK(parse({"-specular_fix", "-course", "2004"}).render.picture.rules.areHighlightsDimmed);
}

TEST("a wrong or missing name of a course lists the courses") {
  CHECK_EQUAL(mistake({"-course", "1999"}),
              "-course: expected 2003, 2004, 2012, 2016, 2020, thu or aalto, found '1999'");
  CHECK_EQUAL(mistake({"-course"}), "-course: expected COURSE, found the end of the command");
  CHECK_EQUAL(mistake({"-course", "-size", "3", "4"}), "-course: expected COURSE, found '-size'");
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

TEST("the later courses bring their defaults") {
  for (const std::string name : {"2012", "2016", "2020", "thu", "aalto"}) {
    const RenderOptions options = optionsOf("-course " + name);
    CHECK(!options.shadows && !options.blendsGlass);
    CHECK_EQUAL(options.maxBounces, 0);
    CHECK_EQUAL(options.minWeight, name == "aalto" ? 0.1f : 0.0f);
    CHECK(options.epsilon.kind == Epsilon::Kind::fixed);
    CHECK_EQUAL(options.epsilon.value, name == "2016" || name == "2020" ? 0.01 : 0.001);
    CHECK_EQUAL(options.backs == RenderOptions::Backs::ambient, name == "aalto");
  }
}

TEST("-epsilon course is that of the course") {
  CHECK_EQUAL(optionsOf("-epsilon course").epsilon.value, 0.001);
  CHECK_EQUAL(optionsOf("-course 2016 -epsilon adaptive -epsilon course").epsilon.value, 0.01);
}

TEST("2012 is ray tracing where -bounces says more than 0, or the scene has glass") {
  const auto isTracing = [](const std::string& words) { return optionsOf(words).blendsGlass; };
  CHECK(!isTracing("-course 2012") && !isTracing("-course 2012 -bounces 0"));
  CHECK(isTracing("-course 2012 -bounces 1") && isTracing("-bounces 1 -course 2012 -shadows"));
  CHECK(!isTracing("-course 2016 -bounces 1") && !isTracing("-course 2012 -course 2003"));
  const Request request = parse(split("-course 2012 -bounces 2 -size 8 9 -region 1 2 3 4"));
  CHECK(!request.render.picture.rules.haveHighlights);
  CHECK_EQUAL(optionsOf(request).maxBounces, 2);
  CHECK_EQUAL(request.render.picture.area.width(), 3);

  const Desk desk;
  const std::string start =
      "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 30 }\n"
      "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 1 1 1 } }\n"
      "Materials { numMaterials 1 PhongMaterial { diffuseColor .5 .5 .5 specularColor .2 .2 .2 ";
  const std::string end =
      "} }\nGroup { numObjects 1 MaterialIndex 0 Sphere { center 0 0 0 radius 1 } }";
  desk.write("casting.txt", start + end);
  desk.write("glass.txt", start + "refractionIndex 2 " + end);
  desk.write("older.txt", start + "refraction_index 2 " + end);
  desk.run("-course 2012 -input casting.txt -size 1 1 -output casting.ppm");
  desk.run("-course 2012 -input glass.txt -size 1 1 -bounces 0 -output glass.ppm");
  desk.run("-course 2012 -input older.txt -size 1 1 -bounces 0 -output older.ppm");
  const auto lastByte = [&](const char* file) {
    return int(static_cast<unsigned char>(check::contentOf(desk.file(file)).back()));
  };
  // Diffuse .5 and, exponent 0, a highlight of .2 all over; as ray tracing the first alone.
  CHECK_EQUAL(lastByte("casting.ppm"), int(0.7 * 255));
  CHECK_EQUAL(lastByte("glass.ppm"), int(0.5 * 255));
  CHECK_EQUAL(lastByte("older.ppm"), int(0.5 * 255));
}

TEST("thu takes two bare words, and the picture's size from the scene") {
  const Request bare = parseRequest({"-course", "thu", "a.txt", "b.bmp"});
  CHECK_EQUAL(bare.render.picture.scene, "a.txt");
  CHECK_EQUAL(bare.render.results.outputs[0].file, "b.bmp");
  CHECK(
      contains(mistake({"-course", "thu", "a.txt", "b.bmp", "c"}), "expected an argument such as"));
  CHECK(contains(mistake({"-course", "2012", "a.txt", "b.bmp"}), "expected an argument such as"));
  const Desk desk;
  desk.write(
      "size.txt",
      "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 30 width 7 height 4 }"
      "Group { numObjects 0 }");
  const auto sizeOf = [&](const std::string& words) {
    desk.run("-course thu -input size.txt -output out.ppm " + words);
    const std::string picture = check::contentOf(desk.file("out.ppm"));
    return picture.substr(3, picture.find('\n', 3) - 3);
  };
  CHECK_EQUAL(sizeOf(""), "7 4");
  CHECK_EQUAL(sizeOf("-size 3 2"), "3 2");
  CHECK_EQUAL(sizeOf("-region 5 1 2 3"), "2 3");
}
