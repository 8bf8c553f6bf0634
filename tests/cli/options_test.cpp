// The command line: every argument and its limits.
#include <filesystem>

#include "check.h"
#include "cli/command_words.h"
#include "cli/outputs.h"
#include "cli/request.h"
#include "run_program.h"
#include "system/worker_threads.h"

using check::contains, check::mistake, check::parse, check::split, check::Words;
using Kind = OutputRequest::Kind;

namespace {

/// The name of the output of this kind, which is wanted.
std::string fileOf(const Request& request, Kind kind) {
  return request.render.results.find(kind)->file;
}

}  // namespace

TEST("the course's exact command") {
  const Request o = parseRequest(split("-input scene.txt -output out.tga -bounces 5 -weight 0.01"));
  CHECK_EQUAL(o.render.picture.scene, "scene.txt");
  CHECK_EQUAL(fileOf(o, Kind::color), "out.tga");
  CHECK_EQUAL(o.render.picture.render.maxBounces, 5);
  CHECK_EQUAL(o.render.picture.render.minWeight, 0.01f);
}

TEST("defaults are those of the contract, and those that the table tells") {
  const Request o = parse({});
  CHECK_EQUAL(o.render.picture.width, 100);
  CHECK_EQUAL(o.render.picture.height, 100);
  CHECK(!o.render.results.find(Kind::depth) && !o.render.results.find(Kind::normals));
  CHECK_EQUAL(o.render.picture.render.maxBounces, 5);
  CHECK_EQUAL(o.render.picture.render.minWeight, 0.01f);
  CHECK(o.render.picture.render.shadows && !o.render.picture.render.transparentShadows &&
        !o.render.picture.render.shadeBack);
  CHECK(o.render.picture.render.epsilon.kind == Epsilon::Kind::automatic);
  CHECK_EQUAL(o.run.threads, std::min(hardwareThreads(), kMaxThreads));
  CHECK(o.render.picture.acceleration.kind == Acceleration::Kind::fast);
  CHECK(o.render.picture.acceleration.simd == SimdLevel::automatic);
  CHECK(!o.run.quiet && !o.render.results.stats && !o.check && o.text == ProgramText::none);
  CHECK(contains(findArgument("size")->help, " (default: 100 100)"));
  CHECK(contains(findArgument("bounces")->help, " (default: 5)"));
  CHECK(contains(findArgument("weight")->help, " (default: 0.01)"));
  CHECK(contains(findArgument("accel")->help, " (default: fast)"));
  CHECK(contains(findArgument("simd")->help, " (default: auto)"));
}

TEST("arguments come in any order and the last of two equal ones wins") {
  const Request o =
      parseRequest(split("-bounces 1 -output a --size 3 4 -input b -bounces 2 -size 5 6"));
  CHECK_EQUAL(o.render.picture.scene, "b");
  CHECK_EQUAL(fileOf(o, Kind::color), "a");
  CHECK_EQUAL(o.render.picture.render.maxBounces, 2);
  CHECK_EQUAL(o.render.picture.width, 5);
  CHECK_EQUAL(o.render.picture.height, 6);
  CHECK(!parse({"-shadows", "-no_shadows"}).render.picture.render.shadows);
  CHECK(parse({"-no_shadows", "-shadows"}).render.picture.render.shadows);
  CHECK(parse(split("-epsilon 1 -epsilon adaptive")).render.picture.render.epsilon.kind ==
        Epsilon::Kind::adaptive);
}

