// The page of a comparison: HTML with its pictures, style and script in one file.
#include <vector>

#include "cli/compare_output.h"

namespace {

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
    const part = timer ? (shown ? 100 : 0) : slider.value;
    above.style.clipPath = 'inset(0 ' + (100 - part) + '% 0 0)';
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

/// The text as it stands between tags and in attributes; control characters become U+FFFD.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\'')
      result += "&#39;";
    else if (static_cast<unsigned char>(c) < 32 || c == 127)
      result += "&#xFFFD;";
    else
      result += c;
  }
  return result;
}

std::string base64(const Bytes& bytes) {  // RFC 4648, section 4
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

std::string figure(const char* kind, const std::string& caption, const Bytes& png,
                   const std::string& name) {
  return "<figure><figcaption>" + caption + "</figcaption><img class=\"" + kind + "\" alt=\"" +
         kind + " picture of " + escaped(name) + "\" src=\"data:image/png;base64," + base64(png) +
         "\"></figure>\n";
}

std::string row(const char* name, const std::string& value) {
  return std::string("<tr><th scope=\"row\">") + name + "</th><td>" + escaped(value) +
         "</td></tr>\n";
}

std::string figureRows(const ComparedPair& pair) {
  std::string text = row("Expected", pair.expected) + row("Actual", pair.actual);
  if (!pair.figures) return text + row("Finding", pair.fault);
  const Comparison& f = *pair.figures;
  text += row("Size", std::to_string(pair.actualWidth) + " x " + std::to_string(pair.actualHeight));
  text += row("Maximum", std::to_string(f.maximum)) + row("Mean", numberText(f.mean)) +
          row("RMS", numberText(f.rms)) + row("PSNR in dB", numberText(f.psnr)) +
          row("Pixels over", std::to_string(f.pixelsOver) + " of " + std::to_string(f.pixels) +
                                 " (" + numberText(f.percentOver()) + " %)");
  if (f.maximum > 0) {
    text += row("Worst pixel", std::to_string(f.worstX) + " " + std::to_string(f.worstY));
  }
  if (f.pixelsOver > 0) {
    text += row("Box", std::to_string(f.boxX) + " " + std::to_string(f.boxY) + ", " +
                           std::to_string(f.boxWidth) + " x " + std::to_string(f.boxHeight));
  }
  return text;
}

std::string pictures(const ComparedPair& pair) {
  if (pair.expectedPng.empty()) return "";
  if (pair.actualPng.empty()) {
    return "<div class=\"pictures\">" +
           figure("expected", "expected and actual, which are equal", pair.expectedPng, pair.name) +
           "</div>\n";
  }
  const std::string name = escaped(pair.name);
  return "<div class=\"pictures\">" + figure("expected", "expected", pair.expectedPng, pair.name) +
         figure("actual", "actual", pair.actualPng, pair.name) +
         figure("difference", "difference, " + std::to_string(kDifferenceGain) + " times",
                pair.differencePng, pair.name) +
         "</div>\n<div class=\"compare\" hidden><div class=\"wipe\"><img alt=\"\"><img alt=\"\">"
         "</div>\n<div class=\"tools\"><label>actual <input type=\"range\" min=\"0\" max=\"100\" "
         "value=\"50\" aria-label=\"How much of the expected picture covers the actual one, " +
         name +
         "\"> expected</label>\n<button type=\"button\" aria-pressed=\"false\" "
         "aria-label=\"Blink between the two pictures, " +
         name + "\">Blink</button> <output></output></div></div>\n";
}

std::string section(const ComparedPair& pair, std::size_t number) {
  const std::string result = nameOf(pair.result), id = "pair" + std::to_string(number);
  return "<section class=\"" + result + "\" aria-labelledby=\"" + id + "\">\n<h2 id=\"" + id +
         "\" tabindex=\"0\">" + escaped(pair.name) + ": " + result + "</h2>\n<table>\n" +
         figureRows(pair) + "</table>\n" + pictures(pair) + "</section>\n";
}

}  // namespace

std::string reportPage(const std::vector<ComparedPair>& pairs, const CompareRequest& options) {
  std::size_t same = 0;
  for (const ComparedPair& pair : pairs) same += pair.result == ComparedPair::Result::same;
  std::string page = kHead;
  page += "<p>" + std::to_string(pairs.size()) + " pairs, " + std::to_string(same) +
          " of them the same within " + std::to_string(options.tolerance) +
          " of 255 levels in all but " + numberText(options.failPercent) +
          " % of the pixels. The worst come first.</p>\n"
          "<p>Keys: Tab goes on, n and p to the next and previous pair; arrows move a slider, the "
          "space bar starts and stops blinking. <label>Zoom <select id=\"zoom\"><option>1</option>"
          "<option>2</option><option>4</option><option>8</option></select></label></p>\n";
  for (std::size_t i = 0; i < pairs.size(); ++i) page += section(pairs[i], i + 1);
  return page + kScript + "</body></html>\n";
}
