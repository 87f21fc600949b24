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
from urllib.parse import quote

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

    def quiet(self, name: str) -> None:
        for complaint in self.chromium.complaints():
            # The worker is a part of the page. Without a graphics card the browser itself complains of WebGL.
            if "blob:" not in complaint and "WebGL" not in complaint:
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

    def drop(self, selector: str, file: Path) -> None:
        """Drags a file of this machine onto an element, and lets it go."""
        x, y = self.chromium.value(
            f"(e => {{ e.scrollIntoView(); const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; }})"
            f"(document.querySelector({json.dumps(selector)}))"
        )
        data = {"items": [], "files": [str(file)], "dragOperationsMask": 1}
        for kind in ["dragEnter", "dragOver", "drop"]:
            self.chromium.call("Input.dispatchDragEvent", type=kind, x=x, y=y, data=data)

    def saved(self, room: str, button: str, name: str, part: str) -> None:
        """A button saves a file whose name ends so, and that has this part."""
        with tempfile.TemporaryDirectory() as folder:
            self.chromium.call("Page.setDownloadBehavior", behavior="allow", downloadPath=folder)
            self.click(button, room)
            end = time.monotonic() + PATIENCE
            while not (files := [file for file in Path(folder).iterdir() if file.name.endswith(name) and part in file.read_text()]):
                if time.monotonic() > end:
                    break
                time.sleep(0.05)
            self.expect(f"{room}: `{button}` saves no {name} with {part!r}", bool(files))

    def printed(self) -> None:
        """On paper, from a dark screen: dark letters, nothing that is only for use, and nothing cut off."""
        dark = [{"name": "prefers-color-scheme", "value": "dark"}]
        for room in ROOMS:
            self.chromium.call("Emulation.setEmulatedMedia", features=dark)
            self.open(room, (794, 1123))
            time.sleep(1.5)
            self.chromium.call("Emulation.setEmulatedMedia", media="print", features=dark)
            self.chromium.value("dispatchEvent(new Event('beforeprint'))")
            name = f"{room}, printed"
            self.fits(name)
            light = self.chromium.value("getComputedStyle(document.body).color.match(/[0-9.]+/g).slice(0, 3).some(c => c > 128)")
            self.expect(f"{name}: light letters", not light)
            shown = self.chromium.value("[...document.querySelectorAll('button, nav')].some(e => e.offsetParent)")
            self.expect(f"{name}: buttons", not shown)
            beside = self.chromium.value(
                "(t => [...document.querySelectorAll('.paper-printed li')].every((e, i) => e.querySelector('code').textContent === t[i]"
                " && e.querySelector('span').textContent === document.querySelectorAll('.paper-numbers > div')[i].textContent))"
                "(document.querySelector('#paper-text')?.value.split('\\n'))"
            )
            self.expect(f"{name}: lines that do not stand beside their numbers", beside)
            marked = self.chromium.value("[...document.querySelectorAll('.paper-printed li.bad')].some(e => e.offsetParent)")
            self.expect(f"{name}: no wrong line is marked", room != "paper" or marked)
            cut = self.chromium.value("[...document.querySelectorAll('textarea')].some(e => e.offsetParent && e.scrollHeight > e.clientHeight + 2)")
            self.expect(f"{name}: a text is cut off", not cut)
            paper = self.chromium.call("Page.printToPDF", printBackground=False)["data"]
            self.expect(f"{name}: no pages", len(paper) > 10_000)
            self.quiet(name)
        self.chromium.call("Emulation.setEmulatedMedia", media="", features=[])

    def hostile(self) -> None:
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
            page.printed()
        finally:
            chromium.close()
    for what, seconds in page.times.items():
        print(f"{seconds:6.2f} s  {what}")
    for wrong in page.wrong:
        print(f"!! {wrong}", file=sys.stderr)
    return 1 if page.wrong else 0


SCHEME = "document.querySelector('#room-scheme')"
FIGURE = f"{SCHEME}.querySelector('.scheme-figure').shadowRoot"


def rooms(page: Page) -> None:
    """What a visitor does in each room."""
    scheme(page)
    curve(page)
    mesh(page)
    paper(page)


