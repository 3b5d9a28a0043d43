// In space: the arm, the artefacts, and errors or verdicts.
const armTrace = (arm) => ({
  type: 'scatter3d', mode: 'lines+markers', ...arm, name: 'arm',
  line: {width: 9, color: COLOURS.light}, marker: {size: 4, color: COLOURS.grey}, hoverinfo: 'skip',
});

const space = () => {
  const side = (title) => ({title: {text: title}, gridcolor: '#d0d7de', backgroundcolor: '#fff', showbackground: false, color: '#1b1f24'});
  return {
    aspectmode: 'data', xaxis: side('x, mm'), yaxis: side('y, mm'), zaxis: side('z, mm'),
    camera: {eye: {x: 1.45, y: -1.45, z: 0.75}, center: {x: 0, y: 0, z: -0.16}},
  };
};
const spaceLayout = () => layout({
  scene: space(), showlegend: true, margin: {l: 0, r: 0, t: 30, b: 0},
  legend: {orientation: 'h', x: 0, y: 1.02, yanchor: 'bottom', itemsizing: 'constant'},
});

const artefactTraces = ({lines, dots, names}, marker) => [
  {type: 'scatter3d', mode: 'lines', ...lines, name: 'artefacts', line: {width: 3, color: COLOURS.blue}, hoverinfo: 'skip'},
  {
    type: 'scatter3d', mode: 'markers', ...dots, name: 'features', text: names.map(plain), marker,
    hovertemplate: '%{text}<br>(%{x}, %{y}, %{z}) mm<extra></extra>',
  },
].filter(({x}) => x.length > 0);

KINDS.scene = (figure) => ({
  traces: [
    armTrace(figure.arm),
    ...artefactTraces(figure.artefacts, {size: 2.5, color: COLOURS.blue}),
    {
      type: 'scatter3d', mode: 'lines', ...figure.vectors, name: `errors × ${figure.magnification}`,
      line: {width: 3, color: COLOURS.red}, hoverinfo: 'skip', connectgaps: false,
    },
  ],
  layout: spaceLayout(),
});

// Marks in space are letters of a font: 'x' is one that many machines lack.
const VERDICTS = {
  conforms: {name: '✓ conformity proven', symbol: 'circle', color: COLOURS.green, size: 3},
  does_not_conform: {name: '✗ non-conformity proven', symbol: 'cross', color: COLOURS.red, size: 9},
  nothing_proven: {name: '? neither proven', symbol: 'diamond', color: COLOURS.orange, size: 4},
  not_judged: {name: 'not judged', symbol: 'circle-open', color: COLOURS.grey, size: 4},
};

KINDS.places = (figure) => ({
  traces: [
    armTrace(figure.arm),
    ...artefactTraces(figure.artefacts, {size: 5, symbol: 'square-open', color: COLOURS.blue}),
    ...figure.places.map((group) => {
      const {name, ...marker} = VERDICTS[group.verdict] || VERDICTS.not_judged;
      return {
        type: 'scatter3d', mode: 'markers', ...group.points, name, marker, text: group.names.map(plain),
        hovertemplate: '%{text}<extra></extra>',
      };
    }),
  ],
  layout: spaceLayout(),
});
