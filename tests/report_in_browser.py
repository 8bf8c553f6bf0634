"""Drives the page of `raytracer -report` in a headless Chromium with real keys and clicks.

report_in_browser.py PAGE SCREENSHOT
PAGE has at least two pairs, the first with two different pictures. Prints what is wrong and exits
with 1, or prints "ok" and exits with 0; exits with 77 where no Chromium is installed. Speaks the
DevTools protocol over a pipe: messages of JSON, each ended by a zero byte, on descriptors 3 and 4.
"""
import base64
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

KEYS = {"Tab": 9, "ArrowRight": 39, "ArrowLeft": 37, " ": 32, "n": 78, "p": 80}


class Browser:
    def __init__(self, program, folder):
        to_read, self.to_browser = os.pipe()
        self.from_browser, to_write = os.pipe()
        to_read, to_write = [os.dup2(d, n) for d, n in ((to_read, 103), (to_write, 104))]

        def place_pipes():
            os.dup2(to_read, 3)
            os.dup2(to_write, 4)
        self.process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe",
             "--no-first-run", "--window-size=1000,1000", "--user-data-dir=" + folder],
            preexec_fn=place_pipes, close_fds=False,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        self.unread, self.number, self.session = b"", 0, None
        self.outside = []  # addresses that the page asked for

    def receive(self):
        while b"\0" not in self.unread:
            more = os.read(self.from_browser, 65536)
            if not more:
                raise RuntimeError("the browser ended")
            self.unread += more
        message, self.unread = self.unread.split(b"\0", 1)
        message = json.loads(message)
        if message.get("method") == "Network.requestWillBeSent":
            self.outside.append(message["params"]["request"]["url"][:60])
        return message

    def ask(self, method, **params):
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to_browser, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(method + ": " + str(answer["error"]))
                return answer["result"]

    def open(self, page):
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.ask("Network.enable")
        self.ask("Page.enable")
        self.ask("Page.navigate", url=page.as_uri())
        for _ in range(200):
            if self.value("document.readyState") == "complete":
                return
            time.sleep(0.05)
        raise RuntimeError("the page does not load")

    def value(self, expression):
        return self.ask("Runtime.evaluate", expression=expression, returnByValue=True)["result"].get("value")

    def press(self, key):
        text = key if len(key) == 1 else ""
        for kind in ("keyDown", "keyUp"):
            self.ask("Input.dispatchKeyEvent", type=kind, key=key, text=text if kind == "keyDown" else "",
                     code="Space" if key == " " else key, windowsVirtualKeyCode=KEYS[key])

    def click(self, selector):
        x, y = self.value("(() => { const e = document.querySelector('%s'); e.scrollIntoView();"
                          "const b = e.getBoundingClientRect();"
                          "return [b.x + b.width / 2, b.y + b.height / 2]; })()" % selector)
        for kind in ("mousePressed", "mouseReleased"):
            self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)


def check_page(browser, screenshot):
    wrong = []

    def check(expression, expected):
        found = browser.value(expression)
        if found != expected:
            wrong.append("%s: expected %r, found %r" % (expression, expected, found))
    above = "document.querySelector('.wipe').children[1].style.clipPath"
    slider = "document.querySelector('input[type=range]')"
    pressed = "document.querySelector('button').getAttribute('aria-pressed')"
    check("[...document.images].every(i => i.complete && i.naturalWidth > 0)", True)
    check("[...document.querySelectorAll('input, button')].every(e => e.getAttribute('aria-label'))", True)
    check("[...document.images].slice(0, 3).every(i => i.alt)", True)
    check(above, "inset(0px 50% 0px 0px)")
    shot = browser.ask("Page.captureScreenshot", format="png")["data"]
    pathlib.Path(screenshot).write_bytes(base64.b64decode(shot))
    browser.press("n")
    check("document.activeElement.id", "pair1")
    browser.press("Tab")
    check("document.activeElement === " + slider, True)
    browser.press("ArrowRight")
    check(slider + ".value", "51")
    check(above, "inset(0px 49% 0px 0px)")
    browser.press("ArrowLeft")
    browser.press("Tab")
    check("document.activeElement.textContent", "Blink")
    browser.press(" ")
    check(pressed, "true")
    seen = set()
    for _ in range(40):
        seen.add(browser.value(above))
        time.sleep(0.05)
    if seen != {"inset(0px 0% 0px 0px)", "inset(0px 100% 0px 0px)"}:
        wrong.append("blinking: found %r" % seen)
    browser.click("button")
    check(pressed, "false")
    check(above, "inset(0px 50% 0px 0px)")
    browser.press("n")
    check("document.activeElement.id", "pair2")
    browser.press("p")
    check("document.activeElement.id", "pair1")
    browser.value("(() => { const z = document.getElementById('zoom'); z.value = 4;"
                  "z.dispatchEvent(new Event('change')); })()")
    check("document.images[0].width / document.images[0].naturalWidth", 4)
    wrong += ["asks for " + url for url in browser.outside if not url.startswith(("data:", "file:"))]
    return wrong


def main():
    program = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not program:
        print("no Chromium is installed")
        return 77
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        browser = Browser(program, folder)
        try:
            browser.open(pathlib.Path(sys.argv[1]).resolve())
            wrong = check_page(browser, sys.argv[2])
        finally:
            browser.process.kill()
            browser.process.wait()
    print("\n".join(wrong) or "ok")
    return 1 if wrong else 0


sys.exit(main())
