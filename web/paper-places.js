// Where things stand in the text of a claim file: its claims, the cells of its tables, and the places that an error names.
// Verdicts come from the program; this only finds lines for them.

/** How long a text may be, in bytes and in lines: a browser lays out no longer ones at once. */
export const PAPER_BYTES = 2 ** 20;
const PAPER_LINES = 20_000;

/** What is said of a text that is too long, or null. */
export function paperTooLong(text) {
  const most = `at most 1 MiB and ${PAPER_LINES.toLocaleString("en")} lines`;
  if (text.length > PAPER_BYTES || (text.length * 3 > PAPER_BYTES && new TextEncoder().encode(text).length > PAPER_BYTES)) return `This text is longer than 1 MiB. The editor takes ${most}; audit it on your computer: subcert audit FILE`;
  let lines = 1;
  for (let at = text.indexOf("\n"); at >= 0; at = text.indexOf("\n", at + 1)) lines += 1;
  return lines > PAPER_LINES ? `This text has ${lines.toLocaleString("en")} lines. The editor takes ${most}; audit it on your computer: subcert audit FILE` : null;
}

const paperToken = /#[^\n]*|"""[\s\S]*?"""|'''[\s\S]*?'''|"(?:\\.|[^"\\\n])*"?|'[^'\n]*'?|[[\]{}=,\n]|[^\s#"'[\]{}=,]+/g;

/** The cells of a table, as [row, column, from, to], from the tokens of the array. */
function paperCells(tokens) {
  const cells = [];
  let [depth, row, column, from] = [0, 0, 0, null];
  for (const { 0: text, index } of tokens) {
    if (text === "\n" || text.startsWith("#")) continue;
    if (text === "[" && depth === 1) [row, column] = [row + 1, 1];
    if (text === "," && depth === 2) column += 1;
    else if (depth === 2 && text !== "]" && from === null) from = index;
    if (text === "[" || text === "{") depth += 1;
    if (text === "]" || text === "}") depth -= 1;
    if (from !== null && depth === 2) {
      cells.push([row, column, from, index + text.length]);
      from = null;
    }
  }
  return cells;
}

/** Lines of tokens; what stands in brackets is one line. */
function paperLines(text) {
  const lines = [[]];
  let depth = 0;
  for (const token of text.matchAll(paperToken)) {
    if (token[0] === "\n" && depth === 0) lines.push([]);
    else lines.at(-1).push(token);
    if ("[{".includes(token[0])) depth += 1;
    if ("]}".includes(token[0])) depth = Math.max(0, depth - 1);
  }
  return lines.filter((line) => line.length > 0 && !line[0][0].startsWith("#"));
}

/** The places of the last text: a cursor that moves asks for them again. */
let paperKnown = { text: null };

/**
 * The places of claims by their ids without the key: `table-1`, `table-1:2:3`. `from` and `to` are what a cursor should select,
 * `start` and `end` all of the claim.
 */
export function paperPlaces(text) {
  if (paperKnown.text !== text) paperKnown = { text, places: paperFound(text) };
  return paperKnown.places;
}

function paperFound(text) {
  const blocks = [];
  for (const line of paperLines(text)) {
    const first = line[0];
    if (first[0] === "[") {
      const name = line.find((token) => token[0] !== "[")?.[0] ?? "";
      // A table within a claim, such as [table.given], belongs to it.
      if (name.includes(".")) continue;
      if (blocks.length > 0) blocks.at(-1).end = first.index;
      blocks.push({ start: first.index, end: text.length, cells: [] });
    } else if (line[1]?.[0] === "=" && blocks.length > 0) {
      const block = blocks.at(-1);
      if (first[0] === "id" && line[2]) Object.assign(block, { id: line[2][0].slice(1, -1), from: first.index, to: line[2].index + line[2][0].length });
      if (first[0] === "cells") block.cells = paperCells(line.slice(2));
    }
  }
  const places = new Map();
  for (const { id, from, to, start, end, cells } of blocks) {
    if (id === undefined) continue;
    places.set(id, { from, to, start, end });
    for (const [row, column, first, last] of cells) places.set(`${id}:${row}:${column}`, { from: first, to: last, start: first, end: last });
  }
  return places;
}

/** The number of the line at an offset, from 1. */
export function paperLineAt(text, offset) {
  return text.slice(0, offset).split("\n").length;
}

/** The same for many offsets of a text, whose lines are looked for once. */
export function paperLinesOf(text) {
  const ends = [...text.matchAll(/\n/g)].map(({ index }) => index);
  return (offset) => {
    let [low, high] = [0, ends.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (ends[middle] < offset) low = middle + 1;
      else high = middle;
    }
    return low + 1;
  };
}

/** The places that the text of an error names in `file`: { line, column, length }. Columns count characters, from 1. */
export function paperErrors(errors, file) {
  const places = [];
  for (const part of errors.split(/^(?=error)/m)) {
    const arrow = /^ *--> (.+):(\d+):(\d+)$/m.exec(part);
    if (!arrow || arrow[1] !== file) continue;
    const [line, column] = [Number(arrow[2]), Number(arrow[3])];
    // Below a quoted line stand marks: ^ for the place itself, - for what it disagrees with.
    const quoted = [...part.matchAll(/^ *(\d+) \|.*\n *\| ( *)(\^+|-+)/gm)];
    const own = quoted.find((one) => one[3][0] === "^" && Number(one[1]) === line);
    places.push({ line, column, length: own?.[3].length ?? 1 });
    for (const one of quoted) if (one !== own) places.push({ line: Number(one[1]), column: one[2].length + 1, length: one[3].length });
  }
  return places;
}

/** The offset of a line and a column, which counts characters and not the units of JavaScript's strings. */
export function paperOffset(text, line, column) {
  const lines = text.split("\n");
  const before = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
  return before + [...(lines[line - 1] ?? "")].slice(0, column - 1).join("").length;
}
