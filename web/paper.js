// The room of papers: a claim file in an editor, its errors at their places, and the verdicts of the program beside it.

import { el, save } from "./dom.js";
import { Stopped } from "./engine.js";
import { paperCheck } from "./paper-check.js";
import { paperClaims, paperPromise, paperWord, paperWorse } from "./paper-claims.js";
import { paperEditor } from "./paper-editor.js";
import { PAPER_EXAMPLES, PAPER_KEYS } from "./paper-examples.js";
import { PAPER_BYTES, paperErrors, paperLinesOf, paperOffset, paperPlaces, paperTooLong } from "./paper-places.js";

const PAPER_FILE = "paper.toml";
/** Longer texts are not put into the address. */
const PAPER_LONGEST = 20_000;
/** How long a text must rest until it is judged, in milliseconds; and one that is long. */
const [PAPER_REST, PAPER_LONG_REST] = [300, 1500];
/** So many texts of the visitor's are kept when others replace them. */
const PAPER_OWN = 9;
const [PAPER_NO_MARKS, PAPER_NO_LINES] = [new Map(), []];
/** So many places of an error have buttons. */
const PAPER_BUTTONS = 20;

/** What is shown of a file about numbers that a program ships: a line for each of its tables. */
function paperOfProject({ key, tables }) {
  const claims = tables.map(({ id, locus, title, outcome }) => ({ id: `${key}:${id}`, locus, kind: "shipped", printed: title, verdict: outcome }));
  const summary = {};
  for (const { verdict } of claims) summary[verdict] = (summary[verdict] ?? 0) + 1;
  return { key, claims, summary, promises: null };
}

