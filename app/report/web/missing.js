// A page that takes its plots from a file beside it may have been moved away from that file.
'use strict';
if (!window.Plotly) {
  for (const place of document.querySelectorAll('.plot')) {
    place.className = 'plot empty';
    place.textContent = 'This picture needs the file plots-….js that lay in the same folder as this page. Its key numbers '
      + 'stand below. A page that carries its pictures is made with --report-pages self-contained.';
  }
}
