// Errors over length; `band` holds the limits of a specification, `series` differ in mark.
const SYMBOLS = {does_not_conform: 'x', nothing_proven: 'diamond-open'};

KINDS.lengths = (figure) => {
  const colours = [COLOURS.blue, COLOURS.orange, COLOURS.green, COLOURS.red, COLOURS.grey];
  const bands = (figure.bands || []).flatMap((band) => [1, -1].map((side) => ({
    type: 'scatter', mode: 'lines', x: band.x, y: band.y.map((y) => side * y), name: plain(band.name),
    line: {dash: 'dash', width: 1.6, color: COLOURS.grey}, showlegend: side > 0, hoverinfo: 'skip',
  })));
  const series = figure.series.filter((one) => one.y.some((y) => y !== null)).map((one, index) => {
    const own = colours[index % colours.length];
    const judged = (one.verdicts || []).length > 0;
    const color = judged ? one.verdicts.map((verdict) => (verdict === 'does_not_conform' ? COLOURS.red : own)) : own;
    return dots(one.x, one.y, {
      name: plain(one.name),
      text: (one.names || figure.names).map(plain),
      marker: {
        size: one.x.length > 150 ? 6 : 8,
        symbol: judged ? one.verdicts.map((verdict) => SYMBOLS[verdict] || one.symbol) : one.symbol,
        color,
        line: {width: 1.4, color},
      },
      hovertemplate: `%{text}<br>%{x} mm: %{y} ${figure.unit}<extra>%{fullData.name}</extra>`,
    });
  });
  return {
    traces: [...bands, ...series],
    layout: layout({
      showlegend: true,
      margin: {l: 60, r: 15, t: 30, b: 45},
      xaxis: axis('certified length, mm'),
      yaxis: axis(`error, ${figure.unit}`),
    }),
  };
};
