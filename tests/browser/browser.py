"""Debian's Chromium, driven through its own driver: no window, no network of its own."""

import json
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

SWITCHES = (
    "--headless=new",
    "--no-sandbox",  # a container's root has none
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",  # a container's is small
    "--hide-scrollbars",
)


class Browser:
    """One browser with a profile of its own in an empty folder."""

    def __init__(self, profile, script=True):
        options = Options()
        options.binary_location = "/usr/bin/chromium"
        for switch in (*SWITCHES, f"--user-data-dir={profile}"):
            options.add_argument(switch)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        self.script = script
        self.command("Emulation.setScriptExecutionDisabled", value=not script)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def command(self, name, **arguments):
        """One of the DevTools protocol's."""
        return self.driver.execute_cdp_cmd(name, arguments)

    def open(self, page, width=1280, height=900, scheme="light"):
        """Opens a file."""
        self.visit(page.as_uri(), width, height, scheme)

    def visit(self, address, width=1280, height=900, scheme="light"):
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height,
                     deviceScaleFactor=1, mobile=width < 600)
        self.command("Emulation.setEmulatedMedia",
                     features=[{"name": "prefers-color-scheme", "value": scheme}])
        self.driver.get_log("browser")
        self.driver.get_log("performance")
        self.driver.get(address)

    def run(self, script, *arguments):
        """What a script returns; works in a page whose own scripts are off, too."""
        if self.script:
            return self.driver.execute_script(script, *arguments)
        result = self.command("Runtime.evaluate", expression=f"(() => {{ {script} }})()",
                              returnByValue=True)
        return result["result"].get("value")

    def words(self):
        """What the page said on the console: errors, warnings, anything."""
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self):
        """Every address that was asked for."""
        found = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                found.append(message["params"]["request"]["url"])
        return found

    def take_picture(self, file, full=False):
        size = self.run("return [innerWidth, document.documentElement.scrollHeight, innerHeight]")
        if full:
            self.command("Emulation.setDeviceMetricsOverride", width=size[0],
                         height=min(size[1], 6000), deviceScaleFactor=1, mobile=size[0] < 600)
            time.sleep(0.2)  # for pictures that were out of sight
        file.write_bytes(self.driver.get_screenshot_as_png())
        if full:
            self.command("Emulation.setDeviceMetricsOverride", width=size[0], height=size[2],
                         deviceScaleFactor=1, mobile=size[0] < 600)
