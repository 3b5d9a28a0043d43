// Deviations in the order of the placements; neighbours differ in mark and lightness.
KINDS.placements = (figure) => {
  // Two traces, however many placements there are: each costs time to draw.
  const traces = [0, 1].map((odd) => {
    const inside = figure.groups.flatMap((group, index) => (index % 2 === odd
      ? figure.x.flatMap((x, i) => (x >= group.begin && x < group.end ? [[x, figure.y[i], plain(group.name)]] : [])) : []));
    return dots(inside.map(([x]) => x), inside.map(([, y]) => y), {
      text: inside.map(([, , name]) => name),
      marker: {size: 5, symbol: odd ? 'diamond-open' : 'circle', color: odd ? COLOURS.orange : COLOURS.blue},
      hovertemplate: `%{y} ${figure.unit}<extra>%{text}</extra>`,
    });
  });
  const sparse = Math.ceil(figure.groups.length / 24); // names that fit below the axis
  const named = figure.groups.filter((_, index) => index % sparse === 0);
  return {
    traces,
    layout: layout({
      xaxis: axis('placement', {
        tickvals: named.map((group) => (group.begin + group.end - 1) / 2),
        ticktext: named.map((group) => plain(group.name.length > 18 ? `${group.name.slice(0, 17)}…` : group.name)),
        showgrid: false,
        zeroline: false,
      }),
      yaxis: axis(`deviation, ${figure.unit}`),
      shapes: [
        ...[figure.rms, -figure.rms].filter((y) => y > 0 || figure.y.some((value) => value < 0))
          .map((y) => horizontal(y, 'dot', COLOURS.grey)),
        ...(figure.groups.length < 2 ? [] : [{
          type: 'path', yref: 'paper', line: {width: 1, color: '#d0d7de'}, layer: 'below',
          path: figure.groups.slice(1).map((group) => `M ${group.begin - 0.5},0 V 1`).join(' '),
        }]),
      ],
    }),
  };
};
