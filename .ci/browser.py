#!/usr/bin/env python3
"""Opens the pages of an audit in headless Chromium, and fails when a reader would be let down.

    .ci/browser.py FOLDER [SCREENSHOTS]

FOLDER holds the pages of `subcert audit --format html -o FOLDER` or of `atlas`, and of `explain` and `depth`. Nothing may be written to the console or
loaded from elsewhere, no box may stand outside the window, anchors open their cells, filters hide what they
should, certificates unfold, pictures have words, and all of it works by the keyboard alone and without scripts. With SCREENSHOTS, each page is drawn
there at 390 and at 1280 pixels, light and dark. Chromium comes from Debian where it is missing; it is
driven by its own protocol over a pipe, so that Python needs no packages.
"""

import base64
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from urllib.parse import quote

PHONE, DESKTOP = (390, 844), (1280, 900)
NAMES = ["chromium", "chromium-browser", "google-chrome"]


def browser() -> str:
    found = next(filter(None, map(shutil.which, NAMES)), None)
    if found:
        return found
    sudo = [] if os.geteuid() == 0 else ["sudo"]
    subprocess.run([*sudo, "apt-get", "update", "-qq"], check=True)
    subprocess.run(
        [*sudo, "apt-get", "install", "-y", "-qq", "--no-install-recommends", "chromium", "fonts-dejavu-core"],
        check=True,
    )
    return shutil.which("chromium") or sys.exit("apt-get has installed no chromium")


class Chromium:
    """A browser with one tab. Messages are JSON texts that end with a zero byte."""

    def __init__(self, profile: str):
        read, theirs_out = os.pipe()
        theirs_in, write = os.pipe()

        def descriptors():
            # The protocol wants 3 and 4; the pipes may have these numbers already.
            first, second = os.dup(theirs_in), os.dup(theirs_out)
            high = [os.dup2(first, 63), os.dup2(second, 64)]
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)

        self.process = subprocess.Popen(
            [browser(), "--headless=new", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe",
             f"--user-data-dir={profile}", "--hide-scrollbars", "about:blank"],
            close_fds=False, preexec_fn=descriptors, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        os.close(theirs_in)
        os.close(theirs_out)
        self.read, self.write = os.fdopen(read, "rb"), os.fdopen(write, "wb")
        self.count, self.buffer, self.events, self.session = 0, b"", [], None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ["Page", "Runtime", "Log", "Network"]:
            self.call(f"{domain}.enable")

    def message(self) -> dict:
        while b"\0" not in self.buffer:
            more = os.read(self.read.fileno(), 1 << 20)
            if not more:
                sys.exit("chromium has gone away")
            self.buffer += more
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def call(self, method: str, **params) -> dict:
        self.count += 1
        request = {"id": self.count, "method": method, "params": params}
        if self.session:
            request["sessionId"] = self.session
        self.write.write(json.dumps(request).encode() + b"\0")
        self.write.flush()
        while True:
            answer = self.message()
            if answer.get("id") == self.count:
                if "error" in answer:
                    sys.exit(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def wait(self, event: str) -> None:
        while not any(seen.get("method") == event for seen in self.events):
            self.events.append(self.message())

    def open(self, address: str, size: tuple[int, int]) -> None:
        width, height = size
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                  mobile=width < 600)
        # From a blank page, so that an address that differs in its anchor only is opened anew.
        for url in ("about:blank", address):
            self.events.clear()
            self.call("Page.navigate", url=url)
            self.wait("Page.loadEventFired")

    def value(self, expression: str):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True)
        if "exceptionDetails" in answer:
            sys.exit(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def key(self, key: str, code: int, shift: bool = False) -> None:
        shared = {"key": key, "code": key, "windowsVirtualKeyCode": code, "modifiers": 8 if shift else 0}
        text = {"text": "\r"} if key == "Enter" else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", **shared, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", **shared)

    def picture(self, path: Path) -> None:
        image = self.call("Page.captureScreenshot", format="png")
        path.write_bytes(base64.b64decode(image["data"]))

    def complaints(self) -> list[str]:
        """What was written to the console, and what was loaded beside the page."""
        found = []
        for event in self.events:
            method, params = event.get("method"), event.get("params", {})
            if method == "Log.entryAdded":
                found.append(f"console: {params['entry']['text']}")
            elif method in ("Runtime.consoleAPICalled", "Runtime.exceptionThrown"):
                found.append(f"console: {params}")
            elif method == "Network.requestWillBeSent":
                address = params["request"]["url"]
                if not address.startswith(("file:", "data:", "about:")):
                    found.append(f"loaded: {address}")
        return found

    def close(self) -> None:
        self.process.terminate()
        self.process.wait()


