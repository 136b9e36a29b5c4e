"""Tests the page in a real browser. Usage: page_test.py BIN_DIR OUT [NAME...]: runs the tests of the files
*_test.py beside this one whose names contain one of NAME, all by default."""
import importlib
import os
import pathlib
import sys
import tempfile
import time
import unittest

from page_case import PageTest

HERE = pathlib.Path(__file__).resolve()


class Notes(PageTest):
    """Runs last: looks at what the browser noted during all tests."""

    def test_no_request_left_its_origin_and_no_error_was_noted(self):
        self.browser.collect()
        foreign = [
            url
            for origin, url in self.browser.addresses
            if origin and not url.startswith((origin + "/", "data:", "blob:", "about:"))
        ]
        self.assertEqual(foreign, [])
        self.assertGreater(len(self.browser.addresses), 50)
        # Refusals that tests provoke are noted by the browser as failed requests.
        expected = ("401", "GPU stall", "GL Driver Message")
        (self.out / "console.txt").write_text("\n".join(self.browser.messages))
        told = [message for message in self.browser.messages if not any(word in message for word in expected)]
        self.assertEqual(told, [])


def tests_of(cases):
    if isinstance(cases, unittest.TestCase):
        yield cases
    else:
        for case in cases:
            yield from tests_of(case)


def chosen(names):
    files = sorted(path.stem for path in HERE.parent.glob("*_test.py") if path != HERE)
    load = unittest.defaultTestLoader
    suites = [load.loadTestsFromModule(importlib.import_module(name)) for name in files]
    suites.append(load.loadTestsFromTestCase(Notes))
    tests = [test for test in tests_of(suites) if not names or any(name in test.id() for name in names)]
    return unittest.TestSuite(tests)


def main(bin_dir, out, names):
    out.mkdir(parents=True, exist_ok=True)
    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="cd_web_") as folder:
        PageTest.begin(bin_dir, out, pathlib.Path(folder))
        try:
            result = unittest.TextTestRunner(verbosity=2).run(chosen(names))
        finally:
            PageTest.browser.close()
    for test, why in result.skipped:
        print(f"NOT RUN: {test.id()}: {why}")
    print(f"page_test: {time.monotonic() - begin:.0f} s")
    is_whole = not result.skipped or os.environ.get("CI") != "true"
    return 0 if result.wasSuccessful() and is_whole else 1


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:]))
