"""A browser without a window, which tells what the page shows (window.cdcluster.facts())."""
import base64
import contextlib
import json
import struct
import time
import zlib
from urllib.parse import urlparse

from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

import os

WAIT_SECONDS = 60
WIDTH, HEIGHT = 1280, 860


def decode_png(data):
    """Returns the rows of a PNG of 8 bits as lists of (red, green, blue)."""
    at, packed, width, channels = 8, b"", 0, 3
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, _, _, colour = struct.unpack(">IIBB", body[:10])
            channels = {2: 3, 6: 4}[colour]
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    raw, rows = zlib.decompress(packed), []
    stride = width * channels
    before = bytearray(stride)
    for start in range(0, len(raw), stride + 1):
        method, line = raw[start], bytearray(raw[start + 1 : start + 1 + stride])
        for i in range(stride):
            left = line[i - channels] if i >= channels else 0
            up = before[i]
            corner = before[i - channels] if i >= channels else 0
            if method == 1:
                line[i] = (line[i] + left) & 255
            elif method == 2:
                line[i] = (line[i] + up) & 255
            elif method == 3:
                line[i] = (line[i] + (left + up) // 2) & 255
            elif method == 4:
                guess = left + up - corner
                near = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))
                line[i] = (line[i] + near[2]) & 255
        rows.append([tuple(line[i : i + 3]) for i in range(0, stride, channels)])
        before = line
    return rows


# Lets a page hear of a new address later.
SLOW_ADDRESS = """
addEventListener("hashchange", (event) => {
    if (event.isTrusted) {
        event.stopImmediatePropagation();
        setTimeout(() => dispatchEvent(new HashChangeEvent("hashchange")), %d);
    }
});
"""

# Lets a page read other JSON than the server sent.
LIE = """(() => {
    const ask = window.fetch;
    window.fetch = async (address, options) => {
        const answer = await ask(address, options);
        if (!String(address).endsWith(%s)) {
            return answer;
        }
        const json = await answer.json();
        %s;
        return new Response(JSON.stringify(json));
    };
})()"""


