// Deviations in the order of the placements; neighbours differ in mark and lightness.
KINDS.placements = (figure) => {
  const traces = figure.groups.map((group, index) => {
    const inside = figure.x.map((x, i) => [x, figure.y[i]]).filter(([x]) => x >= group.begin && x < group.end);
    return dots(inside.map(([x]) => x), inside.map(([, y]) => y), {
      name: plain(group.name),
      marker: {size: 5, symbol: index % 2 ? 'diamond-open' : 'circle', color: index % 2 ? COLOURS.orange : COLOURS.blue},
      hovertemplate: `%{y} ${figure.unit}<extra>${plain(group.name)}</extra>`,
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
        ...figure.groups.slice(1).map((group) => ({
          type: 'line', yref: 'paper', y0: 0, y1: 1, x0: group.begin - 0.5, x1: group.begin - 0.5,
          line: {width: 1, color: '#d0d7de'},
        })),
      ],
    }),
  };
};
