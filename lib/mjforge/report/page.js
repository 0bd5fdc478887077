// Sorting and filtering of the variants. Without this script, all variants are shown, in the page's
// order.
(function () {
  "use strict";
  const table = document.getElementById("variant-table");
  if (!table) return;
  const body = table.tBodies[0];
  const rows = Array.from(body.rows);
  const form = document.getElementById("filter");
  const text = document.getElementById("filter-text");
  const status = document.getElementById("filter-status");
  const code = document.getElementById("filter-code");
  const count = document.getElementById("filter-count");
  const words = rows.map((row) => row.textContent.toLowerCase());

  function filter() {
    const wanted = text.value.trim().toLowerCase();
    let shown = 0;
    rows.forEach((row, i) => {
      const fits = words[i].includes(wanted) &&
        (!status.value || row.dataset.status === status.value) &&
        (!code.value || row.dataset.codes.split(" ").includes(code.value));
      row.hidden = !fits;
      if (fits) ++shown;
    });
    count.textContent = shown + " of " + rows.length;
  }

  // Returns a function that compares two rows: numbers by size, words by name, missing values last.
  function compare(key, up) {
    return (a, b) => {
      const x = a.dataset[key];
      const y = b.dataset[key];
      if (x === "" || y === "") return (x === "") - (y === "");
      const order = key === "status" ? x.localeCompare(y) : Number(x) - Number(y);
      return up ? order : -order;
    };
  }

  function sort(header) {
    const up = header.getAttribute("aria-sort") !== "ascending";
    for (const other of headers) other.setAttribute("aria-sort", "none");
    header.setAttribute("aria-sort", up ? "ascending" : "descending");
    body.append(...rows.slice().sort(compare(header.dataset.key, up)));
  }

  const headers = Array.from(table.tHead.querySelectorAll("th[data-key]"));
  for (const header of headers) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = header.textContent;
    button.addEventListener("click", () => sort(header));
    header.replaceChildren(button);
    header.setAttribute("aria-sort", "none");
  }
  form.hidden = false;
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", filter);
  document.documentElement.classList.add("scripted");
  filter();
})();
