// Numbers as text, in few characters, never rounded: `…` stands for digits that are left out.

/** Before the point there are so many digits at most, and behind it so many zeros; other numbers are written with a power of ten. */
const [WHOLE, ZEROS] = [15, 6];
/** A fraction that begins with more zeros is written as the program writes it. */
const SMALLEST = 3000;

/**
 * The first digits of a decimal, about `count` from its first one that is not 0. All digits before the point are kept, and so is a power of ten:
 * 123456789.25 is 123456789…, 0.000123456 is 0.000123456, and 1.9999999999e-16 is 1.9999999…e-16.
 */
export function digits(text, count = 8) {
  const found = /^(-?)(\d+)(?:\.(\d*))?(?:e([+-]?\d+))?$/i.exec(String(text));
  if (!found) return String(text);
  const [, sign, whole, behind = "", power] = found;
  if (whole.length > WHOLE && power === undefined) return digits(`${sign}${whole[0]}.${whole.slice(1)}${behind}e${whole.length - 1}`, count);
  const part = behind.replace(/0+$/, "");
  const zeros = /^0*$/.test(whole) ? /^0*/.exec(part)[0].length : -whole.length;
  const kept = part.slice(0, Math.max(0, zeros + count));
  return `${sign}${whole}${kept ? `.${kept}` : ""}${kept.length < part.length ? "…" : ""}${power === undefined ? "" : `e${power}`}`;
}

/** The first digits of p/q, for q > 0 and p ≥ 0; null if it is too small. */
function quotient(p, q, count) {
  const whole = p / q;
  let rest = p % q;
  const text = String(whole);
  if (text.length > WHOLE) {
    const kept = text.slice(1, count).replace(/0+$/, "");
    const more = rest > 0n || /[1-9]/.test(text.slice(count));
    return `${text[0]}${more || kept ? `.${more ? text.slice(1, count) : kept}` : ""}${more ? "…" : ""}e${text.length - 1}`;
  }
  let part = "";
  let [used, zeros] = [whole > 0n ? text.length : 0, 0];
  while (rest > 0n && used < count) {
    rest *= 10n;
    const digit = rest / q;
    rest %= q;
    part += digit;
    if (used > 0 || digit > 0n) used += 1;
    else zeros += 1;
    if (zeros > SMALLEST) return null;
  }
  const more = rest > 0n ? "…" : "";
  if (whole > 0n || zeros <= ZEROS) return `${text}${part ? `.${part}` : ""}${more}`;
  return `${part[zeros]}${part.length > zeros + 1 ? `.${part.slice(zeros + 1)}` : ""}${more}e-${zeros + 1}`;
}

/** The first digits of a value. The decimal of the program is rounded to 17 digits; those of a fraction come from the fraction itself. */
export function shortly({ exact, decimal }, count = 8) {
  const found = /^(-?)(\d+)(?:\/(\d+))?$/.exec(exact);
  const own = found && quotient(BigInt(found[2]), BigInt(found[3] ?? 1), count);
  if (own) return `${found[1]}${own}`;
  // What is no fraction has no last digit.
  const cut = digits(decimal, count);
  return cut.includes("…") ? cut : cut.replace(/(?=e|$)/, "…");
}
