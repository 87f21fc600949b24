// The answers of the program as tables, built from the fields that are there.

import { el } from "./dom.js";
import { shortly } from "./numbers.js";
import { schemeOrder } from "./scheme-controls.js";

/** Fields, what they are called here, and their order. */
const SCHEME_LABELS = {
  arity: "arity (new points for each old one)", dilation: "dilation matrix", points: "points in a rule", coefficients: "coefficients that are not 0", kind: "kind", interpolating: "keeps all points (interpolating)",
  support: "support of the basic limit function", support_length: "length of the support", centre: "centre of symmetry", symmetries: "symmetries of the mask",
  sum_rules: "order of the sum rules", generation: "generates polynomials up to degree", reproduction: "reproduces polynomials up to degree", accuracy: "accuracy", natural_shift: "natural shift",
  displacement: "σ, the step between two polygons", displacement_natural: "σ at the natural parameters", best_offset: "best offset",
  depth_natural: "levels to be within 1/100", depth_indexed: "the same, with points at i/nᵏ",
  stencils: "limit stencil", values: "values of the basic limit function", open: "open",
  verdict: "verdict", reason: "why", regular: "regular valence", subdominant: "subdominant eigenvalue", next: "next eigenvalue", hoelder: "Hölder exponent", curvature: "curvature",
  elliptic: "curvature of elliptic shapes", hyperbolic: "curvature of hyperbolic shapes", least_jacobian: "the Jacobian is at least",
};
const SCHEME_HIDDEN = new Set(["schema", "scheme", "contraction", "norm", "continuity", "continuity_fails", "edges", "points_at", "valence", "converges", "bisections", "block", "blocks", "in_order", "ranges", "attained"]);

/** An exact value with its decimal, in few characters. */
function schemeExact(value) {
  const { exact, decimal } = value;
  if (exact === decimal) return exact;
  const close = shortly(value, 12);
  return exact.length > 60 ? close : `${exact} = ${close}`;
}

/** The Hölder exponent: a formula and decimals, or two bounds. */
function schemeExponent(hoelder) {
  if (!hoelder) return "not known";
  const { lower, upper, exact = null, attained } = hoelder;
  const decimals = lower === upper ? lower.replace(/\.?0+$/, "") : `from ${lower} to ${upper}`;
  const value = exact === null ? decimals : exact === decimals ? exact : `${exact} = ${shortly({ exact, decimal: lower })}`;
  return `${value}${attained === false ? ", not attained" : ""}`;
}

const NOT_CONTINUOUS = "not continuous";

/** The limits in a word or two. */
function schemeLimits({ continuity, continuity_fails: fails, converges }) {
  if (continuity === null || continuity === undefined) {
    return fails === 0 || converges === false ? NOT_CONTINUOUS : "not decided";
  }
  const more = fails === null || fails === undefined ? "" : fails === continuity + 1 ? `not ${schemeOrder(fails)}` : `not ${schemeOrder(fails)}; between, open`;
  return more ? `${schemeOrder(continuity)}, ${more}` : schemeOrder(continuity);
}

const schemeIsExact = (value) => typeof value?.exact === "string" && typeof value.decimal === "string";

/** Any value of an answer as text. */
function schemeText(value) {
  if (value === null) return "none";
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value !== "object") return String(value);
  if (Array.isArray(value)) {
    if (value.length === 2 && value.every((one) => schemeIsExact(one) && one.index === undefined)) return `from ${value[0].exact} to ${value[1].exact}`;
    const inner = value.map(schemeText);
    return value.some(Array.isArray) && !value.flat().some((one) => typeof one === "object") ? `[${inner.map((one) => `[${one}]`).join(", ")}]` : inner.join(", ");
  }
  if (schemeIsExact(value)) {
    const at = value.index ?? null;
    return at === null ? schemeExact(value) : `${value.exact} at ${at}`;
  }
  if (typeof value.lower === "number") return value.lower === value.upper ? String(value.lower) : `from ${value.lower} to ${value.upper}`;
  if (value.place && value.value) return `${value.value.exact} at (${value.place.join(", ")})`;
  if (value.fact) return `${value.fact}: ${value.reason}`;
  return Object.entries(value).filter(([, one]) => one !== null).map(([name, one]) => `${name.replaceAll("_", " ")} ${schemeText(one)}`).join("; ");
}

/** Weights of points, as `-1/16 at -1, …`, each stencil by itself. */
function schemeStencils(stencils) {
  return stencils.map(({ parameter, weights }) => el("div", {}, `at ${parameter.exact}: `, weights.map(({ exact, decimal, index }, place) =>
    `${place > 0 ? ", " : ""}${exact.length > 30 ? shortly({ exact, decimal }, 10) : exact} of x${index < 0 ? "₋" : ""}${String(Math.abs(index)).replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[digit])}`)));
}

/** A table of names and values; an empty value is left out. */
export function schemePairs(caption, pairs) {
  const rows = pairs.filter(([, value]) => value !== null && value !== "" && value !== undefined && value !== false);
  if (rows.length === 0) return null;
  return el("table", { class: "scheme-pairs" }, el("caption", {}, caption), el("tbody", {}, rows.map(([name, value]) => el("tr", {}, el("th", { scope: "row" }, name), el("td", {}, value)))));
}

