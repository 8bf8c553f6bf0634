// The page of a comparison: HTML with its pictures, style and script in one file. It is put
// together from templates, in which $1 to $9 stand for the values that filled() puts there. Without
// the script the page still shows all figures and pictures; what needs it is hidden.
#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <tuple>

#include "cli/compare.h"
#include "image/picture_file.h"

namespace {

/// The browser is told to load nothing from outside, and to run no script but the one below.
constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:;
 style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width"><title>Compared pictures</title>
<style>
 body { font: 15px/1.4 sans-serif; margin: 1.5em; color: #222; background: #f6f6f4; }
 section { background: #fff; border: 1px solid #ccc; border-left: 6px solid #888;
  padding: .2em 1em 1em; margin: 1em 0; }
 section.different, section.missing, section.unexpected, section.unreadable {
  border-left-color: #b3261e; }
 section.same { border-left-color: #2e7d32; }
 h2 { font-size: 1.1em; overflow-wrap: anywhere; } table { border-collapse: collapse; }
 td, th { padding: .15em .8em .15em 0; text-align: left; overflow-wrap: anywhere; }
 .pictures { display: flex; flex-wrap: wrap; gap: 1em; } figure { margin: 0; }
 img { display: block; image-rendering: pixelated; }
 .wipe { position: relative; display: inline-block; margin-top: 1em; }
 .wipe img + img { position: absolute; left: 0; top: 0; }
 .tools { margin: .4em 0; } input[type=range] { width: 20em; max-width: 80%; }
 :focus-visible { outline: 3px solid #1565c0; outline-offset: 2px; }
</style></head><body>
<h1>Compared pictures</h1>
)";

constexpr const char* kScript = R"(<script>
'use strict';
const zoom = document.getElementById('zoom');
function resize() {
  for (const image of document.images) {
    image.style.width = image.naturalWidth * zoom.value + 'px';
  }
}
zoom.addEventListener('change', resize);
window.addEventListener('load', resize);
for (const tool of document.querySelectorAll('.compare')) {
  const source = name => tool.parentNode.querySelector('img.' + name).src;
  const wipe = tool.querySelector('.wipe'), slider = tool.querySelector('input');
  const blink = tool.querySelector('button'), state = tool.querySelector('output');
  const below = wipe.children[0], above = wipe.children[1];
  below.src = source('actual');
  above.src = source('expected');
  let timer = 0, shown = true;
  function draw() {
    const share = timer ? (shown ? 100 : 0) : slider.value;
    above.style.clipPath = 'inset(0 ' + (100 - share) + '% 0 0)';
    state.textContent = timer ? (shown ? 'expected' : 'actual')
      : 'expected ' + slider.value + ' %, actual ' + (100 - slider.value) + ' %';
  }
  slider.addEventListener('input', draw);
  blink.addEventListener('click', () => {
    if (timer) { clearInterval(timer); timer = 0; }
    else timer = setInterval(() => { shown = !shown; draw(); }, 500);
    blink.setAttribute('aria-pressed', String(timer !== 0));
    draw();
  });
  tool.hidden = false;
  draw();
}
const titles = [...document.querySelectorAll('h2')];
document.addEventListener('keydown', event => {
  const step = event.key === 'n' ? 1 : event.key === 'p' ? -1 : 0;
  if (!step || event.ctrlKey || event.altKey || event.metaKey || !titles.length) return;
  const here = titles.findIndex(title => title.parentNode.contains(document.activeElement));
  const next = here < 0 && step < 0 ? titles.length - 1 : here + step;
  const title = titles[Math.max(0, Math.min(titles.length - 1, next))];
  title.focus();
  title.scrollIntoView();
});
</script>
)";

constexpr const char* kIntroduction = R"(<p>$1 pairs, $2 of them the same within $3 of 255 levels
in all but $4 % of the pixels. The worst come first.</p>
<p>Keys: Tab goes on, n and p to the next and previous pair; arrows move a slider, the space bar
starts and stops blinking. <label>Zoom <select id="zoom"><option>1</option><option>2</option>
<option>4</option><option>8</option></select></label></p>
)";

/// Number, result, name, rows of the table, pictures.
constexpr const char* kSection = R"(<section class="$2" aria-labelledby="pair$1">
<h2 id="pair$1" tabindex="0">$3: $2</h2>
<table>
$4</table>
$5</section>
)";

/// Name and value of a figure.
constexpr const char* kRow = R"(<tr><th scope="row">$1</th><td>$2</td></tr>
)";

