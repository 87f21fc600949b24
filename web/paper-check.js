// The certificate of a claim file, and what the independent checker says of it.

import { el } from "./dom.js";
import { Stopped } from "./engine.js";

/** The lines of the checker: { id, state, says, kind }. */
function paperChecks(text) {
  const kinds = { certified: "good", cited: "doubt", incomplete: "doubt", invalid: "bad" };
  const found = [...text.matchAll(/^(certified|cited|incomplete|invalid) +(\S+): (.*)$/gm)];
  return found.map(([, state, id, says]) => ({ id, state, says, kind: kinds[state] }));
}

let paperLatest = 0;

/**
 * Writes the certificate of a text, lets the checker read it, and shows its lines in `place`. The answer: the lines, or none when
 * there is no answer about the text that `current()` gives then.
 */
export async function paperCheck(engine, file, current, place, jump) {
  const mine = ++paperLatest;
  // A check that a later one has replaced says nothing.
  const tell = (...content) => mine === paperLatest && place.replaceChildren(...content);
  const refuse = ({ code, errors }) => tell(el("div", { class: "error mono", role: "alert" }, errors.trim() || `The program ended without a message, with exit code ${code}.`));
  const text = current();
  /** Whether a step has failed, or the text is another one than that which it is about; then this is said. */
  const ends = (answer) => {
    if (current() !== text) tell(el("p", {}, "The text has changed meanwhile. Check again."));
    else if (answer.code > 1) refuse(answer);
    return current() !== text || answer.code > 1;
  };
  const files = { [file]: text };
  tell(el("p", {}, "Writing the certificate …"));
  try {
    const proved = await engine.run(["prove", file, "-o", "-"], { files, kind: "paper-check" });
    if (ends(proved)) return [];
    tell(el("p", {}, "The checker reads it …"));
    const answer = await engine.run([file, "paper.cert"], { program: "subcert-check", kind: "paper-check", files: { ...files, "paper.cert": proved.text } });
    if (ends(answer)) return [];
    const checks = paperChecks(answer.text);
    const local = (id) => id.slice(id.indexOf(":") + 1);
    tell(el("ul", { class: "paper-checks" }, checks.map(({ id, state, says, kind }) => el("li", {},
      el("span", { class: `paper-verdict ${kind}` }, state), " ", el("span", { class: "mono" }, local(id)), `: ${says} `,
      el("button", { type: "button", "aria-label": `go to ${local(id)}`, onclick: () => jump(local(id)) }, "go there")))),
    el("p", {}, answer.text.trim().split("\n").at(-1)),
    el("p", { class: "soft" }, "certified: the checker has confirmed the verdict itself, also where the verdict is that the claim is wrong. invalid: the certificate does not show the verdict. incomplete: it lacks something. cited: it rests on a theorem whose proof is on paper."));
    return checks;
  } catch (error) {
    if (error instanceof Stopped) tell(el("p", {}, "Stopped."));
    else tell(el("div", { class: "error", role: "alert" }, `The checker is a second program, subcert-check, and it could not be started here (${error.message}). Save the claim file and the certificate, and let it check them on your computer: subcert-check CLAIMS.toml CERTIFICATE.cert`));
    return [];
  }
}
