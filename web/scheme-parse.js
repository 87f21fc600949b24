// What the visitor typed: the text of a scheme, its parameters and their values. Nothing is computed here.

const SCHEME_NAME = /^[A-Za-z_]\w*$/;

/** The values in `w=1/16,k=2`, by name. The text may come from an address: names that are no names are dropped. */
export function schemeValues(text) {
  const found = new Map();
  for (const part of String(text ?? "").split(/,(?=\s*[A-Za-z_]\w*\s*=)/)) {
    const at = part.indexOf("=");
    const name = part.slice(0, at).trim();
    if (at > 0 && SCHEME_NAME.test(name)) found.set(name, part.slice(at + 1).trim());
  }
  return found;
}

/** The same, as a text. */
export function schemeValuesText(values) {
  return [...values].map(([name, value]) => `${name}=${value}`).join(",");
}

/** The scheme without the values behind its colon, and these values. */
export function schemeSplit(text) {
  const at = text.lastIndexOf(":");
  const given = at < 0 ? new Map() : schemeValues(text.slice(at + 1));
  return given.size > 0 ? { family: text.slice(0, at), given } : { family: text, given };
}

/** The scheme with values for its open parameters. */
export function schemeWith(text, values) {
  if (values.size === 0) return text;
  return `${text}${schemeSplit(text).given.size > 0 ? "," : ":"}${schemeValuesText(values)}`;
}

/** Where a value stands on a slider, if it is a decimal or a fraction: for drawing only. */
export function schemePlace(value) {
  const parts = /^\s*(-?\d*\.?\d+)\s*(?:\/\s*(\d*\.?\d+)\s*)?$/.exec(value);
  return parts ? Number(parts[1]) / Number(parts[2] ?? 1) : null;
}

/** What the catalogue tells of a parameter: whether it counts something, and where to begin. */
export function schemeParameter({ name, default: usual = null, least = null, about = null }) {
  const counts = least !== null;
  const first = Number(least ?? 0);
  // Where only every second number is allowed, the description counts them: 3, 5, …
  const list = /(\d+), (\d+), (?:\d+, )*…/.exec(about ?? "");
  const step = list ? Number(list[2]) - Number(list[1]) : 1;
  const around = /valence|vertices of the face/.test(about ?? "");
  const start = counts ? (usual ?? String(around ? 5 : first + step)) : usual;
  return { name, about, counts, least: first, step, start };
}

const schemeControlled = (text) => /(?!\t)\p{Cc}/u.exec(text)?.[0] ?? null;
const schemeCoded = (one) => `U+${one.codePointAt(0).toString(16).toUpperCase().padStart(4, "0")}`;

/** Why the program is not asked about a text, or null: what begins with `-` would be taken for an option, and a NUL for the end. */
export function schemeRefused(text) {
  if (text === "") return "a scheme is missing: type a mask such as [1, 3, 3, 1]/4, a symbol, or a name";
  if (text.startsWith("-")) return "a scheme does not begin with -; if it is a symbol, put it in brackets, as in (-1+9*z^2+16*z^3+9*z^4-z^6)/16";
  const wrong = schemeControlled(text);
  return wrong && `a scheme has no control characters, and there is a ${schemeCoded(wrong)} in this one: delete it`;
}

/** What the value of a parameter lacks, or null. */
export function schemeLacks(name, value) {
  if (value === "") return `the value of ${name} is missing: a decimal or a fraction, such as 1/16`;
  const wrong = schemeControlled(value);
  if (wrong) return `a value has no control characters, and there is a ${schemeCoded(wrong)} in this one: delete it`;
  const decimal = /^(-?\d+),(\d+)$/.exec(value);
  if (decimal) return `a decimal is written with a point: ${decimal[1]}.${decimal[2]}`;
  const last = value.at(-1);
  return "+-*/^(=".includes(last) ? `the value of ${name} is not finished: something is missing after ${last}` : null;
}

/** The parameter that an error of the program asks for, if it is about this very scheme, and a value that it names. */
export function schemeAsked(error, text) {
  const asked = /^error: `([^]*?)` needs its parameter `(\w+)`/.exec(error);
  if (!asked || asked[1] !== text) return null;
  return { name: asked[2], start: /, such as ([^,`\s]+),/.exec(error)?.[1] ?? null };
}

const schemeQuoted = (text) => (text.includes("'") ? JSON.stringify(text) : `'${text}'`);

/** A scheme file, or for what is not a mask of curves and has a name, a part of a claim file. */
export function schemeToml(text, values, known, constants) {
  const whole = schemeWith(text, values);
  const direction = constants?.directions?.length === 1 ? constants.directions[0] : null;
  const { family, given } = schemeSplit(text);
  const lines = ['name = "my-scheme"'];
  if (!known && !/\.toml\b|\sx\s/.test(family)) {
    for (const [name, value] of [...given, ...values]) lines.push(`parameters.${name} = { default = ${schemeQuoted(value)} }`);
    lines.push(`${/[[{]/.test(family) ? "mask" : "symbol"} = ${schemeQuoted(family)}`);
    return `${lines.join("\n")}\n`;
  }
  if (direction) {
    const rows = direction.mask.map((row) => `    [${row.map(schemeQuoted).join(", ")}],`);
    lines.unshift(`# ${whole.replace(/\s+/g, " ")}`);
    lines.push(`offset = '${direction.offset}'`, "mask = [", ...rows, "]");
    return `${lines.join("\n")}\n`;
  }
  return `# for a claim file\n[[scheme]]\nname = "my-scheme"\nuse = ${schemeQuoted(whole)}\n`;
}
