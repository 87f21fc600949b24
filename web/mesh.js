import { el } from "./dom.js";
export default { id: "mesh", title: "Mesh", mount(place) { place.append(el("p", {}, "to come")); return {}; } };