def scheme(page: Page) -> None:
    page.open("scheme")
    page.until("the first picture", f"{SCHEME} && {FIGURE}.querySelector('svg path, svg polyline')")
    page.until("ranges on the slider", f"{SCHEME}.innerText.includes('C¹, not C²')")
    page.quiet("scheme")
    page.type("#room-scheme input[type=text]", "[1, 3, 3, 1]/4")
    page.until("a mask that is typed", f"{SCHEME}.innerText.includes('C¹') && !{SCHEME}.innerText.includes('not attained')")
    page.type("#room-scheme input[type=text]", "[1, 3, 3]/4")
    page.until("an error of a mask", f"{SCHEME}.querySelector('.error').textContent.includes('add up to 7/4')")
    # Decimals that are cut keep their size.
    page.open("scheme?scheme=four-point&at=w%3D1%2F10000000000000007")
    page.until("a small number", f"/1\\.99\\d*…e-16/.test({SCHEME}?.innerText)")
    page.open("scheme?scheme=four-point&at=w%3D1%2F100000000000000000000")
    page.until("a number near 1", f"{SCHEME}?.innerText.includes('1.00000000…')")
    page.open("scheme?scheme=four-point&at=w%3D1000000000000%2F7")
    page.until("a large number", f"{SCHEME}?.innerText.includes('285714285714…')")
    page.open("scheme?scheme=four-point&at=w%3D1%2F10")
    page.until("a link restores a scheme", f"{SCHEME}.querySelector('input[type=range]') && {SCHEME}.innerText.includes('1/10')"
               f" || {SCHEME} && [...{SCHEME}.querySelectorAll('input')].some(e => e.value === '1/10')")
    before = page.chromium.value("location.hash")
    moved = (f"(e => {{ e.value = Number(e.min) + 0.6 * (e.max - e.min); e.dispatchEvent(new Event('input', {{bubbles: true}})); }})"
             f"({SCHEME}.querySelector('input[type=range]'))")
    page.chromium.value(moved)
    page.until("a slider redraws", f"location.hash !== {json.dumps(before)}")
    page.quiet("scheme, moved")
    # How long until the picture of a new value is there, in milliseconds: the median of some moves.
    script = """(async () => {
        const room = document.querySelector('#room-scheme');
        const root = room.querySelector('.scheme-figure').shadowRoot;
        const slider = room.querySelector('input[type=range]');
        const times = [];
        for (let i = 0; i < 15; i++) {
            await new Promise((done) => setTimeout(done, 100));
            const drawn = new Promise((done) => {
                const watch = new MutationObserver(() => { watch.disconnect(); done(); });
                watch.observe(root, { childList: true, subtree: true });
                setTimeout(done, 5000);
            });
            const start = performance.now();
            slider.value = Number(slider.min) + (0.45 + 0.01 * i) * (slider.max - slider.min);
            slider.dispatchEvent(new Event('input', { bubbles: true }));
            await drawn;
            times.push(performance.now() - start);
        }
        return times.sort((a, b) => a - b)[7];
    })()"""
    answer = page.chromium.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
    page.times["a redraw while a slider moves (median of 15)"] = answer["result"]["value"] / 1000
    page.expect("a slider does not redraw", answer["result"]["value"] < 4000)