TEST("whole numbers are accepted from the first to the last of their range and not beyond") {
  CHECK_EQUAL(parse({"-bounces", "0"}).render.picture.render.maxBounces, 0);
  CHECK_EQUAL(parse({"-bounces", "10000"}).render.picture.render.maxBounces, 10000);
  CHECK_EQUAL(parse({"-threads", "1"}).run.threads, 1);
  CHECK_EQUAL(parse({"-threads", "1024"}).run.threads, 1024);
  CHECK_EQUAL(parse({"-size", "1", "65535"}).render.picture.width, 1);
  CHECK_EQUAL(parse({"-size", "1", "65535"}).render.picture.height, 65535);
  for (const char* wrong :
       {"-bounces -1", "-bounces 10001", "-threads 0", "-threads 1025", "-size 0 1", "-size 1 0",
        "-size 65536 1", "-size 1 65536", "-bounces 99999999999999999999", "-bounces 4294967296"})
    CHECK(contains(mistake(split(wrong)), "expected a whole number from"));
}

TEST("a number must fill its whole word") {
  for (const std::string wrong : {"5x", "x", "", " 5", "5 ", "nan", "inf", "0x10", "5..1", "--5"}) {
    CHECK(contains(mistake({"-bounces", wrong}), "found '" + wrong + "'"));
    CHECK(contains(mistake({"-weight", wrong}), "found '" + wrong + "'"));
    CHECK(contains(mistake({"-epsilon", wrong}), "found '" + wrong + "'"));
    CHECK(contains(mistake({"-depth", "1", wrong, "f"}), "found '" + wrong + "'"));
  }
  CHECK(contains(mistake({"-bounces", "1.5"}), "a whole number"));
}

TEST("weights are at least 0, overflow is a mistake and underflow gives 0") {
  CHECK_EQUAL(parse({"-weight", "0"}).render.picture.render.minWeight, 0.0f);
  CHECK_EQUAL(parse({"-weight", "2.5e1"}).render.picture.render.minWeight, 25.0f);
  CHECK_EQUAL(parse({"-weight", "1e-999"}).render.picture.render.minWeight, 0.0f);
  CHECK(contains(mistake({"-weight", "-0.1"}), "at least 0"));
  CHECK(contains(mistake({"-weight", "1e39"}), "found '1e39'"));  // float ends at 3.4e38
  CHECK(contains(mistake({"-epsilon", "1e309"}), "found '1e309'"));
}

TEST("epsilon is a number, course or adaptive") {
  CHECK(parse({"-epsilon", "course"}).render.picture.render.epsilon.kind == Epsilon::Kind::fixed);
  CHECK_EQUAL(parse({"-epsilon", "course"}).render.picture.render.epsilon.value, 0.001);
  CHECK(parse({"-epsilon", "adaptive"}).render.picture.render.epsilon.kind ==
        Epsilon::Kind::adaptive);
  CHECK(parse({"-epsilon", "0.25"}).render.picture.render.epsilon.kind == Epsilon::Kind::fixed);
  CHECK_EQUAL(parse({"-epsilon", "0.25"}).render.picture.render.epsilon.value, 0.25);
  CHECK_EQUAL(parse({"-epsilon", "0"}).render.picture.render.epsilon.value, 0.0);
  CHECK(contains(mistake({"-epsilon", "-1"}), "adaptive"));
  CHECK(contains(mistake({"-epsilon", "corse"}), "found 'corse'"));
}

TEST("the depth image takes MIN MAX FILE or FILE MIN MAX") {
  for (const char* order : {"-depth -8 12.5 d.tga", "-depth d.tga -8 12.5"}) {
    const Request o = parse(split(order));
    CHECK_EQUAL(fileOf(o, Kind::depth), "d.tga");
    CHECK_EQUAL(o.render.results.find(Kind::depth)->depthMin, -8.0);
    CHECK_EQUAL(o.render.results.find(Kind::depth)->depthMax, 12.5);
  }
  CHECK_EQUAL(fileOf(parse(split("-depth 1 2 3")), Kind::depth), "3");
  CHECK_EQUAL(fileOf(parse(split("-depth 1x 2 3")), Kind::depth), "1x");
  CHECK_EQUAL(parse(split("-depth 12 8 d.tga")).render.results.find(Kind::depth)->depthMin, 12.0);
  CHECK(contains(mistake(split("-depth 8 8.0 d.tga")), "differ"));
  CHECK(contains(mistake(split("-depth d.tga 8 8")), "differ"));
  CHECK(contains(mistake(split("-depth d.tga e.tga 8")), "found 'e.tga'"));
  CHECK(contains(mistake(split("-depth 8 d.tga 12")), "found 'd.tga'"));
  CHECK(contains(mistake(split("-depth 1e999 8 d.tga")), "for MIN"));  // too large, but a number
}