function schemeRows(facts) {
  const known = Object.keys(SCHEME_LABELS).filter((name) => name in facts);
  const others = Object.keys(facts).filter((name) => !(name in SCHEME_LABELS) && !SCHEME_HIDDEN.has(name));
  return [...known, ...others].filter((name) => facts[name] !== null && !(Array.isArray(facts[name]) && facts[name].length === 0)).map((name) => {
    const value = facts[name];
    const label = SCHEME_LABELS[name] ?? name.replaceAll("_", " ");
    if (name === "hoelder") return [Array.isArray(value) ? "Hölder exponent of the first derivatives" : label, schemeExponent(Array.isArray(value) ? { lower: value[0], upper: value[1], attained: facts.attained } : value)];
    if (name === "natural_shift" && Array.isArray(value)) return [label, `(${value.map(({ exact }) => exact).join(", ")})`];
    if (name === "support" && value.every(Array.isArray)) return [label, value.map(schemeText).join("; ")];
    if (name === "open") return [label, value.map((one) => el("div", {}, schemeText(one)))];
    if (name === "stencils") return [label, schemeStencils(value)];
    if (name === "best_offset") return [label, `${value.offset}, with σ = ${schemeExact(value.displacement)}`];
    return [label, schemeText(value)];
  });
}

/** All facts: of a mask, of a mask on Z^d, or of the rules at each valence. */
export function schemeFacts(answer) {
  const notes = (answer.notes ?? []).map((note) => el("p", { class: "soft" }, note));
  const facts = answer.curve ?? answer.lattice;
  if (facts) return [...notes, schemePairs("All facts", schemeRows(facts).filter(([name]) => name !== SCHEME_LABELS.hoelder))];
  const around = (answer.valences ?? []).map(({ vertex, valence, ...others }) => schemePairs(`Valence ${valence}`, schemeRows({ ...vertex, ...others, points: null })));
  return [...notes, ...around];
}

const schemeVerdict = ({ verdict }) => ({ proved: "C¹", refuted: "not C¹", fails: "not C¹", open: "open" })[verdict] ?? verdict;

/** What `smoothness` says, in a few words for who does not see the page. */
export const schemeSaid = (answer) => (answer.valences ? answer.valences.map(schemeVerdict).join(", ") : schemeLimits(answer));

/** What `smoothness` says, as pairs for the head of the room. */
export function schemeHead(answer) {
  if (answer.valences) {
    return answer.valences.map((one) => [`Valence ${one.valence}`, [el("strong", {}, schemeVerdict(one)),
      `: ${one.reason}${one.hoelder ? `; Hölder exponent of the first derivatives ${schemeExponent({ lower: one.hoelder[0], upper: one.hoelder[1], attained: one.attained })}` : ""}`]]);
  }
  const { field } = answer;
  return [["Limits", el("strong", {}, schemeLimits(answer))], ["Hölder exponent", schemeLimits(answer) !== NOT_CONTINUOUS && el("strong", {}, schemeExponent(answer.hoelder))],
    ["the number t in formulas", field && `about ${field.decimal}, a root of ${field.minimal_polynomial}`]];
}

/** A number of a table: the fraction and the decimal, or only the latter where the former is long. */
function schemeCells(value) {
  if (!value) return [el("td", {}, "–"), el("td", {}, "")];
  const long = value.exact.length > 17;
  const decimal = shortly(value, 9);
  return [el("td", { class: "number", title: long ? value.exact : null }, long ? "" : value.exact), el("td", { class: "number" }, value.exact === value.decimal ? "" : decimal)];
}

function schemeLevelTable(caption, levels) {
  const head = el("tr", {}, el("th", { scope: "col" }, "c"), el("th", { scope: "col", colspan: 2 }, "T", el("sub", {}, "c")), el("th", { scope: "col", colspan: 2 }, "Λ", el("sub", {}, "c")));
  return el("table", {}, el("caption", {}, caption), el("thead", {}, head),
    el("tbody", {}, levels.map(({ c, contraction, norm }) => el("tr", {}, el("th", { scope: "row" }, String(c)), schemeCells(contraction), schemeCells(norm)))));
}

function schemeRules(direction, caption) {
  return el("table", { class: "scheme-rules" }, el("caption", {}, caption), el("tbody", {}, direction.mask.map((row, rule) =>
    el("tr", {}, el("th", { scope: "row" }, `rule ${rule}`), row.map((one) => el("td", { class: "number" }, one))))));
}

/** What `constants` says: the levels, and the rules of masks. */
export function schemeLevels(answer) {
  const directions = answer.directions ?? [];
  const which = (place) => (directions.length > 1 ? `, direction ${place + 1}` : "");
  const levels = answer.levels ? [schemeLevelTable("Constants of c levels", answer.levels)]
    : directions.flatMap((one, place) => [schemeLevelTable(`Constants of c levels${which(place)}`, one.levels), one.ended && el("p", { class: "soft" }, `–: ${one.ended}.`)]);
  return [...levels.filter(Boolean), ...directions.map((one, place) => schemeRules(one, `Coefficients of the new points${which(place)}`))];
}
