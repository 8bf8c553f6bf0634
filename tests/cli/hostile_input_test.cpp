// Inputs made to exhaust or confuse the program: each gives a clear message with a line, or a
// finished picture, in bounded time and memory.
#include <sys/stat.h>

#include "cli/hostile_desk.h"

namespace {

using hostile::contains;
using hostile::Desk;
using hostile::kCamera;

std::string repeated(const std::string& text, int count) {
  std::string all;
  all.reserve(text.size() * std::size_t(count));
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

}  // namespace

TEST("groups and transforms nested 100,000 deep are told the limit and the line") {
  const Desk desk;
  const std::string inside = "Sphere { center 0 0 0 radius 1 }";
  // One more in each line: the outermost Group stands on line 2, and 1000 are allowed.
  desk.write("groups.txt",
             kCamera + repeated("Group { numObjects 1\n", 100000) + inside + repeated("}", 100000));
  desk.checkFault(desk.run("-input groups.txt -output out.tga"), "groups.txt:1002", "1000");
  desk.checkFault(desk.run("-input groups.txt -check"), "groups.txt:1002", "1000");
  desk.write("moved.txt", kCamera + "Group { numObjects 1\n" +
                              repeated("Transform { Translate 0 0 0\n", 100000) + inside +
                              repeated("}", 100001));
  desk.checkFault(desk.run("-input moved.txt -output out.tga"), "moved.txt:1002", "1000");
  desk.write("open.txt", kCamera + repeated("Group { numObjects 1\n", 100000));
  desk.checkFault(desk.run("-input open.txt -output out.tga"), "open.txt:1002", "1000");
  desk.write("braces.txt", kCamera + repeated("{\n", 1000000));
  CHECK_EQUAL(desk.run("-input braces.txt -check").status, 3);
}

TEST("a declared count of 2147483647 allocates nothing, and the end of the list is a mistake") {
  const Desk desk;
  const std::string counts[] = {"Lights { numLights 2147483647\n}",
                                "Materials { numMaterials 2147483647\n}",
                                "Group { numObjects 2147483647\n}"};
  for (const std::string& section : counts) {
    desk.write("many.txt", kCamera + section);
    desk.checkFault(desk.run("-input many.txt -output out.tga", 100), "many.txt:3", "2147483647");
  }
  for (const char* count : {"2147483648", "99999999999999999999", "-1", "1e9"}) {
    desk.write("many.txt", kCamera + "Group {\nnumObjects " + count + "\n}");
    desk.checkFault(desk.run("-input many.txt -output out.tga", 100), "many.txt:3", count);
  }
}

TEST("a picture of 10^6 x 10^6 pixels is wrong usage, and the message names the limit") {
  const Desk desk;
  const auto run = desk.run("-input scene.txt -output out.tga -size 1000000 1000000", 100);
  CHECK_EQUAL(run.status, 2);
  CHECK(contains(run.errors, "65535"));
  CHECK(contains(run.errors, "1000000"));
}

TEST("a file of zeros is a mistake as a scene and as a mesh") {
  const Desk desk;
  desk.write("zeros", std::string(1000000, '\0'));
  desk.checkFault(desk.run("-input zeros -output out.tga"), "zeros:1", "\\x00");
  desk.write("mesh.txt",
             check::smallScene() + "Group { numObjects 1 TriangleMesh { obj_file zeros } }");
  desk.checkFault(desk.run("-input mesh.txt -output out.tga"), "zeros", "a binary file");
}

TEST("a folder is no scene and no mesh") {
  const Desk desk;
  desk.checkFault(desk.run("-input . -output out.tga"), ".", "folder");
  desk.write("mesh.txt",
             kCamera + "Group { numObjects 1 Material { }\nTriangleMesh { obj_file . } }");
  desk.checkFault(desk.run("-input mesh.txt -output out.tga"), "mesh.txt:3", "folder");
}

TEST("reading a FIFO waits for its writer, for a scene and for a mesh") {
  const Desk desk;
  CHECK_EQUAL(mkfifo(desk.file("scene").c_str(), 0600), 0);
  CHECK_EQUAL(mkfifo(desk.file("mesh").c_str(), 0600), 0);
  desk.write("triangle.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
  const std::string scene = kCamera + "Group { numObjects 1 Material { } TriangleMesh { obj_file ";
  desk.write("by_pipe.txt", scene + "mesh } }");
  desk.write("by_file.txt", scene + "triangle.obj } }");
  CHECK_EQUAL(desk.run("-input by_file.txt -output file.tga").status, 0);
  const auto run = check::runProgram("-quiet -input scene -output pipe.tga", desk.path(),
                                     "(sleep 0.2; cat by_pipe.txt >scene; sleep 0.2; "
                                     "cat triangle.obj >mesh) & timeout 100");
  CHECK_EQUAL(run.status, 0);
  CHECK(check::contentOf(desk.file("pipe.tga")) == check::contentOf(desk.file("file.tga")));
}

TEST("a scene that names itself as its mesh holds an empty mesh") {
  const Desk desk;
  const std::string self = "Group { numObjects 1 TriangleMesh { obj_file self.txt } }";
  desk.write("self.txt", check::smallScene() + self);
  desk.checkPicture("-input self.txt");
  CHECK_EQUAL(desk.run("-input scene.txt -output plain.tga").status, 0);
  CHECK(check::contentOf(desk.file("fast.tga")) == check::contentOf(desk.file("plain.tga")));
}

TEST("a face index of 10^9 is a mistake on its line") {
  const Desk desk;
  desk.write("mesh.txt",
             kCamera + "Group { numObjects 1 Material { }\nTriangleMesh { obj_file far.obj } }");
  for (const char* index : {"1000000000", "-1000000000", "4294967297", "18446744073709551617"}) {
    desk.write("far.obj", std::string("v 0 0 0\nv 1 0 0\nf 1 2 ") + index + "\n");
    desk.checkFault(desk.run("-input mesh.txt -output out.tga"), "far.obj:3", index);
  }
}

TEST("coordinates of 1e308 and 1e-320 give a finished picture, the same by tree and by hand") {
  const Desk desk;
  const std::string scene =
      kCamera +
      "Lights { numLights 2 PointLight { position 1e308 1e308 1e308 color 1 1 1 }\n"
      "PointLight { position 1e-320 -1e-320 3 color 1 1 1 attenuation 1e-320 1e308 0 } }\n"
      "Materials { numMaterials 1 PhongMaterial { diffuseColor 1 0 0 reflectiveColor 1 1 1\n"
      "  transparentColor .5 .5 .5 indexOfRefraction 1.5 } }\n"
      "Group { numObjects 9 MaterialIndex 0\n"
      "Sphere { center 1e308 0 -1e308 radius 1e308 }\n"
      "Sphere { center 0 0 0 radius 1e-320 }\n"
      "Sphere { center 1e-320 -1e-320 0 radius 1 }\n"
      "Triangle { vertex0 -1e308 -1e308 0 vertex1 1e308 -1e308 0 vertex2 0 1e308 0 }\n"
      "Triangle { vertex0 -1e-320 0 1 vertex1 1e-320 0 1 vertex2 0 1e-320 1 }\n"
      "Plane { normal 1e308 1e308 1e308 offset -1e308 }\n"
      "Plane { normal 0 1e-320 0 offset -1e-320 }\n"
      "Transform { Scale 1e-100 1e-100 1e-100 Sphere { center 0 0 0 radius 1e308 } }\n"
      "Transform { Translate 1e308 0 0 Scale 1e308 1 1 Sphere { center -1 0 0 radius 1 } } }\n";
  desk.write("wide.txt", scene);
  for (const char* options :
       {"", " -epsilon adaptive", " -epsilon course -transparent_shadows", " -shade_back"}) {
    desk.checkPicture("-input wide.txt -size 20 20" + std::string(options));
  }
}

TEST("transforms of 1e308 and 1e-320 that cannot be inverted are mistakes on their lines") {
  const Desk desk;
  for (const std::string scale : {"Scale 1e-320 1 1", "UniformScale 1e308 UniformScale 1e308",
                                  "Scale 1e-308 1 1 Scale 1e-308 1 1"}) {
    desk.write("moved.txt", kCamera + "Group { numObjects 1 Material { }\nTransform { " + scale +
                                " Sphere { center 0 0 0 radius 1 } } }");
    desk.checkFault(desk.run("-input moved.txt -output out.tga"), "moved.txt:3", "transform");
  }
}

TEST("a path to a mesh of more than 4096 bytes is told the limit") {
  const Desk desk;
  desk.write("mesh.txt", kCamera + "Group { numObjects 1 Material { }\nTriangleMesh { obj_file " +
                             std::string(4097, 'm') + " } }");
  desk.checkFault(desk.run("-input mesh.txt -output out.tga"), "mesh.txt:3", "4096 bytes");
}

TEST("-check says where it stops to list mistakes") {
  const Desk desk;
  desk.write("many.txt", kCamera + "Group { numObjects 101 Material { }" +
                             repeated("\nSphere { center 0 0 0 radius -1 }", 101) + " }");
  const auto run = desk.run("-input many.txt -check");
  CHECK_EQUAL(run.status, 3);
  CHECK(contains(run.errors, "many.txt:102: "));  // the 100th: the first one stands on line 3
  CHECK(!contains(run.errors, "many.txt:103: "));
  CHECK(contains(run.errors, "\nraytracer: many.txt: reading ended with mistake number 100\n"));
}

TEST("facing mirrors: 100000 bounces are wrong usage, 10000 are traced to their end") {
  const Desk desk;
  desk.write("mirrors.txt",
             "PerspectiveCamera { center 0 0 0 direction 0 0 -1 up 0 1 0 angle 40 }\n"
             "Materials { numMaterials 1 PhongMaterial { diffuseColor 0 0 0\n"
             "  reflectiveColor 1 1 1 } }\n"
             "Group { numObjects 2 MaterialIndex 0\n"
             "  Plane { normal 0 0 1 offset -2 } Plane { normal 0 0 -1 offset -2 } }\n");
  const auto run = desk.run("-input mirrors.txt -output out.tga -bounces 100000 -weight 0");
  CHECK_EQUAL(run.status, 2);
  CHECK(contains(run.errors, "10000") && contains(run.errors, "100000"));
  desk.checkPicture("-input mirrors.txt -size 8 8 -bounces 10000 -weight 0");
}
