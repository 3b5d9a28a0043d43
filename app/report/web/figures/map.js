// A quantity over distance from axis 1 and height: a square a place, with its number where there is room.
KINDS.map = (figure) => {
  const reached = figure.values.map((_, i) => i).filter((i) => figure.values[i] !== null);
  const beyond = figure.values.map((_, i) => i).filter((i) => figure.values[i] === null);
  const pick = (list, kept) => kept.map((i) => list[i]);
  const values = pick(figure.values, reached);
  return {
    traces: [
      dots(pick(figure.x, reached), pick(figure.y, reached), {
        mode: 'markers+text',
        text: values.map((value) => value.toPrecision(3)),
        textfont: {size: 10, color: values.map((v) => (v > (Math.min(...values) + Math.max(...values)) / 2 ? '#fff' : '#1b1f24'))},
        marker: {
          symbol: 'square', size: 30, color: values, colorscale: [[0, '#eef4fb'], [1, '#0b3c78']], line: {width: 1, color: '#57606a'},
        },
        hovertemplate: `%{x} mm from axis 1, height %{y} mm: %{marker.color} ${figure.unit}<extra></extra>`,
      }),
      dots(pick(figure.x, beyond), pick(figure.y, beyond), {marker: {symbol: 'x-thin', size: 6, line: {width: 1, color: COLOURS.light}}, hoverinfo: 'skip'}),
    ],
    layout: layout({xaxis: axis('distance from axis 1, mm'), yaxis: axis('height, mm')}),
    height: 560,
  };
};
