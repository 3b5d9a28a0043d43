// What all figures share. The figures' files are one script, in the order that web_files.cmake names.
'use strict';

// Told apart by shape and lightness too, not by hue alone (Okabe and Ito's colours).
const COLOURS = {blue: '#0b4f9c', orange: '#c45500', green: '#1a6b34', red: '#a4161a', grey: '#57606a', light: '#9aa4ae'};

// Plotly reads some markup in its texts; names from files are text.
const plain = (text) => String(text).replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');

const axis = (title, more = {}) => ({
  title: {text: plain(title), standoff: 8},
  automargin: true,
  showline: true,
  linecolor: '#1b1f24',
  gridcolor: '#e6e9ec',
  zerolinecolor: '#8a939c',
  ticks: 'outside',
  ...more,
});

const layout = (more = {}) => ({
  font: {family: '"DejaVu Sans", "Liberation Sans", Arial, sans-serif', size: 12, color: '#1b1f24'},
  margin: {l: 60, r: 15, t: 15, b: 45},
  paper_bgcolor: '#fff',
  plot_bgcolor: '#fff',
  hovermode: 'closest',
  showlegend: false,
  legend: {orientation: 'h', x: 0, y: 1.02, yanchor: 'bottom'},
  ...more,
});

const dots = (x, y, more = {}) => ({type: 'scatter', mode: 'markers', x, y, ...more});
const horizontal = (y, dash, colour) => ({
  type: 'line', xref: 'paper', x0: 0, x1: 1, y0: y, y1: y, line: {dash, width: 1.2, color: colour},
});

// Each kind of figure: data of the page → {traces, layout}.
const KINDS = {};
