// Elements, without a framework.

/** An element with attributes (functions are listeners) and children: `el("button", { onclick }, "Stop")`. Text is text, never markup. */
export function el(tag, attributes = {}, ...children) {
  const found = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") found.addEventListener(name.replace(/^on/, ""), value);
    else if (value === true) found.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) found.setAttribute(name, value);
  }
  found.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
  return found;
}

/** An SVG element, in the same way. */
export function svg(tag, attributes = {}, ...children) {
  const found = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") found.addEventListener(name.replace(/^on/, ""), value);
    else if (value !== false && value !== null && value !== undefined) found.setAttribute(name, value);
  }
  found.append(...children.flat());
  return found;
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

/** A picture that the program has written, put into the page without its scripts and listeners. */
export function picture(text) {
  const parsed = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  if (parsed.localName !== "svg") return el("p", { class: "error" }, "there is no picture");
  const all = [parsed, ...parsed.querySelectorAll("*")];
  all.filter((one) => ["script", "foreignObject", "iframe"].includes(one.localName)).forEach((one) => one.remove());
  for (const one of all) {
    for (const { name, value } of [...one.attributes]) {
      if (name.startsWith("on") || (name.endsWith("href") && !value.startsWith("#"))) one.removeAttribute(name);
    }
  }
  return document.importNode(parsed, true);
}

/** The same in the shadow of an element: its colours and classes, which are for a page of its own, then do not reach those of this one. */
export function frame(host, text) {
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  root.replaceChildren(picture(text.replaceAll(":root", ":host")));
}
