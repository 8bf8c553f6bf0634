// What distributions install: the manual page, bash's completion, and where they are put.
#include <algorithm>
#include <sstream>

#include "check.h"
#include "cli/arguments.h"
#include "cli/desk.h"

using check::contains, check::contentOf, check::Desk, check::quoted, check::ScratchFolder;

namespace {

bool isInstalled(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

std::string outputOf(const ScratchFolder& folder, const std::string& command) {
  const std::string file = folder.file("said");
  const std::string whole = "{ " + command + "\n} >" + quoted(file) + " 2>&1 </dev/null";
  const int status = std::system(whole.c_str());
  const std::string output = contentOf(file);
  return status == 0 ? output : output + "status " + std::to_string(status);
}

/// What bash offers, in alphabetical order, for the last of the `words` behind the program's name;
/// "scene.txt" and "a folder/" lie in the current folder.
std::string offersFor(const std::string& words) {
  if (!isInstalled("bash")) SKIP("no bash");
  const Desk desk;
  desk.write("raytracer.bash", completionScript());
  std::filesystem::create_directory(desk.file("a folder"));
  desk.write("drive.bash",
             ". ./raytracer.bash\ncomplete -p raytracer >/dev/null || exit 9\n"
             "COMP_WORDS=(raytracer " +
                 words +
                 ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\nset -u\n_raytracer\n"
                 "printf '%s\\n' \"${COMPREPLY[@]-}\" | LC_ALL=C sort | paste -sd '|' -\n");
  std::string offers =
      outputOf(desk, "cd " + quoted(desk.path()) + " && bash --norc --noprofile ./drive.bash");
  if (!offers.empty() && offers.back() == '\n') offers.pop_back();
  return offers;
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) {
    ++count;
  }
  return count;
}

}  // namespace

TEST("bash completes the names of arguments, with one dash or two") {
  CHECK_EQUAL(offersFor("-weig"), "-weight");
  CHECK_EQUAL(offersFor("--weig"), "--weight");
  CHECK_EQUAL(offersFor("-normal"), "-normal|-normals");
  CHECK_EQUAL(offersFor("-zzz"), "");
  const std::string all = offersFor("''");
  for (const ArgumentRow& row : argumentTable()) {
    CHECK(contains("|" + all + "|", std::string("|-") + row.name + "|"));
  }
}

TEST("bash completes files and choices where the argument before wants them") {
  CHECK_EQUAL(offersFor("-input sce"), "scene.txt");
  CHECK_EQUAL(offersFor("-quiet --input a"), "a folder");
  CHECK_EQUAL(offersFor("-accel ''"), "fast|tree");
  CHECK_EQUAL(offersFor("-simd avx"), "avx2|avx512");
  CHECK_EQUAL(offersFor("-epsilon a"), "adaptive");
}

TEST("bash counts the words of an argument and begins anew behind them") {
  CHECK_EQUAL(offersFor("-size 3 -weig"), "");  // that is H
  CHECK_EQUAL(offersFor("-size 3 4 -weig"), "-weight");
  CHECK_EQUAL(offersFor("-depth 1 2 sc"), "scene.txt");
  CHECK_EQUAL(offersFor("-depth 1 2 d.tga -weig"), "-weight");
  CHECK_EQUAL(offersFor("-shadows -weig"), "-weight");
  CHECK_EQUAL(offersFor("-input scene.txt sc"), "");
}

TEST("bash completes files wherever the table of arguments speaks of them") {
  for (const char* before :
       {"-output", "-normals", "-depth 1 2", "-materials", "-heatmap", "-render_samples",
        "-render_filter", "-pixel_obj", "-checkpoint", "-compare", "-compare a", "-diff", "-report",
        "-csv", "-merge", "-merge a", "-merge a b", "-merge a b c"}) {
    CHECK_EQUAL(offersFor(std::string(before) + " sce"), "scene.txt");
  }
  for (const char* before : {"-pixel", "-region 1 2", "-tile", "-grid 1", "-memory_limit",
                             "-jittered_samples", "-render_samples a", "-tolerance"}) {
    CHECK_EQUAL(offersFor(std::string(before) + " ''"), "");
  }
  CHECK_EQUAL(offersFor("-merge a b -quie"), "-quiet");
}

TEST("bash completes topics of help, one at most") {
  CHECK_EQUAL(offersFor("-help s"), "samples|scene");
  CHECK_EQUAL(offersFor("-h lim"), "limits");
  CHECK_EQUAL(offersFor("-help -weig"), "-weight");
  CHECK_EQUAL(offersFor("-help scene -weig"), "-weight");
  CHECK_EQUAL(offersFor("-help scene sce"), "");
  std::vector<std::string_view> all;
  for (const HelpTopic& topic : helpTopics()) all.push_back(topic.name);
  CHECK_EQUAL(listed(findArgument("help")->action->choices), listed(all));
}

