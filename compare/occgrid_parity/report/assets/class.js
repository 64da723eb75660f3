// The table of a class: only the rows that match the words, in the order of a column.
"use strict";

const table = document.getElementById("submissions");
const body = table.tBodies[0];
const words = document.getElementById("words");
const onlyFailed = document.getElementById("only-failed");
const count = document.getElementById("shown");

const texts = new Map([...body.rows].map((row) => [row, row.textContent.toLowerCase()]));

function filter() {
  const wanted = words.value.toLowerCase().split(/\s+/).filter(Boolean);
  let shown = 0;
  for (const [row, text] of texts) {
    row.hidden = (onlyFailed.checked && row.className === "passed") || !wanted.every((word) => text.includes(word));
    shown += row.hidden ? 0 : 1;
  }
  count.textContent = `${shown} of ${texts.size}`;
}

const compare = new Intl.Collator("en", { numeric: true }).compare;

function sort(header) {
  const down = header.getAttribute("aria-sort") === "ascending";
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  header.setAttribute("aria-sort", down ? "descending" : "ascending");
  const column = header.cellIndex;
  const key = (row) => row.cells[column].textContent.trim();
  const rows = [...body.rows].sort((a, b) => (down ? -1 : 1) * compare(key(a), key(b)));
  body.append(...rows);
}

words.addEventListener("input", filter);
onlyFailed.addEventListener("change", filter);
for (const button of table.tHead.querySelectorAll("button")) {
  button.addEventListener("click", () => sort(button.closest("th")));
}
filter();
