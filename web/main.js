// The rooms of the page, and what runs.

import { read, write } from "./address.js";
import curve from "./curve.js";
import { el } from "./dom.js";
import { Engine } from "./engine.js";
import mesh from "./mesh.js";
import paper from "./paper.js";
import scheme from "./scheme.js";

const ROOMS = [scheme, curve, mesh, paper];

/** How long something runs until the page says so, in milliseconds. */
const PATIENCE = 500;

const engine = new Engine();
const main = document.querySelector("main");
const tabs = document.querySelector("nav");
const work = document.querySelector("#work");
const mounted = new Map();

const tick = () => {
  const { running, since, progress } = shown;
  const elapsed = running ? performance.now() - since : 0;
  work.hidden = elapsed < PATIENCE;
  if (!work.hidden) work.querySelector("output").value = `${progress || "computing"}, ${(elapsed / 1000).toFixed(0)} s`;
};
let shown = { running: null };
let ticking = null;
engine.onChange = (change) => {
  shown = change;
  clearInterval(ticking);
  if (change.running) ticking = setInterval(tick, 250);
  tick();
};
work.querySelector("button").addEventListener("click", () => engine.stop());

/** The values of a room that was left, which the address no longer has: kept until the browser is closed. */
function keep(id, values) {
  try {
    sessionStorage.setItem(`subcert-${id}`, JSON.stringify(values));
  } catch {
    // A browser that keeps nothing, or not so much, has the address alone.
  }
}

function kept(id) {
  try {
    const found = JSON.parse(sessionStorage.getItem(`subcert-${id}`));
    const is = typeof found === "object" && found !== null && !Array.isArray(found);
    return Object.fromEntries(Object.entries(is ? found : {}).filter(([, value]) => typeof value === "string"));
  } catch {
    return {};
  }
}

/** Shows a room with these values, which it reads when it is entered. */
function enter(id, values) {
  const room = ROOMS.find((one) => one.id === id) ?? ROOMS[0];
  for (const one of ROOMS) {
    const tab = document.querySelector(`#tab-${one.id}`);
    tab.setAttribute("aria-selected", one === room);
    tab.tabIndex = one === room ? 0 : -1;
    const place = mounted.get(one.id)?.place;
    if (place) place.hidden = one !== room;
  }
  if (!mounted.has(room.id)) {
    const place = el("section", { id: `room-${room.id}`, role: "tabpanel", "aria-labelledby": `tab-${room.id}`, tabindex: "-1" });
    main.append(place);
    let known = Object.keys(values).length > 0 ? values : kept(room.id);
    const state = {
      get: () => known,
      set(changes) {
        known = { ...known, ...changes };
        keep(room.id, known);
        if (!place.hidden) write(room.id, known);
      },
      replace(values) {
        known = values;
      },
    };
    mounted.set(room.id, { place, state, ...room.mount(place, { engine, state, enter }) });
  } else if (Object.keys(values).length > 0) {
    const { state, restore } = mounted.get(room.id);
    state.replace(values);
    restore?.();
  }
  write(room.id, mounted.get(room.id).state.get());
  document.title = `${room.title} – subcert`;
}

/** Enters another room, so that the browser's way back leads to this one. */
function go(id) {
  const { room } = read();
  mounted.get(room)?.leave?.();
  if (room !== id) history.pushState(null, "", `#${id}`);
  enter(id, {});
}

for (const room of ROOMS) {
  const tab = el("button", { id: `tab-${room.id}`, role: "tab", type: "button", onclick: () => go(room.id) }, room.title);
  tabs.append(tab);
}
tabs.addEventListener("keydown", (event) => {
  const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  if (!step) return;
  const all = [...tabs.children];
  const next = all[(all.indexOf(document.activeElement) + step + all.length) % all.length];
  next.focus();
  next.click();
});
addEventListener("hashchange", () => {
  const { room, values } = read();
  enter(room, values);
});
const { room, values } = read();
enter(room, values);