def curve(page: Page) -> None:
    page.open("curve")
    page.until("the depth of a polygon", "document.querySelector('#room-curve')?.innerText.includes('for the tolerance')")
    place = page.chromium.value(
        "(r => [r.x + r.width / 2, r.y + r.height / 2])(document.querySelector('#room-curve svg [tabindex]').getBoundingClientRect())"
    )
    before = page.chromium.value("location.hash")
    for kind, at in [("mousePressed", place), ("mouseMoved", [place[0] + 40, place[1] - 40]), ("mouseReleased", [place[0] + 40, place[1] - 40])]:
        page.chromium.call("Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], button="left", buttons=1, clickCount=1)
    page.until("a point is dragged", f"location.hash !== {json.dumps(before)}")
    restored = page.chromium.value("location.hash").lstrip("#")
    points = page.chromium.value("document.querySelector('#room-curve textarea').value")
    page.open(restored)
    page.until("a link restores a polygon", f"document.querySelector('#room-curve textarea')?.value === {json.dumps(points)}")
    page.until("the depth of this polygon", "document.querySelector('#room-curve')?.innerText.includes('for the tolerance')")
    page.saved("curve", "Save as SVG", "subcert-curve.svg", "<polyline")
    # By the keyboard alone: the first point goes to the right, and the last one is removed.
    page.chromium.value("document.querySelector('#curve-closed').click()")
    page.until("an open polygon", "document.querySelector('#room-curve .curve-limit').getAttribute('points')?.trim().split(/\\s+/).length > 100")
    page.chromium.value("document.querySelector('#room-curve svg [tabindex]').focus()")
    page.chromium.key("ArrowRight", 39)
    page.until("a point is moved by a key", f"document.querySelector('#room-curve textarea').value !== {json.dumps(points)}")
    page.chromium.value("[...document.querySelectorAll('#room-curve svg [tabindex]')].at(-1).focus()")
    page.chromium.key("Delete", 46)
    page.until("a point is removed by a key", f"document.querySelector('#room-curve textarea').value.trim().split('\\n').length === {len(points.splitlines()) - 1}")
    page.quiet("curve")
    # The room before, with what was drawn there, also after the page is loaded anew.
    drawn = page.chromium.value("document.querySelector('#room-curve textarea').value")
    page.chromium.value("document.querySelector('#tab-mesh').click()")
    page.until("another room", "!document.querySelector('#room-mesh').hidden")
    page.chromium.value("history.back()")
    page.until("the way back", "!document.querySelector('#room-curve').hidden && location.hash.startsWith('#curve?')")
    page.chromium.value("document.querySelector('#tab-mesh').click()")
    page.open("mesh")
    page.chromium.value("document.querySelector('#tab-curve').click()")
    page.until("what was drawn", f"document.querySelector('#room-curve textarea').value === {json.dumps(drawn)}")


def mesh(page: Page) -> None:
    page.open("mesh?level=1&tolerance=1%2F10")
    page.until("a mesh is refined", "document.querySelector('#room-mesh')?.innerText.includes('faces')")
    page.until("the depth of a mesh", "/[0-9] levels?/.test(document.querySelector('#room-mesh').innerText)")
    tent = (ROOT / "examples/tent.obj").read_text()
    page.chromium.value(
        "(t => { const d = new DataTransfer(); d.items.add(new File([%s], 'mine.obj')); const i = document.querySelector('#room-mesh input[type=file]');"
        " i.files = d.files; i.dispatchEvent(new Event('change', {bubbles: true})); })()" % json.dumps(tent)
    )
    page.until("a file of one's own", "document.querySelector('#room-mesh').innerText.includes('mine.obj')")
    page.drop("#room-mesh .mesh-drop", ROOT / "examples/cube.obj")
    page.until("a file that is dropped", "/cube.obj.?, level 1: [0-9]+ points/.test(document.querySelector('#room-mesh').innerText)")
    page.saved("mesh", "Save the refined mesh", "cube-level-1.obj", "\nf ")
    page.open("mesh?level=1&tolerance=1%2F100000")
    page.until("progress of the depth", "document.querySelector('#work output').value.includes(' pieces of level ')")
    page.chromium.value("document.querySelector('#work button').click()")
    page.until("the work is stopped", "document.querySelector('#work').hidden && document.querySelector('#room-mesh').innerText.includes('was stopped')")
    page.quiet("mesh")


def paper(page: Page) -> None:
    page.open("paper")
    page.until("verdicts", "document.querySelector('#room-paper')?.innerText.includes('refuted')")
    page.click("Start here", "paper")
    page.until("the wrong cell", "document.activeElement?.localName === 'textarea'")
    page.saved("paper", "Certificate", ".cert", "certificate")
    page.click("Check the certificate", "paper")
    page.until("the checker's word", "/certificate.*(valid|accepted)|valid/.test(document.querySelector('#room-paper').innerText)")
    # Another room, before the text has rested, and the way back.
    page.chromium.value(
        "(e => { e.value += '# mine'; e.dispatchEvent(new Event('input', {bubbles: true})); document.querySelector('#tab-curve').click(); history.back(); })"
        "(document.querySelector('#room-paper textarea'))"
    )
    page.until("the text after the way back", "!document.querySelector('#room-paper').hidden && location.hash.includes('mine')"
               " && document.querySelector('#room-paper textarea').value.endsWith('# mine')")
    page.chromium.value(
        "(e => { e.value = e.value.replace('[[table]]', '[[tabel]]'); e.dispatchEvent(new Event('input', {bubbles: true})); })"
        "(document.querySelector('#room-paper textarea'))"
    )
    page.until("an error at its place", "document.querySelector('#room-paper .error, #room-paper [role=alert]')?.textContent.includes('tabel')")
    page.quiet("paper")


if __name__ == "__main__":
    sys.exit(main())
