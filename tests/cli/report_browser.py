#!/usr/bin/env python3
"""What a browser makes of a report: report_browser.py PAGE.html

Drives headless Chromium by WebDriver (W3C; chromedriver), uses the page as a reader would and
prints what was seen as JSON. Screenshots of the pictures go into the working folder.
"""

import base64
import json
import pathlib
import shutil
import subprocess
import sys
import time
import urllib.request

OPTIONS = [
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--hide-scrollbars",
    "--window-size=1200,900",
    "--force-device-scale-factor=1",
]
KEYS = {
    "left": "\ue012",
    "right": "\ue014",
    "home": "\ue011",
    "end": "\ue010",
    "space": " ",
    "tab": "\ue004",
}


class Browser:
    def __init__(self):
        self.driver = subprocess.Popen(
            ["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True
        )
        for line in self.driver.stdout:
            if "on port " in line and "started" in line:
                port = int(line.rsplit("on port ", 1)[1].strip(" .\n"))
                break
        else:
            raise RuntimeError("chromedriver did not start")
        self.base = f"http://127.0.0.1:{port}/session"
        wanted = {"goog:chromeOptions": {"args": OPTIONS}, "goog:loggingPrefs": {"browser": "ALL"}}
        answer = self.send("POST", "", {"capabilities": {"alwaysMatch": wanted}})
        self.base += "/" + answer["sessionId"]

    def send(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        headers = {"Content-Type": "application/json"}
        request = urllib.request.Request(self.base + path, data, headers, method=method)
        with urllib.request.urlopen(request, timeout=60) as answer:
            return json.load(answer)["value"]

    def close(self):
        try:
            self.send("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()

    def open(self, page):
        self.send("POST", "/url", {"url": pathlib.Path(page).resolve().as_uri()})

    def run(self, script):
        return self.send("POST", "/execute/sync", {"script": script, "args": []})

    def press(self, *keys):
        strokes = [
            {"type": kind, "value": KEYS[key]} for key in keys for kind in ("keyDown", "keyUp")
        ]
        self.send(
            "POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": strokes}]}
        )

    def drag(self, start, end):
        def move(at):
            return {"type": "pointerMove", "duration": 30, "x": round(at[0]), "y": round(at[1])}

        down, up = ({"type": kind, "button": 0} for kind in ("pointerDown", "pointerUp"))
        mouse = {
            "type": "pointer",
            "id": "mouse",
            "parameters": {"pointerType": "mouse"},
            "actions": [move(start), down, move(end), up],
        }
        self.send("POST", "/actions", {"actions": [mouse]})

    def element(self, css):
        found = self.send("POST", "/element", {"using": "css selector", "value": css})
        return next(iter(found.values()))

    def box(self, css):
        self.run(f"document.querySelector('{css}').scrollIntoView({{block: 'center'}})")
        return self.run(
            f"const b = document.querySelector('{css}').getBoundingClientRect();"
            "return [b.left, b.top, b.width, b.height]"
        )

    def picture_of(self, css, file):
        self.run(f"document.querySelector('{css}').scrollIntoView({{block: 'center'}})")
        png = self.send("GET", f"/element/{self.element(css)}/screenshot")
        pathlib.Path(file).write_bytes(base64.b64decode(png))

    def developer(self, command, **parameters):
        self.send("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})


def words(browser):
    return browser.run("return document.querySelector('.time output')?.textContent ?? ''")


def use(browser, page):
    seen = {}
    browser.open(page)
    seen["title"] = browser.run("return document.title")
    seen["text"] = browser.run("return document.body.innerText")
    if browser.run("return document.querySelector('.stage') !== null"):
        use_viewer(browser, seen)
    seen["outside"] = browser.run(
        "return performance.getEntriesByType('resource').map(e => e.name)"
        ".filter(name => !name.startsWith('data:'))"
    )
    seen["widths"] = narrow_widths(browser)
    browser.picture_of("body", "narrow.png")
    browser.developer(
        "Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}]
    )
    seen["dark"] = browser.run("return getComputedStyle(document.body).backgroundColor")
    seen["console"] = [
        entry["message"] for entry in browser.send("POST", "/se/log", {"type": "browser"})
    ]
    return seen


def use_viewer(browser, seen):
    browser.picture_of(".stage", "first.png")
    seen["first"] = words(browser)
    browser.press("right")
    seen["right"] = words(browser)
    browser.press("end")
    seen["end"] = words(browser)
    browser.picture_of(".stage", "last.png")
    browser.press("home", "left")
    seen["home"] = words(browser)
    left, top, width, height = browser.box("#time")
    if width > 0:
        browser.drag((left + 8, top + height / 2), (left + width - 2, top + height / 2))
        seen["dragged"] = words(browser)
        browser.press("home")
        seen["dragged home"] = words(browser)
        browser.run("document.activeElement.blur()")
        browser.press("space")
        seen["playing"] = wait_for_change(browser, seen["dragged home"])
        browser.press("space")
        seen["paused"] = browser.run(
            "return document.getElementById('play').getAttribute('aria-label')"
        )
        browser.press("home")
    if browser.run("return document.querySelector('.handle') !== null"):
        use_wipe(browser, seen)


def wait_for_change(browser, before):
    give_up = time.monotonic() + 10
    while words(browser) == before and time.monotonic() < give_up:
        time.sleep(0.05)
    return words(browser)


def use_wipe(browser, seen):
    left, top, width, height = browser.box(".stage")
    middle = top + height / 2
    browser.drag((left + width / 2, middle), (left + 0.2 * width, middle))
    seen["wiped"] = browser.run(
        "return document.querySelector('.handle').getAttribute('aria-valuenow')"
    )
    browser.picture_of(".stage", "wiped.png")
    browser.run("document.querySelector('.handle').focus()")
    browser.press("right", "right")
    seen["wiped by keys"] = browser.run(
        "return document.querySelector('.handle').getAttribute('aria-valuenow')"
    )
    seen["frame after wiping"] = words(browser)
    for view in ("side", "only-0", "only-1"):
        browser.run(f"document.querySelector('input[value={view}]').click()")
        browser.picture_of(".stage", f"{view}.png")
    left, top, width, height = browser.box(".stage")
    browser.drag((left + 0.1 * width, top + height / 2), (left + 0.95 * width, top + height / 2))
    seen["picture dragged"] = words(browser)


def narrow_widths(browser):
    """The width of a telephone, and of what stands on it with all parameters shown."""
    browser.developer(
        "Emulation.setDeviceMetricsOverride",
        width=360,
        height=740,
        deviceScaleFactor=1,
        mobile=True,
    )
    browser.run("const all = document.getElementById('all'); if (all) all.checked = true;")
    return browser.run(
        "return [innerWidth, document.documentElement.scrollWidth, document.body.scrollWidth]"
    )


def main():
    if not (shutil.which("chromedriver") and shutil.which("chromium")):
        sys.exit("chromedriver or chromium is missing")
    browser = Browser()
    try:
        print(json.dumps(use(browser, sys.argv[1]), indent=1))
    finally:
        browser.close()


main()
