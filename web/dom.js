// Elements, without a framework.

const SVG = "http://www.w3.org/2000/svg";

/** An element with attributes (functions are listeners) and children: `el("button", { onclick }, "Stop")`. Text is text, never markup. */
export function el(tag, attributes = {}, ...children) {
  return filled(document.createElement(tag), attributes, children);
}

/** An SVG element, in the same way. */
export function svg(tag, attributes = {}, ...children) {
  return filled(document.createElementNS(SVG, tag), attributes, children);
}

const isThere = (value) => value !== null && value !== undefined && value !== false;

function filled(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name.replace(/^on/, ""), value);
    else if (isThere(value)) element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat().filter(isThere));
  return element;
}

let numbered = 0;

/** A label above an input. */
export function field(label, input, hint = null) {
  input.id ||= `input-${++numbered}`;
  const note = hint && el("small", { id: `${input.id}-hint` }, hint);
  if (note) input.setAttribute("aria-describedby", note.id);
  return el("div", { class: "field" }, el("label", { for: input.id }, label), input, note);
}

/** Calls `work` when nothing has happened for a while. */
export function later(work, milliseconds) {
  let waiting;
  return (...args) => {
    clearTimeout(waiting);
    waiting = setTimeout(() => work(...args), milliseconds);
  };
}

/** A file for the visitor: text or bytes. */
export function save(name, content, type = "text/plain") {
  const address = URL.createObjectURL(new Blob([content], { type }));
  el("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** Copies the address of the page; the answer is what to say of it. */
export async function copyLink(more = "") {
  try {
    await navigator.clipboard.writeText(location.href);
    return `The link is copied.${more}`;
  } catch {
    return "The browser does not let this page copy; the link is in the address bar.";
  }
}

/** What a picture may have: elements that only draw or describe, and their attributes. */
const DRAWS = new Set("svg title desc style g defs clipPath pattern path line polyline polygon rect circle ellipse text tspan".split(" "));
const SAYS = new Set(("xmlns id class role lang aria-label aria-labelledby aria-describedby aria-hidden viewBox preserveAspectRatio width height x y x1 y1 x2 y2 cx cy r rx ry dx dy"
  + " d points transform text-anchor dominant-baseline font-size font-weight fill fill-opacity fill-rule stroke stroke-width stroke-opacity stroke-dasharray"
  + " stroke-linecap stroke-linejoin opacity clip-path clipPathUnits patternUnits patternTransform href style").split(" "));

/** Whether a value loads nothing: it refers to nothing, or to a part of the picture. An escape could hide the name of a function. */
const stays = (value) => /^url\(#[\w-]+\)$/.test(value) || !/\\|url\s*\(/i.test(value);

/** Whether a style loads nothing. */
const plain = (style) => !/\\|@(?!media\b)|url\s*\(|image|src\s*\(/i.test(style);

/** Whether an element may stay. */
const draws = (one) => one.namespaceURI === SVG && DRAWS.has(one.localName) && (one.localName !== "style" || plain(one.textContent));

/** Whether an attribute may stay. */
const says = ({ name, value }) => SAYS.has(name) && stays(value) && (name !== "href" || value.startsWith("#")) && (name !== "style" || /^(fill|stroke):var\(--[\w-]+\)$/.test(value));

/** A picture that the program has written, put into the page with what draws, and nothing else. */
export function picture(text) {
  const parsed = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  if (parsed.localName !== "svg" || !draws(parsed)) return el("p", { class: "error" }, "there is no picture");
  for (const one of [parsed, ...parsed.querySelectorAll("*")]) {
    if (!draws(one)) one.remove();
    for (const attribute of [...one.attributes]) if (!says(attribute)) one.removeAttributeNode(attribute);
  }
  return document.importNode(parsed, true);
}

/** The same in the shadow of an element: its colours and classes, which are for a page of its own, then do not reach those of this one. */
export function frame(host, text) {
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  root.replaceChildren(picture(text.replaceAll(":root", ":host")));
}
