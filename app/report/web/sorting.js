// Tables of class "sortable": a click on a column's head sorts by it, another turns the order round.
'use strict';
(() => {
  const numberIn = (text) => (text.trim() === '' ? NaN : Number(text));

  // Empty cells stay last whichever way the others go.
  function compare(a, b, direction) {
    const [left, right] = [a.textContent.trim(), b.textContent.trim()];
    if (left === '' || right === '') {
      return (left === '') - (right === '');
    }
    const [m, n] = [numberIn(left), numberIn(right)];
    const order = Number.isNaN(m) || Number.isNaN(n) ? left.localeCompare(right, 'en', {numeric: true}) : m - n;
    return direction * order;
  }

  function sortBy(table, column, head) {
    const descends = head.getAttribute('aria-sort') === 'ascending';
    for (const other of table.tHead.rows[0].cells) {
      other.removeAttribute('aria-sort');
    }
    head.setAttribute('aria-sort', descends ? 'descending' : 'ascending');
    const [body] = table.tBodies;
    const rows = Array.from(body.rows);
    rows.sort((a, b) => compare(a.cells[column], b.cells[column], descends ? -1 : 1));
    body.append(...rows);
  }

  for (const table of document.querySelectorAll('table.sortable')) {
    Array.from(table.tHead.rows[0].cells).forEach((head, column) => {
      const button = document.createElement('button');
      button.textContent = head.textContent;
      button.addEventListener('click', () => sortBy(table, column, head));
      head.replaceChildren(button);
    });
  }
})();