/// Class, caption, name, PNG in base 64.
constexpr const char* kFigure = R"(<figure><figcaption>$2</figcaption>
<img class="$1" alt="$1 picture of $3" src="data:image/png;base64,$4"></figure>
)";

/// Two pictures, which the script fills in, one on the other, with the tools to tell them apart.
/// Their name.
constexpr const char* kWipe = R"(<div class="compare" hidden>
<div class="wipe"><img alt=""><img alt=""></div>
<div class="tools"><label>actual <input type="range" min="0" max="100" value="50"
 aria-label="How much of the expected picture covers the actual one, $1"> expected</label>
<button type="button" aria-pressed="false"
 aria-label="Blink between the two pictures, $1">Blink</button> <output></output></div></div>
)";

/// The template with its values, of which there are 9 at most. They may hold a $ themselves.
std::string filled(const char* text, std::initializer_list<std::string> values) {
  std::string result;
  for (; *text != '\0'; ++text) {
    if (*text == '$') {
      result += values.begin()[*++text - '1'];
    } else {
      result += *text;
    }
  }
  return result;
}

/// As it stands between tags and in attributes. Control characters become U+FFFD.
std::string escaped(const std::string& text) {
  static constexpr std::string_view kSpecial = "&<>\"'";
  static constexpr std::string_view kEntities[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string result;
  for (const char c : text) {
    const std::size_t special = kSpecial.find(c);
    const bool isControl = static_cast<unsigned char>(c) < 32 || c == 127;
    if (special < kSpecial.size()) {
      result += kEntities[special];
    } else {
      result += isControl ? "&#xFFFD;" : std::string(1, c);
    }
  }
  return result;
}

/// Three bytes are four digits of 6 bits, the last ones filled up with '='. RFC 4648, section 4.
std::string base64(const Bytes& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < count ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

/// The figures as rows of the table, and why there are none.
std::string rowsOf(const ComparedPair& pair, const CompareRequest& request) {
  std::vector<Figure> figures = figuresOf(pair, request);
  if (!pair.fault.empty()) figures.push_back({"finding", pair.fault});
  std::string rows;
  for (const Figure& figure : figures) {
    rows += filled(kRow, {figure.name, escaped(figure.value)});
  }
  return rows;
}

/// What is alone or unreadable before other sizes, and these before other pixels. Greater is worse.
auto badnessOf(const ComparedPair& pair) {
  const int kind = pair.isAtFault() ? 2 : int(pair.result);
  const bool otherSize = !pair.comparison && !pair.isAtFault();
  const Comparison figures = pair.comparison.value_or(Comparison());
  return std::make_tuple(kind, otherSize, figures.percentOver(), figures.rms);
}

bool isWorse(const ComparedPair& a, const ComparedPair& b) {
  const auto p = badnessOf(a), q = badnessOf(b);
  return p != q ? p > q : a.name < b.name;
}

}  // namespace

std::string reportFigures(const ReadPicture& expected, const ReadPicture& actual,
                          const ComparedPair& pair) {
  const std::string name = escaped(pair.name), end = "</div>\n";
  std::string text = "<div class=\"pictures\">";
  const auto add = [&](const char* kind, const std::string& caption, const Image& image) {
    const Bytes png = encodePicture(image, PictureFormat::png);
    text += filled(kFigure, {kind, caption, name, base64(png)});
  };
  if (pair.comparison && pair.comparison->maximum == 0) {
    add("expected", "expected and actual, which are equal", expected.image);
    return text + end;
  }
  add("expected", "expected", expected.image);
  add("actual", "actual", actual.image);
  add("difference", joined("difference, ", kDifferenceGain, " times"),
      differencePicture(expected, actual));
  return text + end + filled(kWipe, {name});
}

/// Pairs are numbered from 1 on; their headings are what the keys go to. The script comes last:
/// what it works on is then there.
std::string reportPage(std::vector<ComparedPair> pairs, const CompareRequest& request) {
  std::stable_sort(pairs.begin(), pairs.end(), isWorse);
  const auto same = std::count_if(pairs.begin(), pairs.end(), [](const ComparedPair& pair) {
    return pair.result == ComparedPair::Result::same;
  });
  std::string page = kHead;
  page += filled(kIntroduction, {joined(pairs.size()), joined(same), joined(request.tolerance),
                                 joined(request.failPercent)});
  for (const ComparedPair& pair : pairs) {
    page += filled(kSection, {joined(&pair - pairs.data() + 1), nameOf(pair.result),
                              escaped(pair.name), rowsOf(pair, request), pair.figures});
  }
  return page + kScript + "</body></html>\n";
}
