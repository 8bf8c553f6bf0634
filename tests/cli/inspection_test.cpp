// -pixel, -pixel_obj, -materials and -heatmap on the command line.
#include "check.h"
#include "cli/request.h"
#include "desk.h"
#include "image/picture_file.h"

using check::contains;
using check::Desk;

namespace {

/// The message for a wrong command; "" where it is right.
std::string mistake(std::vector<std::string> words) {
  words.insert(words.begin(), {"-input", "scene.txt"});
  try {
    parseRequest(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

/// The last `count` lines of a text.
std::string lastLines(const std::string& text, int count) {
  std::size_t at = text.size();
  for (int i = 0; i < count && at > 0; ++i) {
    at = text.rfind('\n', at - 2);
    at = at == std::string::npos ? 0 : at + 1;
  }
  return text.substr(at);
}

/// The words behind "# raytracer" in a scene, without those about -input and -output.
std::string argumentsOf(const std::string& scene) {
  const std::string text = check::contentOf(scene);
  const std::string start = "# raytracer ";
  const std::size_t at = text.find(start) + start.size();
  std::istringstream words(text.substr(at, text.find('\n', at) - at));
  std::string all, word;
  while (words >> word) {
    if (word == "-input" || word == "-output") {
      words >> word;
    } else {
      all += " " + word;
    }
  }
  return all;
}

}  // namespace

TEST("a pixel is named by two numbers within the picture, wherever -size stands") {
  CHECK_EQUAL(mistake({"-pixel", "99", "99"}), "");
  CHECK_EQUAL(mistake({"-pixel", "299", "1", "-size", "300", "2"}), "");
  CHECK_EQUAL(mistake({"-pixel", "100", "5"}),
              "-pixel: expected X below 100 and Y below 100, the size of the image, found '100 5'");
  CHECK_EQUAL(mistake({"-pixel", "5", "2", "-size", "300", "2"}),
              "-pixel: expected X below 300 and Y below 2, the size of the image, found '5 2'");
  CHECK(contains(mistake({"-pixel", "-1", "5"}), "expected a whole number from 0 to 65534 for X"));
  CHECK(contains(mistake({"-pixel", "1", "x"}), "for Y, found 'x'"));
  CHECK_EQUAL(mistake({"-pixel_obj", "a.obj", "-stats"}),
              "-pixel_obj: expected a pixel to trace, for example -pixel 50 50, found none");
}

TEST("-pixel alone is something to do, and its last lines are the colour in numbers and bytes") {
  const Desk desk;
  // The corner of the small scene is background, 0.2: byte int(0.2 * 255) = 51 in float.
  const check::ProgramRun run = desk.run("-input scene.txt -pixel 0 0");
  CHECK_EQUAL(run.status, 0);
  CHECK_EQUAL(run.errors, "");
  CHECK(check::startsWith(run.output, "eye ray, bounces 0, weight 1, index 1\n  origin 0 0 5\n"));
  CHECK(contains(run.output, "  hits nothing: background\n  color 0.2 0.2 0.2\n"));
  CHECK_EQUAL(lastLines(run.output, 2), "color 0.2 0.2 0.2\npixel 0 0 = 51 51 51\n");
  // Also behind what other arguments print.
  const check::ProgramRun all =
      desk.run("-input scene.txt -pixel 0 0 -stats -heatmap h.tga -materials m.tga");
  CHECK_EQUAL(lastLines(all.output, 2), "color 0.2 0.2 0.2\npixel 0 0 = 51 51 51\n");
  CHECK(contains(all.output, "\nheatmap: black 0, "));
  CHECK(contains(all.output, "\nmaterial 0: 255 0 0, PhongMaterial, "));
  CHECK(contains(all.output, "\neye rays: 10000\n"));
  // The ball is named by the line of the scene on which it stands.
  CHECK(contains(desk.run("-input scene.txt -pixel 50 50").output,
                 "  hits Group 1 > Sphere 1, scene.txt:5\n"));
}

TEST("Y counts from the top") {
  const Desk desk;
  desk.write("floor.txt",
             "PerspectiveCamera { center 0 1 5 direction 0 0 -1 up 0 1 0 angle 60 }\n"
             "Materials { numMaterials 1 PhongMaterial { } }\n"
             "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 0 offset 0 } }\n");
  CHECK(contains(desk.run("-input floor.txt -quiet -pixel 50 2").output, "hits nothing"));
  CHECK(
      contains(desk.run("-input floor.txt -quiet -pixel 50 97").output, "hits Group 1 > Plane 1"));
}

TEST("of several blockers in one place the first of the scene is named") {
  // Three meshes in one place, between a triangle and the sun.
  const Desk desk;
  desk.write("t.obj", "v 0 2 0\nv 4 2 0\nv 0 2 4\nf 1 2 3\n");
  const std::string mesh = "TriangleMesh { obj_file t.obj } ";
  desk.write("s.txt",
             "PerspectiveCamera { center 1 1 1 direction 0 -1 0 up 0 0 1 angle 10 }\n"
             "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 1 1 1 } }\n"
             "Materials { numMaterials 1 PhongMaterial { } }\n"
             "Group { numObjects 4 MaterialIndex 0\n"
             "Triangle { vertex0 -9 0 -9 vertex1 0 0 19 vertex2 19 0 -9 }\n" +
                 mesh + mesh + mesh + "}\n");
  for (const char* const way : {"", " -accel tree", " -grid 4 4 4"}) {
    for (const char* const shadows : {"-shadows", "-transparent_shadows"}) {
      const std::string report =
          desk.run(std::string("-input s.txt -size 1 1 -pixel 0 0 ") + shadows + way).output;
      CHECK(contains(report, "blocked by Group 1 > TriangleMesh 2, "));
    }
  }
}

TEST("the rays of a pixel, the materials and the heat map are files of their own") {
  const Desk desk;
  const check::ProgramRun run = desk.run(
      "-input scene.txt -size 20 10 -pixel 10 5 -pixel_obj rays.obj -heatmap h.png -materials "
      "m.tga");
  CHECK_EQUAL(run.status, 0);
  CHECK(check::startsWith(check::contentOf(desk.file("rays.obj")), "# Rays that meet nothing"));
  CHECK_EQUAL(readImage(desk.file("h.png")).Width(), 20);
  CHECK_EQUAL(readImage(desk.file("m.tga")).Height(), 10);
  // Written all or nothing, and never over each other.
  CHECK_EQUAL(desk.run("-input scene.txt -pixel 1 1 -pixel_obj nowhere/a.obj").status, 1);
  CHECK_EQUAL(desk.run("-input scene.txt -pixel 1 1 -pixel_obj a -heatmap a").status, 2);
  CHECK_EQUAL(desk.run("-input scene.txt -pixel 1 1 -materials scene.txt").status, 2);
}

TEST("in every scene of scenes/, with its own arguments, a pixel has the picture's bytes") {
  const Desk desk;
  int scenes = 0;
  const std::string folder = check::testsFolder() + "/../scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string scene = entry.path().string();
    if (entry.path().extension() != ".txt") continue;
    ++scenes;
    const std::string command =
        "-input " + check::quoted(scene) + argumentsOf(scene) + " -quiet -size 24 18";
    CHECK_EQUAL(desk.run(command + " -output out.ppm").status, 0);
    const Image picture = readImage(desk.file("out.ppm"));
    for (const auto& [x, y] : {std::pair(11, 9), std::pair(3, 14), std::pair(17, 7)}) {
      const Rgb8 color = picture.getPixel(x, 17 - y);
      const std::string wanted = "pixel " + std::to_string(x) + " " + std::to_string(y) + " = " +
                                 std::to_string(color.r) + " " + std::to_string(color.g) + " " +
                                 std::to_string(color.b) + "\n";
      const check::ProgramRun run =
          desk.run(command + " -pixel " + std::to_string(x) + " " + std::to_string(y));
      check::report(run.status == 0 && lastLines(run.output, 1) == wanted, __FILE__, __LINE__,
                    scene + ": expected " + wanted + ", found " + lastLines(run.output, 1));
    }
  }
  CHECK(scenes >= 32);
}
