// What is seen while a picture is traced: on a terminal, in a log, and in the picture's bytes.
#include "cli/run_display.h"

#include <algorithm>

#include "check.h"
#include "cli/desk.h"
#include "started_program.h"

using check::contains, check::contentOf, check::Desk, check::StartedProgram;

namespace {

constexpr const char* kHalf = "\xe2\x96\x80";

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) {
    ++count;
  }
  return count;
}

/// What a terminal of 30 x 10 characters gets from the program.
std::string onTerminal(const Desk& desk, const std::string& arguments) {
  if (std::system("command -v script >/dev/null 2>&1") != 0) SKIP("no script(1)");
  const std::string command =
      "stty cols 30 rows 10; " + check::quoted(check::programToTest()) + " " + arguments;
  const std::string whole = "cd " + check::quoted(desk.path()) + " && script -qec " +
                            check::quoted(command) + " /dev/null </dev/null >terminal";
  CHECK_EQUAL(std::system(whole.c_str()), 0);
  return contentOf(desk.file("terminal"));
}

}  // namespace

TEST("the line of progress tells percent, rays per second and the time left") {
  // 250 of 1000 rays in 2 s: 125 a second, and three times as long again.
  CHECK_EQUAL(progressText(250, 1000, 2), " 25 %, 125 eye rays/s, 6.0 s left");
  CHECK_EQUAL(progressText(5e6, 1e7, 20), " 50 %, 250.0 k eye rays/s, 20 s left");
  CHECK_EQUAL(progressText(1e7, 1e7, 5), "100 %, 2.00 M eye rays/s, 5.0 s");
  // 100 in 100 s, 600 more to go; 100 s are 1.67 minutes; a hundredth in 6 minutes is 9.9 hours.
  CHECK_EQUAL(progressText(100, 700, 100), " 14 %, 1 eye rays/s, 10 min left");
  CHECK_EQUAL(progressText(1000, 1000, 100), "100 %, 10 eye rays/s, 2 min");
  CHECK(contains(progressText(1, 100, 360), ", 9.9 h left"));
  CHECK(contains(progressText(999999, 1e6, 1), "99 %"));
  CHECK(contains(progressText(0, 1e6, 0), "  0 %"));
}

TEST("a log has no progress, and -progress insists") {
  const Desk desk;
  CHECK_EQUAL(desk.run("-input scene.txt -output a").errors, "");
  const check::ProgramRun run = desk.run("-input scene.txt -output b -progress");
  CHECK(contains(run.errors, "\rraytracer: 100 %"));
  CHECK_EQUAL(run.errors.back(), '\n');
  CHECK_EQUAL(countOf(run.errors, "\n"), 1u);
  CHECK_EQUAL(run.output, "");
  CHECK(contentOf(desk.file("a")) == contentOf(desk.file("b")));
  CHECK_EQUAL(desk.run("-input scene.txt -output a -progress -quiet").errors, "");
  CHECK(desk.run("-input scene.txt -output a -quiet -progress").errors != "");
}

TEST("progress comes at most ten times a second, and counts every ray of both passes") {
  const Desk desk;
  const check::ProgramRun run = desk.run(
      "-input scene.txt -size 300 300 -jittered_samples 16 -output a -normals n -progress -stats");
  const std::size_t start = run.output.find("seconds tracing: ") + 17;
  const double seconds = std::stod(run.output.substr(start));
  CHECK(double(countOf(run.errors, "\r")) <= 10 * seconds + 1);
  CHECK_EQUAL(countOf(run.errors, "100 %"), 1u);
}

TEST("a terminal sees progress unless -quiet") {
  const Desk desk;
  CHECK(contains(onTerminal(desk, "-input scene.txt -output a"), "\rraytracer: 100 %"));
  CHECK_EQUAL(onTerminal(desk, "-input scene.txt -output a -quiet"), "");
}

TEST("a signal ends the line of progress and leaves no litter") {
  const Desk desk;
  StartedProgram program("-input scene.txt -size 4000 4000 -threads 1 -output a -progress",
                         desk.path());
  while (program.isRunning() && !contains(contentOf(desk.file("said")), " %"))
    check::sleepMilliseconds(5);
  CHECK_EQUAL(program.end(SIGINT), 130);
  CHECK_EQUAL(contentOf(desk.file("said")).back(), '\n');
  CHECK_EQUAL(desk.fileCount(), 2u);  // the scene, and what was said
}

TEST("-preview prints the picture once where standard output is no terminal") {
  const Desk desk;
  // 100 x 100 pixels in 8 - 2 = 6 lines of two cells: 12 x 12 of them.
  const check::ProgramRun run = desk.run("-input scene.txt -preview", "COLUMNS=40 LINES=8");
  CHECK_EQUAL(run.status, 0);
  CHECK_EQUAL(countOf(run.output, kHalf), 72u);
  CHECK_EQUAL(countOf(run.output, "\n"), 6u);
  CHECK(!contains(run.output, "\033[6A"));
  CHECK_EQUAL(desk.fileCount(), 1u);
  desk.run("-input scene.txt -output a");
  desk.run("-input scene.txt -output b -preview");
  CHECK(contentOf(desk.file("a")) == contentOf(desk.file("b")));
}

