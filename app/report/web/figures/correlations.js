// The lower triangle; size is |r|, shape and colour its sign.
KINDS.correlations = (figure) => {
  const count = figure.names.length;
  const room = 520 / Math.max(count, 8);
  const side = (positive) => {
    const kept = figure.values.map((_, i) => i).filter((i) => (figure.values[i] >= 0) === positive);
    return dots(kept.map((i) => figure.x[i]), kept.map((i) => figure.y[i]), {
      name: positive ? 'positive' : 'negative',
      text: kept.map((i) => `${plain(figure.names[figure.y[i]])}, ${plain(figure.names[figure.x[i]])}: ${figure.values[i]}`),
      marker: {
        symbol: positive ? 'square' : 'circle-open',
        color: positive ? COLOURS.blue : COLOURS.red,
        opacity: 1,
        size: kept.map((i) => Math.max(1.5, room * 0.85 * Math.sqrt(Math.abs(figure.values[i])))),
        line: {width: positive ? 0 : 1.6},
      },
      hovertemplate: '%{text}<extra></extra>',
    });
  };
  const names = {tickvals: figure.names.map((_, i) => i), ticktext: figure.names.map(plain), showgrid: true, zeroline: false};
  return {
    traces: [side(true), side(false)],
    layout: layout({
      showlegend: true,
      margin: {l: 60, r: 15, t: 30, b: 45},
      xaxis: axis('', {...names, range: [-0.7, count - 0.3], tickangle: -90}),
      yaxis: axis('', {...names, range: [count - 0.3, -0.7]}),
    }),
    height: 620,
  };
};
