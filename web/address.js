// The state of the page, in its address: `#ROOM?name=value&…`.

const MAX_LENGTH = 60_000;

/** The room and its values. */
export function read() {
  const [room, query = ""] = location.hash.slice(1).split("?", 2);
  return { room, values: Object.fromEntries(new URLSearchParams(query)) };
}

/** Replaces the address, without a new entry in the history. */
export function write(room, values) {
  const kept = Object.entries(values).filter(([, value]) => value !== "" && value !== null && value !== undefined);
  const query = new URLSearchParams(kept).toString();
  const address = query && query.length <= MAX_LENGTH ? `#${room}?${query}` : `#${room}`;
  if (address !== location.hash) history.replaceState(null, "", address);
}
