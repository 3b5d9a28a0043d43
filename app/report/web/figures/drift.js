// Values over time with bars of twice their standard uncertainty, one panel a unit.
KINDS.drift = (figure) => {
  const symbols = ['circle', 'square-open', 'diamond', 'triangle-up-open', 'cross', 'star-open'];
  const dashes = ['solid', 'dash', 'dot', 'dashdot', 'longdash', 'longdashdot'];
  const colours = [COLOURS.blue, COLOURS.orange, COLOURS.green, COLOURS.red, COLOURS.grey, '#5b2a86'];
  return {
    traces: figure.series.map((one, index) => ({
      type: 'scatter', mode: 'lines+markers', x: one.x, y: one.y, name: plain(one.name),
      error_y: one.bars ? {type: 'data', array: one.bars, thickness: 1.2, width: 4} : undefined,
      line: {dash: dashes[index % dashes.length], width: 1.5, color: colours[index % colours.length]},
      marker: {symbol: symbols[index % symbols.length], size: 8},
      hovertemplate: `%{x}: %{y} ${figure.unit}<extra>${plain(one.name)}</extra>`,
    })),
    layout: layout({
      showlegend: true,
      margin: {l: 60, r: 15, t: 40, b: 45},
      xaxis: axis('', {type: figure.dated ? 'date' : 'category'}),
      yaxis: axis(`${figure.quantity}, ${figure.unit}`),
    }),
  };
};
