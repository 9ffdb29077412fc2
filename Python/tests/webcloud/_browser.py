# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A page in headless Chromium, driven by the DevTools protocol over pipes; tests skip without it."""

import base64
import fcntl
import itertools
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

import pytest

OPTIONS = (
    "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--hide-scrollbars", "--no-first-run", "--disable-extensions", "--disable-background-networking",
    "--remote-debugging-pipe", "--force-device-scale-factor=1", "--disable-dev-shm-usage",
)  # fmt: skip
PATIENCE = 120.0  # [s], for a busy computer


def find_chromium():
    """The browser; skips the test if there is none."""
    found = shutil.which("chromium") or shutil.which("chromium-browser")
    if not found:
        pytest.skip("chromium is not installed: apt-get install chromium")
    return found


def _move(descriptor):
    """The same file at a number that is not one of the browser's, 3 and 4."""
    moved = fcntl.fcntl(descriptor, fcntl.F_DUPFD, 10)
    os.close(descriptor)
    return moved


class Browser:
    """One page. ``errors`` has the uncaught errors of its scripts, ``requests`` the URLs it asks for."""

    def __init__(self, width=1000, height=700):
        self._folder = tempfile.TemporaryDirectory()
        (take, self._write), (self._read, give) = os.pipe(), os.pipe()
        take, give = (_move(descriptor) for descriptor in (take, give))
        command = ["bash", "-c", f'exec "$0" "$@" 3<&{take} 4>&{give}', find_chromium(), *OPTIONS]
        command += [f"--user-data-dir={self._folder.name}", f"--window-size={width},{height}"]
        self._process = subprocess.Popen(
            [*command, "about:blank"], pass_fds=(take, give),
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        os.close(take)
        os.close(give)
        self._numbers, self._bytes, self._session = itertools.count(1), b"", None
        self.errors, self.requests = [], []
        target = next(
            each for each in self.call("Target.getTargets")["targetInfos"] if each["type"] == "page"
        )
        self._session = self.call(
            "Target.attachToTarget", targetId=target["targetId"], flatten=True
        )["sessionId"]
        for domain in ("Page", "Runtime", "Network"):
            self.call(f"{domain}.enable")
        self.call(
            "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
            mobile=False,
        )  # fmt: skip

    def call(self, method, **parameters):
        """The result of a method of the protocol."""
        number = next(self._numbers)
        message = {"id": number, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        end = time.monotonic() + PATIENCE
        while True:
            answer = self._receive(end)
            if answer.get("id") == number:
                assert "error" not in answer, answer
                return answer["result"]

    def _receive(self, end):
        while b"\0" not in self._bytes:
            ready, _, _ = select.select([self._read], [], [], max(0, end - time.monotonic()))
            assert ready, "the browser does not answer"
            part = os.read(self._read, 1 << 20)
            assert part, "the browser has ended"
            self._bytes += part
        text, _, self._bytes = self._bytes.partition(b"\0")
        answer = json.loads(text)
        if answer.get("method") == "Runtime.exceptionThrown":
            details = answer["params"]["exceptionDetails"]
            self.errors.append(details.get("exception", details).get("description", "")[:500])
        if answer.get("method") == "Network.requestWillBeSent":
            self.requests.append(answer["params"]["request"]["url"][:100])
        return answer

    def open(self, path):
        """Loads a file."""
        self.call("Page.navigate", url=path.absolute().as_uri())

    def evaluate(self, script):
        """The value of an expression, which may be a promise."""
        result = self.call(
            "Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True
        )
        assert "exceptionDetails" not in result, str(result["result"])[:500]
        return result["result"].get("value")

    def wait(self, condition, seconds=PATIENCE):
        """Waits until an expression is true; returns its value."""
        end = time.monotonic() + seconds
        while not (value := self.evaluate(condition)):
            assert time.monotonic() < end, f"{condition} is not true: {self.errors}"
            time.sleep(0.03)
        return value

    def mouse(self, kind, x, y, **more):
        """A mouse event of the protocol: mousePressed, mouseReleased, mouseMoved or mouseWheel."""
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, x, y, button="left", clickCount=1)

    def drag(self, start, end, **more):
        self.mouse("mousePressed", *start, button="left", clickCount=1, **more)
        self.mouse("mouseMoved", *end, button="left", buttons=1, **more)
        self.mouse("mouseReleased", *end, button="left", clickCount=1, **more)

    def key(self, key):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key)

    def screenshot(self):
        """The page as PNG."""
        return base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])

    def close(self):
        self._process.terminate()
        self._process.wait(30)
        os.close(self._read)
        os.close(self._write)
        shutil.rmtree(self._folder.name, ignore_errors=True)
        self._folder.cleanup()