TEST("a checker of shell scripts finds no fault in bash's completion") {
  if (!isInstalled("shellcheck")) SKIP("no shellcheck");
  const Desk desk;
  const std::string script = quoted(desk.write("raytracer.bash", completionScript()));
  CHECK_EQUAL(outputOf(desk, "shellcheck -s bash " + script), "");
}

TEST("bash's completion knows every choice that the parser takes") {
  for (const ArgumentRow& row : argumentTable()) {
    for (const std::string_view choice : row.action->choices) {
      const auto takes = [&] {
        Draft draft;
        const std::vector<std::string> words = {std::string(choice), "1", "1"};
        row.action->apply(ArgumentWords(row, words), draft);  // throws where it does not
        return true;
      };
      CHECK(takes());
    }
  }
}

TEST("the manual page has every argument under its group, and troff finds no fault in it") {
  const std::string page = manPage();
  for (const HelpTopic& topic : helpTopics()) {
    std::string title = topic.name;
    for (char& c : title) c = char(std::toupper(static_cast<unsigned char>(c)));
    CHECK_EQUAL(countOf(page, "\n.SH " + title + "\n"), std::size_t(1));
  }
  for (const ArgumentRow& row : argumentTable()) {
    const std::string group = std::string(row.group).substr(0, std::string(row.group).find('('));
    CHECK_EQUAL(countOf(page, std::string(".TP\n\\fB\\-") + row.name + "\\fR"), std::size_t(1));
    CHECK_EQUAL(countOf(page, ".SS " + group), std::size_t(1));
  }
  const Desk desk;
  const std::string file = quoted(desk.write("raytracer.1", page));
  if (isInstalled("groff")) CHECK_EQUAL(outputOf(desk, "groff -man -Tutf8 -ww -z " + file), "");
  if (isInstalled("mandoc")) CHECK_EQUAL(outputOf(desk, "mandoc -Tlint -W warning " + file), "");
  if (isInstalled("man")) {
    CHECK_EQUAL(outputOf(desk, "man --warnings -l " + file + " 2>&1 >/dev/null"), "");
    const std::string shown = outputOf(desk, "MANWIDTH=80 man -P cat -l " + file + " | col -bx");
    CHECK(contains(shown, "-bounces N"));
    // Examples as they stand, to be copied.
    CHECK(
        contains(shown, "         Transform { Translate 0 0.5 -3   YRotate 20   Scale 2 1.5 0.1"));
    CHECK(contains(shown, "Matrix { F ^ 16 }"));
  }
}

TEST("the program prints its texts on standard output with status 0") {
  const Desk desk;
  for (const char* dashes : {"-", "--"}) {
    const auto printed = [&](const char* name) {
      const check::ProgramRun run = desk.run(std::string(dashes) + name);
      CHECK_EQUAL(run.status, 0);
      CHECK_EQUAL(run.errors, "");
      return run.output;
    };
    CHECK_EQUAL(printed("help"), fullHelp());
    CHECK_EQUAL(printed("h"), fullHelp());
    CHECK_EQUAL(printed("version"), versionText() + "\n");
    CHECK_EQUAL(printed("man"), manPage());
    CHECK_EQUAL(printed("completion"), completionScript());
  }
  CHECK_EQUAL(desk.run("").output, shortHelp());
  CHECK_EQUAL(desk.run("").status, 0);
  CHECK_EQUAL(desk.run("").errors, "");
}

TEST("an installation has program, manual page and completion in their places") {
  const std::string build = std::filesystem::path(check::programToTest()).parent_path();
  const bool hasTexts = std::filesystem::exists(build + "/share/raytracer.1");
  if (!isInstalled("cmake") || !hasTexts) SKIP("no cmake, or no texts built");
  const ScratchFolder folder;
  const std::string install = "DESTDIR=" + quoted(folder.file("root")) + " cmake --install " +
                              quoted(build) + " --prefix /usr >/dev/null";
  CHECK_EQUAL(outputOf(folder, install), "");
  const std::string usr = folder.file("root") + "/usr/";
  std::size_t files = 0;
  for (const auto& each : std::filesystem::recursive_directory_iterator(usr)) {
    files += each.is_regular_file();
  }
  CHECK_EQUAL(files, std::size_t(3));
  CHECK_EQUAL(outputOf(folder, quoted(usr + "bin/raytracer") + " -version"), versionText() + "\n");
  CHECK_EQUAL(contentOf(usr + "share/man/man1/raytracer.1"), manPage());
  CHECK_EQUAL(contentOf(usr + "share/bash-completion/completions/raytracer"), completionScript());
}