class Checks:
    def __init__(self, chromium: Chromium):
        self.chromium, self.wrong = chromium, []

    def expect(self, what: str, holds: bool) -> None:
        if not holds:
            self.wrong.append(what)

    def is_shown(self, selector: str) -> bool:
        return self.chromium.value(
            f"(e => !!e && e.getClientRects().length > 0)(document.querySelector({json.dumps(selector)}))"
        )

    def page(self, page: Path, pictures: Path | None) -> None:
        address, name = f"file://{quote(str(page))}", page.name
        for size in (DESKTOP, PHONE):
            self.chromium.open(address, size)
            for complaint in self.chromium.complaints():
                self.wrong.append(f"{name}: {complaint}")
            wide = self.chromium.value("document.documentElement.scrollWidth")
            self.expect(f"{name}: {wide} pixels wide in a window of {size[0]}", wide <= size[0])
            for scheme in ("light", "dark"):
                self.chromium.call("Emulation.setEmulatedMedia",
                                   features=[{"name": "prefers-color-scheme", "value": scheme}])
                self.boxes(f"{name}, {size[0]} pixels, {scheme}")
                if pictures:
                    pictures.mkdir(parents=True, exist_ok=True)
                    self.chromium.picture(pictures / f"{page.stem}-{size[0]}-{scheme}.png")
            self.chromium.call("Emulation.setEmulatedMedia", features=[])
        self.texts(name)
        if self.chromium.value("!!document.querySelector('table.atlas')"):
            self.atlas(address, name)
            self.skip(address, name)
        if name == "index.html":
            return
        self.anchors(address, name)
        self.folds(address, name)
        if self.chromium.value("!!document.querySelector('.filter')"):
            self.filters(address, name)
            self.keyboard(address, name)
        else:
            self.skip(address, name)

    def boxes(self, where: str) -> None:
        """The box of every element is inside the window, also of the words in pictures; of what scrolls by itself that
        of the whole."""
        outside = self.chromium.value(
            """[...document.querySelectorAll('body *')].filter(element => {
                if (element.closest('.skip, .hidden, title, desc') || !element.getClientRects().length) return false;
                // Lines that are drawn belong to their picture, whose own box counts. Its words have boxes of their own.
                if (element.parentElement.closest('svg') && element.tagName !== 'text') return false;
                for (let above = element.parentElement; above; above = above.parentElement)
                    if (['auto', 'scroll', 'hidden'].includes(getComputedStyle(above).overflowX)) return false;
                const box = element.getBoundingClientRect();
                return box.left < -0.5 || box.right > innerWidth + 0.5;
            }).map(element => `${element.tagName} ${element.textContent.slice(0, 40)}`).slice(0, 5)"""
        )
        self.expect(f"{where}: outside the window: {outside}", outside == [])

    def texts(self, name: str) -> None:
        """Every picture has a title and a description, and no link leads nowhere."""
        bare = self.chromium.value(
            "[...document.querySelectorAll('svg')].filter(s => s.getAttribute('role') !== 'img' ||"
            " !s.querySelector('title')?.textContent || !s.querySelector('desc')?.textContent).length"
        )
        self.expect(f"{name}: {bare} pictures have no words", bare == 0)
        lost = self.chromium.value(
            "[...document.querySelectorAll('a[href^=\"#\"]')].map(a => decodeURIComponent(a.getAttribute('href').slice(1)))"
            ".filter(id => !document.getElementById(id))"
        )
        self.expect(f"{name}: links lead nowhere: {lost}", lost == [])

    def atlas(self, address: str, name: str) -> None:
        """The index of schemes is searched and sorted by the keyboard, and is whole without scripts."""
        chromium = self.chromium
        shown = "[...document.querySelectorAll('.atlas tbody tr')].filter(r => r.getClientRects().length)"
        rows = chromium.value(f"{shown}.length")
        chromium.call("Emulation.setScriptExecutionDisabled", value=True)
        chromium.open(address, DESKTOP)
        bare = chromium.value(f"{shown}.length + 100000 * document.querySelectorAll('.atlas button, input').length")
        self.expect(f"{name}: {bare} rows without scripts, and {rows} with them", bare == rows > 0)
        chromium.call("Emulation.setScriptExecutionDisabled", value=False)
        for size in (DESKTOP, PHONE):
            chromium.open(address, size)
            # By Tab to the field, then to the buttons.
            stops = 0
            while chromium.value("document.activeElement.type") != "search" and stops < 10:
                chromium.key("Tab", 9)
                stops += 1
            chromium.call("Input.insertText", text="not INTER")
            found = chromium.value(f"{shown}.map(r => r.dataset.words)")
            wrong = [words for words in found if "not" not in words or "inter" not in words]
            self.expect(f"{name}: the search finds {wrong}, {len(found)} of {rows}", not wrong and 0 < len(found) < rows)
            said = chromium.value("document.querySelector('[role=status]').textContent")
            self.expect(f"{name}: {said} is said of {len(found)}", said.startswith(f"{len(found)} of "))
            chromium.value("document.querySelector('input').select()")
            chromium.key("Backspace", 8)
            self.expect(f"{name}: the search does not end", chromium.value(f"{shown}.length") == rows)
            columns = chromium.value("document.querySelectorAll('.atlas thead button').length")
            stops = 0
            for column in range(columns):
                here = f"document.activeElement.closest('th')?.cellIndex === {column} && document.activeElement.type === 'button'"
                while not chromium.value(here) and stops < 40:
                    chromium.key("Tab", 9)
                    stops += 1
                for down in (False, True):
                    chromium.key("Enter", 13)
                    keys = chromium.value(f"{shown}.map(r => r.cells[{column}].dataset.key)")
                    known = [key for key in keys if key]
                    try:
                        known = [float(key) for key in known]
                        wanted = sorted(known, reverse=down)
                    except ValueError:
                        # The order of letters is that of the reader's language.
                        wanted = known if chromium.value(
                            f"(k => k.every((x, i) => !i || (k[i - 1].localeCompare(x)) * {-1 if down else 1} <= 0))"
                            f"({json.dumps(known)})") else None
                    last = all(not key for key in keys[len(known):])
                    self.expect(f"{name}: column {column} is not sorted, {size[0]} pixels", known == wanted and last)

    def folds(self, address: str, name: str) -> None:
        """What is folded opens by Enter and closes again, with the lines of certificates among it."""
        self.chromium.open(address, DESKTOP)
        chosen = "document.querySelector('details.certificate')"
        if not self.chromium.value(f"!!{chosen}"):
            return
        self.chromium.value(f"{chosen}.querySelector('summary').focus()")
        for wanted in (True, False):
            self.chromium.key("Enter", 13)
            opened = self.chromium.value(f"{chosen}.open && {chosen}.querySelector('pre').getClientRects().length > 0")
            self.expect(f"{name}: Enter leaves a certificate {'closed' if wanted else 'open'}", opened == wanted)

    def skip(self, address: str, name: str) -> None:
        """The first stop is the skip link, which skips, and all later stops have a visible focus."""
        self.chromium.open(address, DESKTOP)
        self.chromium.key("Tab", 9)
        self.expect(f"{name}: the first stop is not the skip link",
                    self.chromium.value("document.activeElement.className") == "skip")
        self.chromium.key("Enter", 13)
        self.expect(f"{name}: the skip link does not skip", self.chromium.value("location.hash") == "#page:main")
        for _ in range(40):
            self.chromium.key("Tab", 9)
            if self.chromium.value("document.activeElement === document.body"):
                return
            style = self.chromium.value("getComputedStyle(document.activeElement).outlineStyle")
            self.expect(f"{name}: no visible focus", style != "none")

    def anchors(self, address: str, name: str) -> None:
        """The address of a cell opens its panel, which stands within the window; `close` closes it."""
        anchor = self.chromium.value("document.querySelector('td.cell[id]')?.id ?? null")
        if anchor is None:
            return
        for size in (DESKTOP, PHONE):
            self.chromium.open(f"{address}#{anchor}", size)
            box = self.chromium.value(
                "(b => [b.left, b.right, b.top, b.bottom])"
                "(document.querySelector('td:target > .panel').getBoundingClientRect())"
            )
            left, right, top, bottom = box
            width, height = size
            within = left >= 0 and right <= width and top >= 0 and bottom <= height + 1 and bottom > top
            self.expect(f"{name}: the panel of {anchor} stands at {box}", within)
            # The cell itself is not behind its panel.
            above = self.chromium.value("document.querySelector('td:target').getBoundingClientRect().bottom")
            self.expect(f"{name}: {anchor} is hidden by its panel", above <= top + 1)
        self.chromium.value("document.querySelector('td:target .close').click()")
        self.expect(f"{name}: the panel does not close", not self.is_shown("td:target > .panel"))

    def filters(self, address: str, name: str) -> None:
        """Each filter hides the claims that have nothing of it, and no other."""
        self.chromium.open(address, DESKTOP)
        kinds = self.chromium.value("[...document.querySelectorAll('.filter input')].map(i => i.value)")
        self.expect(f"{name}: {kinds} are no filters", len(kinds) > 1 and kinds[0] == "all")
        for kind in kinds:
            wrong = self.chromium.value(
                f"document.getElementById('page:show-{kind}').click();"
                "[...document.querySelectorAll('.claim')].filter(claim => {"
                f"const has = '{kind}' === 'all' || claim.matches('.{kind}') || claim.querySelector('td.{kind}');"
                "return (claim.getClientRects().length > 0) !== !!has}).map(claim => claim.id)"
            )
            self.expect(f"{name}: the filter {kind} is wrong for {wrong}", wrong == [])

    def keyboard(self, address: str, name: str) -> None:
        """The skip link, the filters and a cell by Tab, arrows and Enter, with a visible focus."""
        chromium = self.chromium
        chromium.open(address, DESKTOP)
        chromium.key("Tab", 9)
        self.expect(f"{name}: the first stop is not the skip link",
                    chromium.value("document.activeElement.className") == "skip")
        chromium.key("Enter", 13)
        self.expect(f"{name}: the skip link does not skip", chromium.value("location.hash") == "#page:main")
        stops, seen_filter, seen_cell = 0, False, False
        while stops < 400 and not (seen_filter and seen_cell):
            chromium.key("Tab", 9)
            stops += 1
            if chromium.value("document.activeElement === document.body"):
                break
            at = chromium.value(
                "(e => [e.name ?? '', e.className, getComputedStyle(e).outlineStyle])(document.activeElement)"
            )
            self.expect(f"{name}: no visible focus at {at}", at[2] != "none")
            if at[0] == "show" and not seen_filter:
                seen_filter = True
                chromium.key("ArrowDown", 40)
                checked = chromium.value("document.querySelector('.filter input:checked').value")
                self.expect(f"{name}: arrows do not change the filter", checked != "all")
                chromium.key("ArrowUp", 38)
            if at[1] == "open":
                seen_cell = True
                chromium.key("Enter", 13)
                self.expect(f"{name}: Enter does not open a cell", self.is_shown("td:target > .panel"))
                chromium.key("Tab", 9)
                chromium.key("Enter", 13)
                self.expect(f"{name}: `close` is not the next stop", not self.is_shown("td:target > .panel"))
        cells = chromium.value("document.querySelectorAll('td.cell[id]').length")
        self.expect(f"{name}: Tab reaches no filter", seen_filter)
        self.expect(f"{name}: Tab reaches no cell", seen_cell or cells == 0)


def main() -> int:
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    folder = Path(sys.argv[1]).resolve()
    pictures = Path(sys.argv[2]).resolve() if len(sys.argv) == 3 else None
    pages = sorted(folder.glob("*.html"))
    if not pages:
        print(f"no pages in {folder}", file=sys.stderr)
        return 2
    # Helpers of the browser may still write while the folder is removed.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        chromium = Chromium(profile)
        try:
            checks = Checks(chromium)
            for page in pages:
                checks.page(page, pictures)
        finally:
            chromium.close()
    for wrong in checks.wrong:
        print(wrong, file=sys.stderr)
    if not checks.wrong:
        print(f"{len(pages)} pages: nothing on the console, anchors, filters and keyboard work")
    return 1 if checks.wrong else 0


if __name__ == "__main__":
    sys.exit(main())
