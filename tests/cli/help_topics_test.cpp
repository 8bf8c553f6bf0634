// The topics of `raytracer -help TOPIC`.

#include <algorithm>
#include <set>
#include <sstream>

#include "check.h"
#include "cli/arguments.h"
#include "cli/command_words.h"
#include "cli/desk.h"
#include "render/tiles.h"
#include "scene/scene_grammar.h"
#include "scene/scene_parser.h"
#include "scene/scene_reader.h"

using check::contains, check::contentOf, check::Desk;

namespace {

/// The topic that `-help NAME` prints.
const HelpTopic* topicOf(const std::string& name) { return parseRequest({"-help", name}).topic; }

/// The example of topic scene: the indented lines from its comment to the next empty line.
std::string exampleScene() {
  const std::string text = topicOf("scene")->text;
  const std::size_t start = text.find("  # A red ball");
  return text.substr(start, text.find("\n\n", start) + 1 - start);
}

/// `text` cut into words of letters, digits and "_".
std::set<std::string> wordsOf(std::string text) {
  for (char& c : text) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') c = ' ';
  }
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

}  // namespace

TEST("topics are plain ASCII in lines of at most 80 columns, and end with a line's end") {
  const auto isPlain = [](char c) { return c >= ' ' && c <= '~'; };
  for (const HelpTopic& topic : helpTopics()) {
    const std::string text = topic.text;
    CHECK(text.size() > 500);
    CHECK(text.front() != '\n');
    CHECK(text.back() == '\n' && text[text.size() - 2] != '\n');
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const bool isGood = line.size() <= 80 && std::all_of(line.begin(), line.end(), isPlain) &&
                          (line.empty() || line.back() != ' ');
      CHECK_EQUAL(isGood ? "" : line, "");
    }
  }
}

TEST("topics have one small word each as name, all different, and a short summary") {
  std::set<std::string> names;
  for (const HelpTopic& topic : helpTopics()) {
    const std::string name = topic.name;
    CHECK(std::all_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; }));
    CHECK(names.insert(name).second);
    CHECK(std::string(topic.summary).size() <= 60);
    CHECK(topicOf(name) == &topic);
  }
  for (const std::string wrong : {"", "scenes"}) {
    CHECK(contains(check::mistake({"-help", wrong}), "-help: expected scene, course, materials, "));
  }
}

TEST("the example of topic scene has neither mistakes nor warnings, and is drawn") {
  const Desk desk;
  const std::string file = desk.write("scene.txt", exampleScene());
  std::vector<std::string> warnings;
  CHECK(SceneParser::check(file.c_str(), &warnings).empty());
  CHECK(warnings.empty());
  const SceneParser scene(file.c_str());
  CHECK_EQUAL(scene.getNumLights(), 2);
  CHECK_EQUAL(scene.getNumMaterials(), 3);
  const check::ProgramRun run =
      desk.run("-input scene.txt -output out.ppm -bounces 5 -weight 0.01 -size 40 30");
  CHECK_EQUAL(run.status, 0);
  CHECK_EQUAL(run.errors, "");
  const std::string picture = contentOf(desk.file("out.ppm"));
  CHECK_EQUAL(picture.size(), std::size_t(13 + 3 * 40 * 30));
  // Sky, floor, ball and what the mirror shows: many colours.
  CHECK(std::set<char>(picture.begin() + 13, picture.end()).size() > 40);
}

TEST("topic scene has every word of the scene language of 2003") {
  const std::set<std::string> words = wordsOf(topicOf("scene")->text);
  const auto check = [&](std::string_view word) {
    CHECK_EQUAL(words.count(std::string(word)) == 1 ? "" : std::string(word), "");
  };
  for (const std::string_view word : kSectionWords) check(word);
  for (const std::string_view word : kLightWords) check(word);
  for (const std::string_view word : kGroupWords) check(word);
  for (const std::string_view word : kTransformWords) check(word);
  for (const std::string_view word : kCountWords) check(word);
  const std::set<std::string> ofCourses = wordsOf(topicOf("course")->text);
  for (const Field& field : kFields) {
    if (isIn(field.languages, Language::of2003)) check(field.name);
    if (!isIn(field.languages, Language::of2003))
      CHECK(ofCourses.count(std::string(field.name)) == 1);
  }
  for (const std::string_view word : kNodeStepWords) CHECK(ofCourses.count(std::string(word)) == 1);
}

TEST("topic limits has the stacks of threads, and topic output every kind of warning of a scene") {
  const auto stackOf = [](int bounces) {
    RenderOptions options;
    options.maxBounces = bounces;
    return tracingStack(options);
  };
  CHECK_EQUAL(stackOf(0), std::size_t(2 << 20));
  CHECK_EQUAL(stackOf(1) - stackOf(0), std::size_t(8 << 10));
  CHECK(contains(topicOf("limits")->text, "2 MB and 8\nkB a bounce for each thread"));
  const std::string output = topicOf("output")->text;
  const std::string warnings = output.substr(output.find("\nWARNINGS\n"));
  for (const char* kind : {"no lights", "no Group", "given twice", "behind a perspective camera",
                           "inside opaque closed objects", "attenuation", "exponent below 1",
                           "above 1", "that no object has", "without area", "without faces",
                           "less than three corners", "outline crosses itself", "bump"}) {
    CHECK_EQUAL(contains(warnings, kind) ? "" : kind, "");
  }
  CHECK_EQUAL(ObjectReader::kFlatTrianglesNamed, std::size_t(10));
  CHECK(contains(warnings, "of\ntriangles without area ten"));
}

TEST("-help prints each topic on standard output, with one dash or two") {
  const Desk desk;
  for (const HelpTopic& topic : helpTopics()) {
    for (const char* name : {"-help ", "--help ", "-h "}) {
      const check::ProgramRun run = desk.run(name + std::string(topic.name));
      CHECK_EQUAL(run.status, 0);
      CHECK_EQUAL(run.errors, "");
      CHECK_EQUAL(run.output, topic.text);
    }
  }
  CHECK_EQUAL(desk.run("-help -quiet").output, fullHelp());
  CHECK_EQUAL(desk.run("-quiet -help grid -threads 2").output, topicOf("grid")->text);
}

TEST("an unknown topic is wrong usage that lists the topics and names the nearest") {
  const Desk desk;
  const check::ProgramRun near = desk.run("-help scenes");
  CHECK_EQUAL(near.status, 2);
  CHECK_EQUAL(near.output, "");
  CHECK_EQUAL(near.errors,
              "raytracer: -help: expected scene, course, materials, samples, output, inside, grid, "
              "parts, checkpoint, compare or limits, found 'scenes'; did you mean 'scene'?\n");
  const check::ProgramRun far = desk.run("-help zebra");
  CHECK_EQUAL(far.status, 2);
  CHECK(contains(far.errors, "compare or limits, found 'zebra'\n"));
  CHECK_EQUAL(desk.run("-help scene zebra").status, 2);
  CHECK_EQUAL(desk.run("-help ''").status, 2);
}
