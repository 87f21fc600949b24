#!/usr/bin/env python3
"""Opens web/index.html from its folder in headless Chromium, as a visitor does: types, moves, draws, drops a file, saves, follows a link.

    .ci/page.py [SCREENSHOTS]

Nothing may be written to the console or loaded, and no box may stand outside the window. With SCREENSHOTS, each room is drawn there at 390 and at
1280 pixels, light and dark.
"""

import json
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from browser import DESKTOP, PHONE, Chromium  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
PAGE = (ROOT / "web/index.html").as_uri()
ROOMS = ["scheme", "curve", "mesh", "paper"]
PATIENCE = 60

# A text with markup, which must stay text.
HOSTILE = "\"><img src=x onerror=\"document.title='broken'\"><script>document.title='broken'</script>"


class Page:
    def __init__(self, chromium: Chromium):
        self.chromium, self.wrong, self.times = chromium, [], {}

    def expect(self, what: str, holds: bool) -> None:
        if not holds:
            self.wrong.append(what)

    def open(self, anchor: str, size: tuple[int, int] = DESKTOP) -> None:
        self.chromium.open(f"{PAGE}#{anchor}", size)

    def until(self, what: str, expression: str, seconds: float = PATIENCE) -> None:
        """Waits until an expression holds, and notes how long that took."""
        start = time.monotonic()
        while not self.chromium.value(f"Boolean({expression})"):
            if time.monotonic() > start + seconds:
                self.expect(f"not within {seconds} s: {what}", False)
                return
            time.sleep(0.02)
        self.times[what] = time.monotonic() - start

    def type(self, selector: str, text: str) -> None:
        self.chromium.value(
            f"(e => {{ e.focus(); e.value = {json.dumps(text)}; e.dispatchEvent(new Event('input', {{bubbles: true}}));"
            f" e.dispatchEvent(new Event('change', {{bubbles: true}})); }})(document.querySelector({json.dumps(selector)}))"
        )

    def click(self, text: str, room: str) -> None:
        found = self.chromium.value(
            f"(b => (b?.click(), Boolean(b)))([...document.querySelectorAll('#room-{room} button')]"
            f".find(b => b.textContent.trim().startsWith({json.dumps(text)})))"
        )
        self.expect(f"{room}: there is no button `{text}`", found)

    def text(self, room: str) -> str:
        return self.chromium.value(f"document.querySelector('#room-{room}').innerText") or ""

    def quiet(self, name: str) -> None:
        for complaint in self.chromium.complaints():
            # The address of a worker is one of the page itself.
            if "blob:" not in complaint:
                self.wrong.append(f"{name}: {complaint}")

    def fits(self, name: str) -> None:
        wide = self.chromium.value("document.documentElement.scrollWidth > document.documentElement.clientWidth + 1")
        self.expect(f"{name}: a box stands outside the window", not wide)

    def named(self, name: str) -> None:
        """Every control has a name for screen readers."""
        bare = self.chromium.value(
            "[...document.querySelectorAll('main section:not([hidden]) :is(button, input, select, textarea)')].filter(e => e.offsetParent"
            " && !e.textContent.trim() && !e.labels?.length && !e.getAttribute('aria-label') && !e.getAttribute('aria-labelledby'))"
            ".map(e => e.outerHTML.slice(0, 120))"
        )
        self.expect(f"{name}: without a name: {bare}", not bare)

    def all_rooms(self, pictures: Path | None) -> None:
        for size, width in [(PHONE, "390"), (DESKTOP, "1280")]:
            for mode in ["light", "dark"]:
                self.chromium.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": mode}])
                for room in ROOMS:
                    self.open(room, size)
                    time.sleep(1.5)
                    name = f"{room}, {width} px, {mode}"
                    self.fits(name)
                    self.named(name)
                    self.quiet(name)
                    if pictures:
                        self.chromium.picture(pictures / f"{room}-{width}-{mode}.png")

    def hostile(self) -> None:
        from urllib.parse import quote

        for room, key in [("scheme", "scheme"), ("curve", "scheme"), ("curve", "points"), ("mesh", "scheme"), ("mesh", "example"), ("paper", "text")]:
            self.open(f"{room}?{key}={quote(HOSTILE)}")
            time.sleep(1)
            broken = self.chromium.value("document.title === 'broken' || Boolean(document.querySelector('img[src=x]'))")
            self.expect(f"{room}: {key} of the address is taken for markup", not broken)
            self.quiet(f"{room}, hostile {key}")


def main() -> int:
    pictures = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    if pictures:
        pictures.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        chromium = Chromium(profile)
        page = Page(chromium)
        try:
            rooms(page)
            page.hostile()
            page.all_rooms(pictures)
        finally:
            chromium.close()
    for what, seconds in page.times.items():
        print(f"{seconds:6.2f} s  {what}")
    for wrong in page.wrong:
        print(f"!! {wrong}", file=sys.stderr)
    return 1 if page.wrong else 0


def rooms(page: Page) -> None:
    """What a visitor does in each room."""


if __name__ == "__main__":
    sys.exit(main())
