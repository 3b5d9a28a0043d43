// One panel a joint.
KINDS.joints = (figure) => {
  const columns = 2;
  const rows = Math.ceil(figure.panels.length / columns);
  const made = layout({grid: {rows, columns, pattern: 'independent', xgap: 0.16, ygap: 0.34}, margin: {l: 60, r: 15, t: 8, b: 45}});
  const traces = figure.panels.map((panel, index) => {
    const suffix = index === 0 ? '' : String(index + 1);
    made[`xaxis${suffix}`] = axis(`q${index + 1}, °`, {automargin: false, title: {text: `q${index + 1}, °`, standoff: 2}});
    made[`yaxis${suffix}`] = axis(index % columns === 0 ? figure.unit : '', {automargin: false});
    return dots(panel.x, panel.y, {
      xaxis: `x${suffix}`, yaxis: `y${suffix}`, marker: {size: 3.5, color: COLOURS.blue},
      hovertemplate: `%{x}°: %{y} ${figure.unit}<extra></extra>`,
    });
  });
  return {traces, layout: made, height: 60 + 150 * rows};
};
