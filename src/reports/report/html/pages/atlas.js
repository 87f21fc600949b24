// The index works without this: it adds a field to search, and buttons to sort by a column.
(() => {
  const table = document.querySelector("table.atlas"), body = table.tBodies[0], rows = [...body.rows];
  const status = document.createElement("p"), label = document.createElement("label"), field = document.createElement("input");
  field.type = "search";
  field.id = "page:search";
  label.append("Search ", field);
  label.className = "search";
  status.setAttribute("role", "status");
  status.className = "note";
  const search = () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const row of rows) row.hidden = !words.every(word => row.dataset.words.includes(word));
    const shown = rows.filter(row => !row.hidden).length;
    status.textContent = `${shown} of ${rows.length} schemes`;
  };
  field.addEventListener("input", search);
  table.closest(".scroll").before(label, status);
  [...table.tHead.rows[0].cells].forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const down = head.getAttribute("aria-sort") === "ascending";
      for (const other of head.parentElement.cells) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      const key = row => row.cells[column].dataset.key;
      const order = (one, other) => {
        const [x, y] = [key(one), key(other)];
        // What is open or has no meaning comes last in both directions.
        if (x === "" || y === "") return (x === "") - (y === "");
        const sign = isNaN(x) || isNaN(y) ? x.localeCompare(y) : x - y;
        return down ? -sign : sign;
      };
      body.append(...rows.sort(order));
    });
  });
  search();
})();
