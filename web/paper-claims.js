// The list of claims with their verdicts, from the JSON of `subcert audit`.

import { el } from "./dom.js";

/** The words of verdicts: colour, sign, and what they mean. docs/verdicts.md has the rest. */
const PAPER_WORDS = {
  refuted: ["bad", "✗", "the printed number or statement is not what the printed definition gives, and nothing explains it"],
  fails: ["bad", "✗", "the two sides are not equal"],
  inexact: ["bad", "✗", "the printed range is not the exact one"],
  misprint: ["bad", "±", "one slip of the pen away from the exact value"],
  "other-reading": ["doubt", "⇄", "wrong by the printed definition, and right if it is read differently; the other reading is named"],
  rounding: ["doubt", "≈", "rounded otherwise than to the nearest"],
  reproduced: ["doubt", "=", "right at a value that the paper does not state and the program has found"],
  "not-checkable": ["doubt", "?", "the claim lacks something; the reason is named"],
  open: ["doubt", "?", "neither shown nor refuted"],
  confirmed: ["good", "✓", "the printed number is the exact value, rounded to the nearest"],
  holds: ["good", "✓", "the two sides are equal"],
  exact: ["good", "✓", "the printed range is the exact one"],
  proved: ["good", "✓", "proved"],
  otherwise: ["bad", "✗", "another table than the file says"],
  ulps: ["bad", "✗", "some units in the last place away"],
  cut: ["doubt", "≈", "the exact value, cut to the digits written"],
  nearest: ["good", "✓", "the nearest number of its type"],
};
const PAPER_ORDER = Object.keys(PAPER_WORDS);

export const paperWord = (verdict) => {
  const [kind, sign, about] = PAPER_WORDS[verdict] ?? ["doubt", "?", ""];
  return { kind, sign, about };
};

/** The one of two verdicts that a reader should see first. */
export const paperWorse = (one, other) => (PAPER_ORDER.indexOf(one) <= PAPER_ORDER.indexOf(other) ? one : other);

/** The word for the promise of a printed depth or bound; null where there is none. */
export function paperPromise({ kind, sound }) {
  if (!sound || kind !== "number" || sound.kept === undefined) return null;
  return sound.kept === null ? "open" : sound.kept ? "kept" : "broken";
}

const paperPair = (label, value) => value !== null && value !== undefined && el("span", {}, el("span", { class: "soft" }, `${label} `), el("span", { class: "mono" }, value));

/** What a claim says and what is true, in a few lines. */
function paperFacts(claim) {
  const { printed, exact, decimal, reading, note, failures, sound } = claim;
  const broken = sound?.broken_by;
  const first = failures?.[0];
  return [
    el("div", { class: "paper-values" },
      paperPair(claim.kind === "number" ? "printed" : "says", printed ?? "nothing legible"),
      paperPair("exact", exact),
      exact !== decimal && paperPair("as a decimal", decimal)),
    reading && el("p", {}, `Read differently: ${reading.differs}. That gives `, el("span", { class: "mono" }, reading.exact), "."),
    first && el("div", { class: "paper-values" }, el("span", {}, `For example, at ${first.at}:`), paperPair("left", first.left), paperPair("right", first.right)),
    broken?.distance && el("p", {}, `Promise broken: at level ${broken.level} the distance can be `, el("span", { class: "mono" }, broken.distance.exact),
      ", and ", el("span", { class: "mono" }, broken.promised.exact), " is promised."),
    note && el("p", { class: "soft" }, note),
  ];
}

/** A claim, with buttons. `line` is where it stands in the editor, or null. */
function paperClaim(claim, { line, jump, explain, checked }) {
  const { kind, sign } = paperWord(claim.verdict);
  const promise = paperPromise(claim);
  const more = el("div", { class: "paper-more", hidden: true });
  const details = el("button", { type: "button", "aria-expanded": "false", "aria-label": `details of ${claim.locus}`, onclick: () => {
    more.hidden = !more.hidden;
    details.setAttribute("aria-expanded", String(!more.hidden));
    if (!more.hidden) explain(claim, more);
  } }, "details");
  return el("li", { class: `paper-claim ${kind}` },
    el("div", { class: "paper-title" },
      el("strong", {}, claim.locus),
      claim.verdict && el("span", { class: `paper-verdict ${kind}` }, `${sign} ${claim.verdict}`),
      promise && el("span", { class: `paper-verdict ${{ kept: "good", broken: "bad", open: "doubt" }[promise]}` }, `promise ${promise}`),
      checked && el("span", { class: `paper-verdict ${checked.kind}` }, `checker: ${checked.state}`)),
    el("div", { class: "paper-facts" }, paperFacts(claim)),
    el("div", { class: "paper-buttons" },
      line && el("button", { type: "button", onclick: () => jump(claim), "aria-label": `line ${line}, ${claim.locus}` }, `line ${line}`),
      claim.verdict && details),
    more);
}

/** At most so many claims are listed at once. */
const PAPER_MOST = 1000;

/** The list, with a button for each verdict that shows only its claims. `summary` are the program's counts. */
export function paperClaims(claims, summary, promises, { chosen, choose, ...helpers }) {
  const counts = PAPER_ORDER.filter((verdict) => summary[verdict] > 0).map((verdict) => [verdict, summary[verdict], paperWord(verdict)]);
  const broken = promises?.broken > 0 ? [["promise broken", promises.broken, { kind: "bad", sign: "✗", about: "a printed depth or error bound promises how near every control polygon is to its limit; for some control polygon this is false" }]] : [];
  const all = [["all", claims.length, { kind: "", sign: "", about: "" }], ...counts, ...broken];
  const shown = all.some(([name]) => name === chosen) ? chosen : "all";
  const belongs = (claim) => shown === "all" || claim.verdict === shown || (shown === "promise broken" && paperPromise(claim) === "broken");
  const listed = claims.filter(belongs);
  const about = all.find(([name]) => name === shown)[2].about;
  return [
    el("div", { class: "paper-filter", role: "group", "aria-label": "show claims with this verdict" },
      all.map(([name, count, { kind, sign }]) => el("button", { type: "button", class: kind, "aria-pressed": String(name === shown), onclick: () => choose(name) }, `${sign} ${count} ${name}`.trim()))),
    about && el("p", { class: "soft" }, `${shown}: ${about}.`),
    el("ol", { class: "paper-claims" }, listed.slice(0, PAPER_MOST).map((claim) => paperClaim(claim, {
      ...helpers,
      line: helpers.lineOf(claim),
      checked: helpers.checkOf(claim),
    }))),
    listed.length > PAPER_MOST && el("p", {}, `${listed.length - PAPER_MOST} more are not listed here. The reports below have them all.`),
  ].filter(Boolean);
}
