import { el } from "./dom.js";
export default { id: "curve", title: "Curve", mount(place) { place.append(el("p", {}, "to come")); return {}; } };