TEST("accel is fast or tree") {
  CHECK(parse({"-accel", "tree"}).render.picture.acceleration.kind == Acceleration::Kind::tree);
  CHECK(parse({"-accel", "tree", "-accel", "fast"}).render.picture.acceleration.kind ==
        Acceleration::Kind::fast);
  CHECK(contains(mistake({"-accel", "slow"}), "expected fast or tree, found 'slow'"));
  CHECK(contains(mistake({"-accel", "fsat"}), "found 'fsat'; did you mean 'fast'?"));
}

TEST("simd is auto, baseline, avx2 or avx512") {
  CHECK(parse({"-simd", "baseline"}).render.picture.acceleration.simd == SimdLevel::baseline);
  CHECK(parse({"-simd", "avx2"}).render.picture.acceleration.simd == SimdLevel::avx2);
  CHECK(parse({"-simd", "avx512"}).render.picture.acceleration.simd == SimdLevel::avx512);
  CHECK(parse({"-simd", "avx2", "-simd", "auto"}).render.picture.acceleration.simd ==
        SimdLevel::automatic);
  CHECK(contains(mistake({"-simd", "sse"}),
                 "-simd: expected auto, baseline, avx2 or avx512, found 'sse'"));
}

TEST("an unknown argument is answered with the nearest one") {
  CHECK(contains(mistake({"-bounce", "5"}), "did you mean '-bounces'?"));
  CHECK(contains(mistake({"--noshadows"}), "did you mean '-no_shadows'?"));
  CHECK(contains(mistake({"-wieght", "1"}), "did you mean '-weight'?"));
  CHECK(contains(mistake({"-szie", "4", "4"}), "did you mean '-size'?"));
  CHECK(contains(mistake({"-zzzzzzzz"}), "unknown argument '-zzzzzzzz'; 'raytracer -help'"));
  CHECK(contains(mistake({"---quiet"}), "unknown argument"));
  CHECK(contains(mistake({"scene.txt"}), "found 'scene.txt'"));
  CHECK(contains(mistake({""}), "found ''"));
  CHECK(contains(mistake({"-"}), "found '-'"));
}

