// Numbers as text, in few characters.

/** Before the point there are so many digits at most; a longer number is written with a power of ten. */
const WHOLE = 15;

/**
 * The first digits of a decimal, never rounded: about `count` from its first one that is not 0. `…` stands for the others. All digits before the point are
 * kept, and so is a power of ten: 123456789.25 is 123456789…, 0.000123456 is 0.000123456, and 1.9999999999e-16 is 1.9999999…e-16.
 */
export function digits(text, count = 8) {
  const found = /^(-?)(\d+)(?:\.(\d*))?(?:e([+-]?\d+))?$/i.exec(String(text));
  if (!found) return String(text);
  const [, sign, whole, part = "", power] = found;
  if (whole.length > WHOLE && power === undefined) return digits(`${sign}${whole[0]}.${whole.slice(1)}${part}e${whole.length - 1}`, count);
  const zeros = /^0*$/.test(whole) ? /^0*/.exec(part)[0].length : -whole.length;
  const kept = part.slice(0, Math.max(0, zeros + count));
  return `${sign}${whole}${kept ? `.${kept}` : ""}${kept.length < part.length ? "…" : ""}${power === undefined ? "" : `e${power}`}`;
}
