// Draws every figure of the page, one after the other so that the first is seen early.
(async () => {
  // Only what works without a network and changes nothing but the view.
  const config = (made) => ({
    displaylogo: false,
    responsive: true,
    modeBarButtons: [made.scene ? ['toImage', 'orbitRotation', 'pan3d', 'resetCameraDefault3d']
      : ['toImage', 'zoom2d', 'pan2d', 'resetScale2d']],
  });

  // What is drawn by WebGL may be gone when the page is printed: an image of it lies behind.
  function keepForPaper(place) {
    const container = place.querySelector('.gl-container');
    const scene = place._fullLayout?.scene?._scene;
    if (!container || !scene) {
      return;
    }
    container.querySelector('img')?.remove();
    const image = document.createElement('img');
    image.src = scene.toImage('png');
    image.alt = '';
    image.className = 'on-paper';
    container.append(image);
  }

  const inSpace = [];

  async function draw(figure) {
    const place = document.getElementById(figure.id);
    const wanted = KINDS[figure.kind](figure);
    const {traces, layout: made, height} = wanted.layout.scene && !hasWebGl() ? flattened(wanted) : wanted;
    if (height) {
      place.style.height = `${height}px`;
    }
    place.replaceChildren();
    await Plotly.newPlot(place, traces, made, config(made));
    if (made.scene) {
      inSpace.push(place);
      window.addEventListener('beforeprint', () => keepForPaper(place));
    }
  }

  // What is in space takes longest and comes last.
  const SLOW = ['scene', 'places'];
  const {figures} = JSON.parse(document.getElementById('data').textContent);
  const order = [...figures.filter(({kind}) => !SLOW.includes(kind)), ...figures.filter(({kind}) => SLOW.includes(kind))];
  for (const figure of order) {
    try {
      await draw(figure);
    } catch (error) {
      console.error(error);
      const place = document.getElementById(figure.id);
      place.className = 'plot empty';
      place.textContent = 'This picture could not be drawn here. Its key numbers stand below.';
    }
    await new Promise((resolve) => { setTimeout(resolve, 0); });
  }
  document.documentElement.dataset.drawn = 'all';
  document.documentElement.dataset.milliseconds = Math.round(performance.now()); // since the page was asked for
  inSpace.forEach(keepForPaper);
})();