TEST("a scene and something to do with it are needed") {
  const auto message = [](const char* words) {
    try {
      parseRequest(split(words));
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(contains(message("-output out.tga"), "-input"));
  CHECK(contains(message("-input scene.txt"),
                 "-output, -depth, -normals, -render_samples, -render_filter, -materials, "
                 "-heatmap, -pixel, -preview, -stats and -check"));
  for (const char* enough : {"-check", "-stats", "-output a", "-depth 1 2 a", "-normals a",
                             "-normal a", "-render_samples a 2", "-render_filter a 2",
                             "-materials a", "-heatmap a", "-pixel 1 1", "-preview"})
    CHECK_EQUAL(message((std::string("-input scene.txt ") + enough).c_str()), "");
  CHECK_EQUAL(message(""), "");
  CHECK_EQUAL(message("-help"), "");
  CHECK_EQUAL(message("--help"), "");
  CHECK_EQUAL(message("-version"), "");
  CHECK(parseRequest({}).text == ProgramText::shortHelp);
}

TEST("file names must not be empty, and a dash is standard input or output") {
  CHECK(contains(mistake({"-input", ""}), "a file name"));
  CHECK(contains(mistake({"-output", ""}), "a file name"));
  CHECK(contains(mistake({"-depth", "", "1", "2"}), "a file name"));
  CHECK(contains(mistake({"-checkpoint", ""}), "a file name"));
  CHECK(contains(mistake({"-checkpoint", "-"}), "found '-'"));
  CHECK_EQUAL(fileOf(parse({"-output", "-"}), Kind::color), "-");
  CHECK_EQUAL(fileOf(parse({"-normals", "-"}), Kind::normals), "-");
  CHECK_EQUAL(fileOf(parse({"-depth", "-", "1", "2"}), Kind::depth), "-");
  CHECK_EQUAL(parse({"-input", "-"}).render.picture.scene, "-");
  CHECK_EQUAL(fileOf(parse({"-output", "-strange"}), Kind::color), "-strange");
}

TEST("two arguments must not name the same file") {
  const check::ScratchFolder folder;
  const std::string scene = folder.write("scene", ""), dir = folder.path() + "/";
  std::filesystem::create_symlink("scene", folder.file("link"));
  std::filesystem::create_symlink("new", folder.file("to_new"));
  std::filesystem::create_hard_link(scene, folder.file("other_name"));
  const auto clash = [&](const std::string& input, const Words& words) {
    Words all = {"-input", input};
    all.insert(all.end(), words.begin(), words.end());
    const Request request = parseRequest(all);
    try {
      checkFiles(request.render, request.run.checkpoint);
    } catch (const UsageError&) {
      return true;
    }
    return false;
  };
  CHECK(
      !clash(scene, {"-output", dir + "a", "-normals", dir + "b", "-depth", "1", "2", dir + "c"}));
  CHECK(clash(scene, {"-output", scene}));
  CHECK(clash(scene, {"-output", dir + "./scene"}));
  CHECK(clash(scene, {"-normals", dir + "link"}));
  CHECK(clash(scene, {"-normals", dir + "other_name"}));
  CHECK(clash(scene, {"-output", dir + "a", "-normals", dir + "a"}));
  CHECK(clash(scene, {"-output", dir + "new", "-normals", dir + "to_new"}));
  CHECK(clash("-", {"-depth", "a", "1", "2", "-normals", "./a"}));
  CHECK(!clash(scene, {"-output", "/dev/null", "-normals", "/dev/null"}));
  CHECK(clash(scene, {"-output", "-", "-normals", "-"}));
  CHECK(!clash("-", {"-output", "-"}));
  CHECK(clash(scene, {"-output", dir + "a", "-checkpoint", dir + "a"}));
  CHECK(clash(scene, {"-output", dir + "a", "-checkpoint", scene}));
}

TEST("a value may follow its argument behind =, and a size have an x between its numbers") {
  const Request o = parseRequest(split("--input=s=1.txt -output=o.tga -size 100x50 --bounces=3"));
  CHECK_EQUAL(o.render.picture.scene, "s=1.txt");
  CHECK_EQUAL(fileOf(o, Kind::color), "o.tga");
  CHECK_EQUAL(o.render.picture.width, 100);
  CHECK_EQUAL(o.render.picture.height, 50);
  CHECK_EQUAL(o.render.picture.render.maxBounces, 3);
  CHECK_EQUAL(parse({"--size=7x9"}).render.picture.height, 9);
  CHECK(contains(mistake({"-size", "100x"}), "-size"));
  CHECK(contains(mistake({"-ouput=a.tga"}), "unknown argument"));
  CHECK(contains(fullHelp(), "-bounces=5 -size 64x48"));
}

TEST("an output's ending must be known, or missing") {
  for (const char* good : {"out", "out.BMP", "a.b/out", "-", ".", "out."}) {
    CHECK_EQUAL(mistake({"-output", good}), "");
  }
  for (const char* wrong : {"x.jpg", "x.tga.gz", ".hidden", "a.b/x.txt"}) {
    CHECK(contains(mistake({"-output", wrong}), "one of .tga, .png, .bmp, .ppm, .pfm, found"));
    CHECK(contains(mistake({"-depth", "1", "2", wrong}), "one of .tga"));
  }
}
