"""Tests that a page of another origin reads nothing of a server's."""
import http.server
import threading

from page_case import PageTest

SQUARE = b'<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><rect width="9" height="9"/></svg>'
# What the other server answers; its paths are those of the page.
CONTENT = {
    "/": ("text/html", b"<!doctype html><title>stranger</title><p id=page>stranger</p>"),
    "/icon.svg": ("image/svg+xml", SQUARE),
    "/app.js": ("text/javascript", b"window.isRead = true"),
    "/app.css": ("text/css", b"p { color: red }"),
    "/api/v1/cluster": ("application/json", b"{}"),
}
# Tries to read a server in every way that needs no click; tells of each whether it was 'read' or 'refused'.
TRY = """
const [home, key, done] = arguments;
const element = (name, values) => new Promise((resolve, reject) => {
    const made = Object.assign(document.createElement(name), values, { onload: resolve, onerror: reject });
    document.body.append(made);
});
const get = (path, options) => fetch(home + path, options).then((answer) => answer.text());
const ways = {
    "fetch": get("api/v1/cluster"),
    "fetch with the key": get("api/v1/cluster", { headers: { Authorization: `Bearer ${key}` } }),
    "fetch with cookies": get("api/v1/cluster", { credentials: "include" }),
    "fetch without CORS": get("api/v1/cluster", { mode: "no-cors" }),
    "fetch of the page": get(""),
    "picture": element("img", { src: home + "icon.svg" }),
    "script": element("script", { src: home + "app.js" }),
    "style": element("link", { rel: "stylesheet", href: home + "app.css" }),
};
const told = Object.entries(ways).map(([way, tried]) => tried.then(() => [way, "read"], () => [way, "refused"]));
Promise.all(told).then((all) => done(Object.fromEntries(all)));
"""


class Answers(http.server.BaseHTTPRequestHandler):
    def do_GET(self):
        kind, body = CONTENT.get(self.path, ("text/plain", b""))
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        pass


class Origins(PageTest):
    def setUp(self):
        stranger = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Answers)
        threading.Thread(target=stranger.serve_forever, daemon=True).start()
        self.addCleanup(stranger.server_close)
        self.addCleanup(stranger.shutdown)
        self.home = f"http://127.0.0.1:{stranger.server_port}/"

    def tearDown(self):
        self.browser.driver.get("about:blank")
        self.browser.forget()  # The stranger's requests, which leave its origin, and their refusals.

    def outcomes(self, home, key):
        self.browser.driver.get(self.home)
        outcomes = self.browser.driver.execute_async_script(TRY, home, key)
        for path in ("", "api/v1/cluster"):
            outcomes[f"frame of /{path}"] = "read" if self.is_framed(home + path) else "refused"
        return outcomes

    def is_framed(self, address):
        """Whether a frame shows what this server sends, rather than the browser's words."""
        driver = self.browser.driver
        show = (
            "const [address, done] = arguments; const frame = document.createElement('iframe');"
            "frame.onload = () => done(); frame.src = address; document.body.replaceChildren(frame)"
        )
        driver.execute_async_script(show, address)
        driver.switch_to.frame(driver.find_element("css selector", "iframe"))
        try:
            return driver.execute_script("return location.href") == address
        finally:
            driver.switch_to.default_content()

    def assert_refuses(self, home, key):
        self.browser.collect()
        allowed, refused = self.outcomes(self.home, key), self.outcomes(home, key)
        # The tries are right ones: the stranger's own server can be read in all these ways.
        self.assertEqual(set(allowed.values()), {"read"}, allowed)
        self.assertEqual(refused, dict.fromkeys(allowed, "refused"))

    def test_a_master_without_a_key_is_not_read(self):
        """A page of another origin reads nothing of a master on loopback, which asks for no key."""
        cluster = self.start_cluster("origins")
        self.assert_refuses(cluster.page, "")

    def test_a_folder_is_not_read_even_with_the_key(self):
        """A page of another origin reads nothing of `cdctl view`, though it knows the key."""
        server = self.view(self.scenes.one_pair())
        self.assert_refuses(server.home, server.key)
