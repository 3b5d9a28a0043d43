// Where a browser has no WebGL, what stands in space is drawn from above and from the side.
const hasWebGl = () => {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2') || canvas.getContext('webgl');
  context?.getExtension('WEBGL_lose_context')?.loseContext(); // browsers have few
  return Boolean(context);
};

function flattened({traces}) {
  const seen = (trace, fromSide) => ({
    ...trace,
    type: 'scatter',
    y: fromSide ? trace.z : trace.y,
    z: undefined,
    xaxis: fromSide ? 'x2' : 'x',
    yaxis: fromSide ? 'y2' : 'y',
    showlegend: !fromSide,
    hovertemplate: undefined,
    hoverinfo: trace.text ? 'text' : 'skip',
    line: trace.line && {...trace.line, width: trace.line.width / 2},
  });
  return {
    traces: [...traces.map((trace) => seen(trace, false)), ...traces.map((trace) => seen(trace, true))],
    layout: layout({
      showlegend: true,
      margin: {l: 60, r: 15, t: 30, b: 45},
      grid: {rows: 1, columns: 2, pattern: 'independent', xgap: 0.2},
      xaxis: axis('x, mm; from above'),
      yaxis: axis('y, mm', {scaleanchor: 'x'}),
      xaxis2: axis('x, mm; from the side'),
      yaxis2: axis('z, mm', {scaleanchor: 'x2'}),
    }),
  };
}