function paperRoom(place, { engine, state }) {
  let own = []; // texts of the visitor's that others have replaced
  let asked = 0;
  let saves = 0;
  let turn = 0; // what raises it makes void a text that the program still writes
  let shown = null; // the paper of the last answer
  let stale = false;
  let chosen = "all";
  let checks = [];
  let resting = null; // the timer until the text is judged
  let then = null; // what to do after the next audit
  let known = {};
  const published = new Map(); // the texts of papers that are part of the program, by key

  const status = el("p", { role: "status", class: "paper-status" });
  const trouble = el("div", { class: "paper-trouble" });
  const limit = el("div", { class: "paper-trouble" });
  const list = el("div", { class: "paper-list" });
  const here = el("p", { id: "paper-here", class: "soft paper-here" });
  const savings = el("p", { role: "status" });
  const checker = el("div", { "aria-live": "polite" });
  const chooser = el("div", { class: "paper-choose", role: "group", "aria-label": "what to open" });
  const editor = paperEditor({ changed: () => changed(), moved: (offset) => tell(offset), declined: (why) => decline(why) });
  const written = el("div", {}, el("label", { for: "paper-text" }, "The claim file"), editor.node, editor.printed, here);
  const room = el("div", { class: "paper-room" },
    el("div", { class: "paper-left" }, limit, written, trouble),
    el("div", {}, el("h2", {}, "Claims and verdicts"), list));
  const opened = el("input", { type: "file", accept: ".toml,text/plain", class: "paper-file", tabindex: "-1", "aria-label": "a claim file of your own", onchange: open });

  const files = () => ({ [PAPER_FILE]: editor.text });
  const local = (claim) => claim.id.slice(shown.key.length + 1);
  const name = () => shown?.key ?? "paper";

  /** Where a claim stands; a cell that is not found stands in its table. */
  function placeOf(places, id) {
    return places.get(id) ?? places.get(id.split(":")[0]) ?? null;
  }

  function jump(id) {
    const at = placeOf(paperPlaces(editor.text), id);
    if (at) editor.select(at.from, at.to);
  }

  /** What the claim under the cursor says. */
  function tell(offset) {
    if (!shown || stale) return;
    const within = [...paperPlaces(editor.text)].filter(([, at]) => at.start <= offset && offset <= at.end).map(([id]) => id);
    const claim = shown.claims.find((one) => within.includes(local(one)) && one.verdict);
    here.replaceChildren();
    if (!claim) return;
    const { kind, sign } = paperWord(claim.verdict);
    here.append(el("bdi", {}, claim.locus), ": ", el("span", { class: `paper-verdict ${kind}` }, `${sign} ${claim.verdict}`), claim.exact ? `, exactly ${claim.exact}` : "");
  }

  function draw() {
    list.classList.toggle("stale", stale);
    if (!shown) return list.replaceChildren();
    const text = editor.text;
    const places = paperPlaces(text);
    // Lines are counted once; there may be hundreds of claims.
    const lines = paperLinesOf(text);
    const lineOf = (claim) => {
      const at = placeOf(places, local(claim));
      return at && lines(at.from);
    };
    const checkOf = (claim) => checks.find(({ id }) => claim.id === id || claim.id.startsWith(`${id}:`));
    list.replaceChildren(...paperClaims(shown.claims, shown.summary, shown.promises, {
      chosen, lineOf, checkOf, explain,
      jump: (claim) => jump(local(claim)),
      choose: (filter) => {
        chosen = filter;
        draw();
        list.querySelector("[aria-pressed=true]")?.focus();
      },
    }));
    if (stale) return;
    const worst = new Map();
    for (const claim of shown.claims) {
      const line = lineOf(claim);
      if (line) worst.set(line, worst.has(line) ? paperWorse(worst.get(line), claim.verdict) : claim.verdict);
    }
    editor.mark(new Map([...worst].map(([line, verdict]) => [line, paperWord(verdict)])));
  }

  function say() {
    const counts = Object.entries(shown.summary).filter(([, count]) => count > 0).map(([verdict, count]) => `${count} ${verdict}`);
    const { kept, broken, open: undecided } = shown.promises ?? {};
    const promises = kept + broken + undecided > 0 ? ` Promises: ${kept} kept, ${broken} broken, ${undecided} open.` : "";
    status.textContent = `${shown.key}, ${shown.claims.length} claims: ${counts.join(", ") || "none"}.${promises}`;
  }

  /** The error of the program as it is, and a button for each of its places. */
  function refuse(message) {
    const error = message.trim() ? message : "The program ended without a message; perhaps this text needs more memory than a page has.";
    const places = paperErrors(error, PAPER_FILE);
    const buttons = places.slice(0, PAPER_BUTTONS).map(({ line, column, length }) => el("button", { type: "button", onclick: () => {
      const from = paperOffset(editor.text, line, column);
      editor.select(from, from + length);
    } }, `Go to line ${line}, column ${column}`));
    trouble.replaceChildren(el("div", { class: "error mono paper-error", role: "alert" }, error), el("div", { class: "row" }, buttons));
    editor.refuse(places.map(({ line }) => line));
    editor.mark(PAPER_NO_MARKS);
    stale = shown !== null;
    const before = stale ? " The verdicts are those of the text before." : "";
    status.textContent = places.length > 0 ? `The program refuses the text: see line ${places[0].line}, and the message below the text.${before}` : `The program refuses this.${before}`;
    draw();
  }

  /** A text that the editor does not take: the one before stays. */
  function decline(why) {
    limit.replaceChildren(el("div", { class: "error", role: "alert" }, `${why}. ${editor.text ? "The text before is kept." : "Here is an example."}`));
  }

  /** Judges the text, or the paper. */
  async function audit() {
    const mine = ++asked;
    if (!shown) status.textContent = "Judging …";
    const answer = await outline(mine).then(() => engine.json(["audit", PAPER_FILE], { files: files(), kind: "paper-audit" })).catch((error) => error);
    if (mine !== asked) return;
    const next = then;
    then = null;
    if (answer instanceof Stopped) {
      status.textContent = "Stopped. Change the text, or choose something above, to go on.";
      return;
    }
    if (answer instanceof Error) return refuse(answer.message);
    const { papers, projects } = answer;
    shown = papers?.[0] ?? (projects?.[0] ? paperOfProject(projects[0]) : null);
    stale = false;
    trouble.replaceChildren();
    editor.refuse([]);
    draw();
    if (shown) say();
    next?.();
  }

  /** The claims of a long text without verdicts, which are there at once. */
  async function outline(mine) {
    const key = /^key = "(\w[\w.-]*)"$/m.exec(editor.text)?.[1];
    if (shown || !key || editor.text.length < PAPER_LONGEST) return;
    status.textContent = `Judging all claims of ${key}. This may take a minute.`;
    const { claims } = await engine.json(["explain", key, PAPER_FILE], { files: files(), kind: "paper-audit" });
    if (mine !== asked) return;
    shown = { key, claims: claims.map(({ id, locus, title }) => ({ id: `${key}:${id}`, locus, kind: "", printed: title })), summary: {}, promises: null };
    draw();
  }

  async function explain(claim, into) {
    into.replaceChildren(el("p", { class: "soft" }, "computing …"));
    const told = el("pre", { class: "mono", tabindex: "0", "aria-label": `details of ${claim.locus}` });
    try {
      const { code, text, errors } = await engine.run(["explain", "--", claim.id, PAPER_FILE], { files: files(), kind: "paper-details" });
      if (code > 1) into.replaceChildren(el("div", { class: "error mono", role: "alert" }, errors.trim() || `exit code ${code}`));
      else into.replaceChildren(told);
      told.textContent = text.trim();
    } catch (error) {
      into.replaceChildren(el("p", { class: "soft" }, error instanceof Stopped ? "stopped" : error.message));
    }
  }

  /** Runs a command and saves what it prints, or the file that `pick` takes from those it writes. */
  async function keep(command, file, type, pick = null) {
    const [mine, before] = [++saves, editor.text];
    const tell = (words) => mine === saves && (savings.textContent = words);
    tell(`Writing ${file} …`);
    try {
      const { code, text, errors, files: written } = await engine.run(command, { files: files(), kind: "paper-save" });
      const content = pick ? pick(written) : text;
      if (editor.text !== before) throw new Error("The text has changed meanwhile. Save again.");
      if (code > 1 || !content) throw new Error(errors.trim() || "nothing was written");
      save(file, content, type);
      tell(`${file} is saved.`);
    } catch (error) {
      tell(error instanceof Stopped ? "stopped" : error.message);
    }
  }

  const page = (written) => Object.entries(written).find(([file]) => file.endsWith(".html") && !file.endsWith("index.html"))?.[1];
  const saved = [
    ["Claim file", () => save(`${name()}.toml`, editor.text)],
    ["Report with pictures (HTML)", () => keep(["audit", PAPER_FILE, "--format", "html", "-o", "report"], `${name()}.html`, "text/html", page)],
    ["Report (Markdown)", () => keep(["audit", PAPER_FILE, "--all", "--format", "markdown"], `${name()}.md`, "text/markdown")],
    ["Errata (Markdown)", () => keep(["errata", PAPER_FILE, "--format", "markdown"], `${name()}-errata.md`, "text/markdown")],
    ["Errata (LaTeX)", () => keep(["errata", PAPER_FILE, "--format", "latex"], `${name()}-errata.tex`, "text/plain")],
    ["Certificate", () => keep(["prove", PAPER_FILE, "-o", "-"], `${name()}.cert`, "text/plain")],
  ].map(([label, work]) => el("button", { type: "button", onclick: work }, label));

  async function check() {
    checks = await paperCheck(engine, PAPER_FILE, () => editor.text, checker, jump);
    draw();
  }
  const checking = el("button", { type: "button", onclick: check }, "Check the certificate");

  /** Writes the address: an example by its name, a published paper by its key, else the text. */
  function remember() {
    const text = editor.text;
    const same = Object.keys(PAPER_EXAMPLES).find((one) => PAPER_EXAMPLES[one].text === text) ?? "";
    const paper = [...published].find(([, other]) => other === text)?.[0] ?? "";
    const short = !paper && !same && text.length < PAPER_LONGEST;
    known = { paper, example: same, text: short ? text : "" };
    state.set(known);
    if (!paper && !same && !short) savings.textContent = "This text is too long for the address: save the claim file to keep it.";
  }

  /** The text is another one: nothing that was said is about it. */
  function fresh() {
    checks = [];
    checker.replaceChildren();
    savings.textContent = "";
    here.replaceChildren();
  }

  /** A text that has not rested yet goes into the address. */
  function leave() {
    if (resting !== null) remember();
  }

  function rest() {
    clearTimeout(resting);
    resting = setTimeout(() => {
      resting = null;
      remember();
      audit();
    }, editor.text.length > PAPER_LONGEST ? PAPER_LONG_REST : PAPER_REST);
  }
  function changed() {
    asked++;
    turn++;
    then = null;
    // What was said of lines is not about these.
    editor.mark(PAPER_NO_MARKS);
    editor.refuse(PAPER_NO_LINES);
    trouble.replaceChildren();
    if (shown) status.textContent = "Judging …";
    limit.replaceChildren();
    fresh();
    stale = shown !== null;
    list.classList.toggle("stale", stale);
    rest();
  }

  function isOwn() {
    const ready = [...Object.values(PAPER_EXAMPLES).map(({ text }) => text), ...published.values()];
    return editor.text !== "" && !ready.includes(editor.text);
  }

  /** Shows a text in the editor, if it takes it; `after` is done when it is judged. */
  function show(text, after = null) {
    const why = paperTooLong(text);
    if (why) return decline(why);
    clearTimeout(resting);
    limit.replaceChildren();
    if (isOwn() && text !== editor.text) own = [...own.filter((one) => one !== editor.text), editor.text].slice(-PAPER_OWN);
    then = after;
    turn++;
    [shown, stale, chosen] = [null, false, "all"];
    asked++;
    fresh();
    trouble.replaceChildren();
    editor.text = text;
    remember();
    choices();
    draw();
    audit();
  }

  /** A claim file that the program writes: a template, or that of a published paper. */
  async function write(key) {
    const mine = ++turn;
    try {
      const { code, text, errors } = await engine.run(["new", key, "-o", "-"], { kind: "paper-new" });
      if (mine !== turn) return;
      if (code > 1) return refuse(errors.trim() || `exit code ${code}`);
      if (Object.hasOwn(PAPER_KEYS, key)) published.set(key, text);
      show(text);
    } catch (error) {
      if (mine !== turn) return;
      if (error instanceof Stopped) status.textContent = "Stopped. Choose something above to go on.";
      else refuse(error.message);
    }
  }

  /** To the first claim with the worst verdict. */
  function toWorst() {
    const wrong = shown?.claims.filter(({ verdict }) => paperWord(verdict).kind === "bad") ?? [];
    const first = wrong[0] ?? shown?.claims.find((claim) => paperPromise(claim) === "broken");
    if (!first) return;
    chosen = first.verdict;
    draw();
    jump(local(first));
  }

  async function open() {
    const [file] = opened.files;
    try {
      // A long file is not even read.
      if (file?.size > PAPER_BYTES) decline(`${file.name} has ${file.size.toLocaleString("en")} bytes. The editor takes at most 1 MiB and 20,000 lines; audit it on your computer: subcert audit FILE`);
      else if (file) show(await file.text());
    } catch (error) {
      decline(`${file.name} cannot be read: ${error.message}`);
    }
    opened.value = "";
  }

  function choices() {
    const now = (is) => (is ? "true" : null);
    const button = (label, work, current = false) => el("button", { type: "button", onclick: work, "aria-current": now(current) }, label);
    const paper = el("select", { id: "paper-key", onchange: () => paper.value && write(paper.value) },
      el("option", { value: "" }, "choose …"),
      Object.entries(PAPER_KEYS).map(([one, title]) => el("option", { value: one, selected: published.get(one) === editor.text }, title)));
    chooser.replaceChildren(
      ...Object.values(PAPER_EXAMPLES).map(({ title, text }) => button(title, () => show(text), editor.text === text)),
      button("New claim file", () => write("doe2026")),
      button("Open a file …", () => opened.click()),
      ...own.filter((text) => text !== editor.text).map((text, i, all) => button(`Back to my text${all.length > 1 ? ` ${i + 1}` : ""}`, () => show(text))),
      el("div", { class: "field" }, el("label", { for: "paper-key" }, "A published paper"), paper));
  }

  /** What differs from the known values of the address decides. */
  function restore() {
    const values = state.get();
    const differs = (one) => (values[one] ?? "") !== (known[one] ?? "") && (values[one] ?? "") !== "";
    if (differs("text")) show(values.text);
    else if (differs("paper") && Object.hasOwn(PAPER_KEYS, values.paper)) write(values.paper);
    else if (differs("example") && Object.hasOwn(PAPER_EXAMPLES, values.example)) show(PAPER_EXAMPLES[values.example].text);
  }

  place.append(
    el("p", {}, "A claim file says what a paper prints: the numbers of its tables, its equations and theorems, copied digit by digit. It also says what each number is said to equal, by the paper's own formulas. The program computes these formulas exactly, and gives each claim a verdict."),
    el("p", { class: "paper-start" }, el("button", { type: "button", class: "paper-first", onclick: () => {
      show(PAPER_EXAMPLES.first.text, toWorst);
    } }, "Start here: find the wrong number"), " opens an invented paper with two tables. One number in them is wrong however it is read; the cursor goes to it. Then change something, and see what the program says."),
    chooser, opened, status,
    room,
    el("h2", {}, "Save"),
    el("div", { class: "row" }, saved),
    savings,
    el("h2", {}, "Certificate"),
    el("p", {}, "A certificate has what a second, small program needs to confirm each verdict by itself, without trusting the first one."),
    el("div", { class: "row" }, checking),
    checker);
  restore();
  const paper = state.get().paper ?? "";
  if (asked === 0 && (limit.hasChildNodes() || !Object.hasOwn(PAPER_KEYS, paper))) {
    const why = [...limit.childNodes];
    show(PAPER_EXAMPLES.first.text);
    limit.replaceChildren(...why);
  }
  return { restore, leave };
}

export default { id: "paper", title: "Paper", mount: paperRoom };
