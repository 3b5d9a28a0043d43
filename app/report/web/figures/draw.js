// Draws each figure when it comes into view, and what is left when the page is printed.
(() => {
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
    image.decoding = 'sync';
    image.src = scene.toImage('png');
    image.alt = '';
    image.className = 'on-paper';
    container.append(image);
  }

  function fail(place, error) {
    console.error(error);
    place.className = 'plot empty';
    place.style.height = '';
    place.textContent = 'This picture could not be drawn here. Its key numbers stand below.';
  }

  const waiting = new Map(); // place → what is to be drawn there
  const inSpace = [];

  // Flat figures are there when it returns, which a page that is printed needs; the promise is kept when all is drawn.
  async function draw(place) {
    const wanted = waiting.get(place);
    waiting.delete(place);
    try {
      const {traces, layout: made} = wanted.layout.scene && !hasWebGl() ? flattened(wanted) : wanted;
      place.replaceChildren();
      const drawn = Plotly.newPlot(place, traces, made, config(made));
      if (made.scene) {
        inSpace.push(place);
      }
      await drawn;
    } catch (error) {
      fail(place, error);
    }
  }

  let queue = [];
  let isDrawing = false;

  // One after the other so that the first is seen early; what is in space takes longest and comes last.
  async function drawQueue() {
    isDrawing = true;
    while (queue.length > 0) {
      const next = Math.max(0, queue.findIndex((place) => !waiting.get(place)?.layout.scene));
      const [place] = queue.splice(next, 1);
      if (waiting.has(place)) {
        await draw(place);
        await new Promise((resolve) => { setTimeout(resolve, 0); });
      }
    }
    isDrawing = false;
    const {dataset} = document.documentElement;
    dataset.drawn = waiting.size > 0 ? 'in view' : 'all';
    dataset.milliseconds ??= Math.round(performance.now()); // since the page was asked for
    inSpace.filter((place) => !place.querySelector('.on-paper')).forEach(keepForPaper);
  }

  const margin = 200; // px beyond the window
  const isInView = (place) => {
    const {top, bottom} = place.getBoundingClientRect();
    return bottom >= -margin && top <= window.innerHeight + margin;
  };

  const nearby = new IntersectionObserver((entries) => {
    const seen = entries.filter(({isIntersecting}) => isIntersecting).map(({target}) => target);
    seen.forEach((place) => nearby.unobserve(place));
    queue = [...queue, ...seen];
    if (!isDrawing) {
      drawQueue();
    }
  }, {rootMargin: `${margin}px 0px`});

  window.addEventListener('beforeprint', () => {
    [...waiting.keys()].forEach(draw);
    inSpace.forEach(keepForPaper);
  });

  for (const figure of JSON.parse(document.getElementById('data').textContent).figures) {
    const place = document.getElementById(figure.id);
    try {
      const wanted = KINDS[figure.kind](figure);
      if (wanted.height) {
        place.style.height = `${wanted.height}px`;
      }
      waiting.set(place, wanted);
    } catch (error) {
      fail(place, error);
    }
  }
  // What is in view at once is drawn without waiting for the browser's first frame.
  for (const place of waiting.keys()) {
    if (isInView(place)) {
      queue.push(place);
    } else {
      nearby.observe(place);
    }
  }
  if (queue.length > 0 || waiting.size === 0) {
    drawQueue();
  }
})();
