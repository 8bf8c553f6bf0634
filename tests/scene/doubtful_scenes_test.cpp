// What scenes say that was probably not meant: fields given twice, lights that go out, thin glass.
#include <algorithm>
#include <cmath>

#include "scene/scene_files.h"

TEST("a field that is given twice is named with both lines; the last one holds") {
  const std::string text = scenes::around(
      "Sphere { center 0 0 0 radius 1\n radius 2 }\n"
      "Sphere { center 0 0 0\ncenter 1 0 0 radius 2 }",
      2);
  CHECK_EQUAL(scenes::parse(text)->getSpan(), 5.0);
  const std::string mistakes = scenes::mistakesIn(text);
  CHECK(scenes::contains(mistakes, "6: radius is given a second time, first in line 5"));
  CHECK(scenes::contains(mistakes, "8: center is given a second time, first in line 7"));
  const auto scene = scenes::parse(text);
  CHECK_EQUAL(std::count_if(scene->getWarnings().begin(), scene->getWarnings().end(),
                            [](const std::string& warning) {
                              return scenes::contains(warning, "is given a second time");
                            }),
              2);
}

TEST("an attenuation that turns a light off somewhere in the scene is named") {
  const auto warned = [](const std::string& attenuation) {
    const std::string text =
        "OrthographicCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 size 4 }\n"
        "Lights { numLights 1\n PointLight { position 0 3 0 color 1 1 1 attenuation " +
        attenuation +
        " } }\nMaterials { numMaterials 1 Material { } }\n"
        "Group { numObjects 1 MaterialIndex 0 Sphere { center 0 0 0 radius 1 } }\n";
    const auto scene = scenes::parse(text);
    for (const std::string& warning : scene->getWarnings()) {
      if (scenes::contains(warning, ":3: the light's attenuation is not above 0")) return true;
    }
    return false;
  };
  CHECK(warned("0 0 0") && warned("-1 0 0") && warned("0 -1 1"));
  CHECK(warned("1 -0.5 0"));   // 0 at a distance of 2, before the sphere's far side
  CHECK(!warned("1 -0.1 0"));  // 0 at 10, behind everything
  CHECK(!warned("1 0 0") && !warned("0 0 1") && !warned("0 1 0") && !warned("1 -1 0.3"));
}

TEST("glass is found that is thinner than any usual epsilon, and its line") {
  const auto thinnest = [](const std::string& object) {
    return scenes::parse(
               "OrthographicCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 size 4 }\n"
               "Materials { numMaterials 2 Material { } "
               "Material { transparentColor 1 1 1 } }\n"
               "Group { numObjects 2 MaterialIndex 0 Sphere { center 0 0 0 radius 1e-5 }\n"
               "MaterialIndex 1 " +
               object + " }\n")
        ->getThinnestSolid();
  };
  const auto pane = thinnest("Transform { Scale 1 1 4e-4 Sphere { center 0 0 0 radius 0.5 } }");
  CHECK_NEAR(pane.thickness, 4e-4, 1e-12);
  CHECK_EQUAL(pane.line, std::size_t(4));
  // Thinner than the epsilon of 0.01 that two of the course's years have.
  CHECK_NEAR(thinnest("Sphere { center 0 0 0 radius 0.004 }").thickness, 0.008, 1e-12);
  CHECK(std::isinf(thinnest("Sphere { center 0 0 0 radius 0.5 }").thickness));
}