TEST("-preview shows the first picture that is asked for, and the colours where none is") {
  const Desk desk;
  const auto shown = [&](const std::string& wanted) {
    const check::ProgramRun run =
        desk.run("-input scene.txt -size 20 20 -quiet " + wanted, "COLUMNS=40 LINES=30");
    CHECK_EQUAL(run.status, 0);
    return run.output.substr(0, run.output.rfind("\033[0m\n"));
  };
  const std::string colors = shown("-preview"), normals = shown("-preview -normals n");
  const std::string materials = shown("-preview -materials m"), heat = shown("-preview -heatmap h");
  const std::string filter = shown("-preview -box_filter 3 -render_filter f 1");
  const std::string samples = shown("-preview -render_samples s 3");
  const std::string all[] = {colors, normals, materials, heat, filter, samples};
  for (const std::string& one : all) {
    CHECK(contains(one, kHalf));
    CHECK_EQUAL(std::count(std::begin(all), std::end(all), one), 1);
  }
  CHECK(shown("-preview -output a -heatmap h -materials m -normals n") == colors);
  CHECK(shown("-preview -pixel_obj o -pixel 0 0").find(colors) == 0);
  CHECK(shown("-preview -materials m -heatmap h") == materials);
  CHECK(shown("-preview -heatmap h -box_filter 3 -render_filter f 1") == heat);
}

TEST("-preview shows a part of a picture as large as it is") {
  const Desk desk;
  const check::ProgramRun run =
      desk.run("-input scene.txt -preview -region 40 45 20 10 -output a", "COLUMNS=200 LINES=90");
  CHECK_EQUAL(countOf(run.output, kHalf), std::size_t(20 * 5));
}

TEST("a heat map has a line of progress of its own, and what renders nothing has none") {
  const Desk desk;
  const auto hundreds = [&](const std::string& wanted) {
    return countOf(desk.run("-input scene.txt -progress " + wanted).errors, "100 %");
  };
  CHECK_EQUAL(hundreds("-heatmap h -size 300 300 -jittered_samples 16"), 1u);
  CHECK_EQUAL(hundreds("-heatmap h -output a -materials m"), 2u);
  CHECK_EQUAL(hundreds("-materials m"), 1u);
  CHECK_EQUAL(hundreds("-pixel 1 1"), 0u);
  CHECK_EQUAL(hundreds("-render_filter f 1"), 0u);
}

TEST("-preview on a terminal is as large as the window, drawn in place, and whole at the end") {
  const Desk desk;
  const std::string seen = onTerminal(
      desk, "-input scene.txt -size 400 400 -jittered_samples 16 -threads 1 -preview -output a");
  // 10 - 2 = 8 lines of 16 characters, drawn so many times.
  CHECK_EQUAL(countOf(seen, kHalf) % (8 * 16), 0u);
  CHECK(countOf(seen, kHalf) >= 8 * 16);
  const check::ProgramRun last = desk.run(
      "-input scene.txt -size 400 400 -jittered_samples 16 -preview", "COLUMNS=30 LINES=10");
  std::string end;  // as the terminal gets it: with a carriage return before each line break
  for (const char c : last.output) end += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(seen.size() >= end.size() && seen.substr(seen.size() - end.size()) == end);
}

TEST("on a terminal a heat map follows the preview, and all else that is printed follows it") {
  const Desk desk;
  const std::string seen = onTerminal(
      desk, "-input scene.txt -size 200 200 -threads 1 -preview -output a -heatmap h -pixel 9 9");
  const std::size_t picture = seen.rfind(kHalf), line = seen.rfind("100 %");
  CHECK(picture != std::string::npos && line != std::string::npos && picture < line);
  CHECK(contains(seen.substr(line), "eye ray") && contains(seen.substr(line), "pixel 9 9 = "));
}

TEST("a cell of the preview is the mean of its pixels, the upper one in front") {
  // 4 x 4 pixels in 2 columns and 1 + 2 lines: 2 x 2 cells.
  Image image(4, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) image.setPixel(x, y, Rgb8{std::uint8_t(x < 2 ? 100 : 0), 0, 7});
  }
  image.setPixel(0, 3, Rgb8{200, 0, 7});  // the upper left cell: (3 * 100 + 200) / 4 = 125
  TerminalPicture picture(4, 4, {2, 3});
  CHECK_EQUAL(picture.lines(), 1);
  picture.add(image, {0, 0, 4, 4});
  CHECK_EQUAL(picture.text(), std::string("\033[38;2;125;0;7m\033[48;2;100;0;7m") + kHalf +
                                  "\033[38;2;0;0;7m\033[48;2;0;0;7m" + kHalf + "\033[0m\n");
}

TEST("a preview is never larger than the picture and never wider or higher than the window") {
  for (const int width : {1, 3, 100, 65535}) {
    for (const int height : {1, 2, 100, 65535}) {
      const TerminalPicture picture(width, height, {80, 24});
      CHECK(picture.lines() <= 22 && picture.lines() <= (height + 1) / 2);
      CHECK(countOf(picture.text(), kHalf) <= std::size_t(std::min(width, 80) * picture.lines()));
    }
  }
}
