"""A headless Chromium with the questions that the tests of the reports ask it, and how such tests are run."""

import json
import os
import pathlib
import shutil
import socket
import sys
import tempfile
import time
import traceback

BROWSER = shutil.which("chromium")
DRIVER = shutil.which("chromedriver")
ABSENT = 77  # exit status where there is no browser

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    webdriver = None


def require():
    """Ends the program with ABSENT where the browser cannot be had."""
    for name, found in (("chromium", BROWSER), ("chromium-driver", DRIVER), ("python3-selenium", webdriver)):
        if not found:
            print(f"{name} is not installed (tools/install-packages --tests)")
            sys.exit(ABSENT)
    try:
        socket.gethostbyname("localhost")  # by which the driver and the browser talk
    except OSError:
        print("this system does not know the name localhost (/etc/hosts)")
        sys.exit(ABSENT)


class Browser:
    def __init__(self):
        os.environ.setdefault("HOME", tempfile.gettempdir())  # Chromium needs one
        options = webdriver.ChromeOptions()
        options.binary_location = BROWSER
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                         "--hide-scrollbars", "--force-device-scale-factor=1", "--window-size=1400,1000"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.driver.set_script_timeout(20)

    def close(self):
        self.driver.quit()

    def emulate(self, **features):
        """emulate(prefers_color_scheme="dark"); what is not given is as usual."""
        wanted = [{"name": name.replace("_", "-"), "value": value} for name, value in features.items()]
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": wanted})

    def size(self, width, height):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def load(self, file, fragment=""):
        self.driver.get("about:blank")
        self.driver.get(file.resolve().as_uri() + fragment)

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def texts(self, selector):
        return self.run("return [...document.querySelectorAll(arguments[0])].map((e) => e.textContent)", selector)

    def press(self, key):
        """To what has the focus."""
        self.driver.switch_to.active_element.send_keys(key)

    def actions(self):
        return webdriver.ActionChains(self.driver, duration=20)

    def wait(self, script, *arguments, seconds=15):
        """Until the script returns something true, which is the result."""
        return WebDriverWait(self.driver, seconds, 0.02).until(lambda _: self.run(script, *arguments), script)

    def screenshot(self, file):
        self.driver.save_screenshot(str(file))

    def complaints(self):
        """Messages on the console that are warnings or errors, since the last call."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]

    def requests(self):
        """Addresses asked for since the last call."""
        found = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                found.append(message["params"]["request"]["url"])
        return found

    def escape(self):
        """Presses Escape and gives the page time for what follows from it: closing is told after it has happened."""
        self.press(Keys.ESCAPE)
        for _ in range(100):
            if self.run("return !document.querySelector('dialog[open]') && !document.querySelector('#detail > *')"):
                return
            time.sleep(0.02)


def check(page, function, folder):
    """Runs one test in a browser of a fresh page. True if it passed and the page complained of nothing."""
    page.emulate()
    page.size(1400, 1000)
    try:
        page.complaints(), page.requests()
        function(page, folder)
        complaints = page.complaints()
        assert not complaints, complaints
        outside = [url for url in page.requests() if not url.startswith(("file:", "data:", "blob:", "about:"))]
        assert not outside, outside
    except Exception:
        page.screenshot(folder / f"failed_{function.__name__}.png")
        print(f"FAILED: {function.__name__}")
        traceback.print_exc(file=sys.stdout)
        return False
    print(f"passed: {function.__name__}")
    return True


def main(tests):
    """The program of a file of tests: PROGRAM FOLDER [TEST...]"""
    require()
    folder = pathlib.Path(sys.argv[1])
    names = sys.argv[2:]
    page = Browser()
    try:
        passed = [check(page, function, folder) for function in tests if not names or function.__name__ in names]
    finally:
        page.close()
    print(f"{sum(passed)} of {len(passed)} passed; screenshots in {folder}")
    sys.exit(0 if passed and all(passed) else 1)