class Browser:
    """One tab. Collects the addresses of all requests and all messages of the console."""

    def __init__(self, pictures):
        options = Options()
        options.binary_location = "/usr/bin/chromium"
        for flag in (
            "--headless=new",
            "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader",
            f"--window-size={WIDTH},{HEIGHT}",
            "--force-device-scale-factor=1",
            "--ignore-certificate-errors",
        ):
            options.add_argument(flag)
        if os.geteuid() == 0:
            options.add_argument("--no-sandbox")
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service("/usr/bin/chromedriver"))
        self.driver.set_script_timeout(WAIT_SECONDS)
        self.driver.set_page_load_timeout(WAIT_SECONDS)
        self.pictures = pictures
        self.messages, self.addresses, self.origin = [], [], None
        self.size(WIDTH, HEIGHT)

    def close(self):
        self.driver.quit()

    def size(self, width, height, is_phone=False):
        self.driver.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": is_phone},
        )

    def colours(self, scheme):
        """Lets the system prefer light or dark."""
        self.driver.execute_cdp_cmd(
            "Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
        )

    def lie(self, path, change):
        """Pages that are opened within the block read other JSON from addresses that end with `path`: `change`, a
        statement in JavaScript, alters the value `json`."""
        return self.prepared(LIE % (json.dumps(path), change))

    def slow_address(self, milliseconds):
        """Pages that are opened within the block hear of a new address so much later."""
        return self.prepared(SLOW_ADDRESS % milliseconds)

    @contextlib.contextmanager
    def prepared(self, script):
        """Pages that are opened within the block run a script before their own."""
        script = self.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": script})
        try:
            yield
        finally:
            self.driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", script)

    def leave(self):
        """Closes the page, so that nothing is asked of a server that ends."""
        self.driver.get("about:blank")
        self.collect()

    def open(self, url):
        """Opens an address of a server anew."""
        self.leave()
        parts = urlparse(url)
        self.origin = f"{parts.scheme}://{parts.netloc}"
        self.driver.get(url)

    def go(self, link):
        """Follows a link within the page, as a click on it does."""
        self.driver.execute_script("location.hash = arguments[0]", link)

    def link(self):
        return self.driver.execute_script("return location.hash")

    def facts(self):
        return self.driver.execute_script("return window.cdcluster ? cdcluster.facts() : {ready: false}")

    def wait(self, what, condition):
        """Waits until the condition holds of the facts, and returns them."""
        end = time.monotonic() + WAIT_SECONDS
        while True:
            facts = self.facts()
            if facts.get("ready") and condition(facts):
                return facts
            if time.monotonic() > end:
                text = self.driver.find_element(By.TAG_NAME, "body").text
                raise AssertionError(f"{what} never came; facts: {json.dumps(facts)[:2000]}\npage: {text[:1500]}")
            time.sleep(0.03)

    def wait_text(self, text):
        end = time.monotonic() + WAIT_SECONDS
        while text not in (body := self.driver.find_element(By.TAG_NAME, "body").text):
            if time.monotonic() > end:
                raise AssertionError(f"'{text}' never came; the page says: {body[:2000]}")
            time.sleep(0.03)
        return body

    def wait_frames(self):
        """Waits until the page had the time to draw what has changed."""
        self.driver.execute_async_script(
            "const done = arguments[0]; let left = 5;"
            "const turn = () => (left-- > 0 ? requestAnimationFrame(turn) : done()); turn()"
        )

    def scenario(self, number):
        """Waits until this scenario is drawn."""
        return self.wait(f"scenario {number}", lambda facts: facts.get("scenario") == number)

    def press(self, key):
        ActionChains(self.driver).send_keys(key).perform()

    def press_and_draw(self, key):
        """Presses a key and waits for the frame that follows."""
        frames = self.facts()["frames"]
        self.press(key)
        return self.wait("a frame", lambda facts: facts["frames"] > frames)

    def click(self, x, y, shift=False):
        """Clicks a point of the page, in its pixels."""
        for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
            self.driver.execute_cdp_cmd(
                "Input.dispatchMouseEvent",
                {
                    "type": kind,
                    "x": x,
                    "y": y,
                    "button": "none" if kind == "mouseMoved" else "left",
                    "clickCount": 1,
                    "modifiers": 8 if shift else 0,
                },
            )

    def drag(self, start, end, button="left"):
        """Moves the mouse from one point of the page to another with a button held down."""
        held = {"left": 1, "right": 2}[button]
        steps = [("mousePressed", start, held), ("mouseMoved", end, held), ("mouseReleased", end, 0)]
        for kind, (x, y), buttons in steps:
            event = {"type": kind, "x": x, "y": y, "clickCount": 1, "button": button, "buttons": buttons}
            self.driver.execute_cdp_cmd("Input.dispatchMouseEvent", event)

    def turn_wheel(self, x, y, by):
        """Turns the mouse's wheel over a point of the page."""
        wheel = {"type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": by}
        self.driver.execute_cdp_cmd("Input.dispatchMouseEvent", wheel)

    def box(self, selector):
        """Returns left, top, width, height of an element, which is scrolled into view."""
        return self.driver.execute_script(
            # In a report, the viewer is in a tree of its own.
            "const tree = document.getElementById('page').shadowRoot ?? document;"
            "const e = tree.querySelector(arguments[0]); e.scrollIntoView({block: 'center'});"
            "const b = e.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]",
            selector,
        )

    def overflow(self):
        """Returns by how many pixels the document is wider than the window."""
        wide = "return document.documentElement.scrollWidth - document.documentElement.clientWidth"
        return self.driver.execute_script(wide)

    def colour(self, x, y):
        """Returns red, green, blue of a pixel of the window."""
        left, top = self.driver.execute_script("return [scrollX, scrollY]")
        clip = {"x": int(x + left), "y": int(y + top), "width": 1, "height": 1, "scale": 1}
        shot = self.driver.execute_cdp_cmd("Page.captureScreenshot", {"format": "png", "clip": clip})
        return decode_png(base64.b64decode(shot["data"]))[0][0]

    def picture(self, name):
        shot = self.driver.execute_cdp_cmd("Page.captureScreenshot", {"format": "png"})
        (self.pictures / f"{name}.png").write_bytes(base64.b64decode(shot["data"]))

    def picture_of(self, name, left, top, width, height):
        """Keeps a picture of a rectangle of the page."""
        clip = {"x": left, "y": top, "width": width, "height": height, "scale": 1}
        shot = self.driver.execute_cdp_cmd("Page.captureScreenshot", {"format": "png", "clip": clip})
        (self.pictures / f"{name}.png").write_bytes(base64.b64decode(shot["data"]))

    def collect(self):
        """Takes over what the browser noted since the last call."""
        self.messages += [f"{entry['level']}: {entry['message']}" for entry in self.driver.get_log("browser")]
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                self.addresses.append((self.origin, message["params"]["request"]["url"]))

    def forget(self):
        """Drops what the browser noted since the last call of `collect`."""
        self.driver.get_log("browser")
        self.driver.get_log("performance")
