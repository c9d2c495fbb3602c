/**
 * In the page, before all else: notes when what a load does begins or ends, ms since the page began.
 * `window.phases` has the first time of each, by name.
 */
export function watchPhases() {
  /** @type {Record<string, number>} */
  const phases = {};
  /** @type {any} */ (window).phases = phases;
  const note = (/** @type {string} */ name) => void (phases[name] ??= performance.now());
  /** @type {any} */ (window).notePhase = note;
  /**
   * @param {any} prototype
   * @param {string} method
   * @param {(before: number, self: any) => void} after
   */
  const follow = (prototype, method, after) => {
    const original = prototype[method];
    prototype[method] = function (/** @type {unknown[]} */ ...args) {
      const before = performance.now();
      const result = original.apply(this, args);
      after(before, this);
      return result;
    };
  };
  // A canvas in the page is a scene's; one outside asks what the device can do.
  follow(HTMLCanvasElement.prototype, 'getContext', (_before, canvas) => {
    queueMicrotask(
      () => canvas.getRootNode() !== canvas && canvas.getRootNode() instanceof ShadowRoot && note('scene'),
    );
  });
  for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext]) {
    follow(prototype, 'linkProgram', () => note('linked'));
    follow(prototype, 'readPixels', (before) => (phases.probing ??= before));
  }
  const NativeWorker = Worker;
  window.Worker = class extends NativeWorker {
    /** @param {ConstructorParameters<typeof Worker>} args */
    constructor(...args) {
      super(...args);
      note('worker');
      this.addEventListener('message', ({ data }) => note(`worker ${data.type}`));
    }
  };
}

/**
 * In the page: put the script in, and then an element, and wait for its picture.
 * @param {{ attributes: Record<string, string>, pixels: number }} what
 * @returns {Promise<Record<string, number>>} ms since the script was put in, by phase
 */
export async function loadByPhases({ attributes, pixels }) {
  const { phases, notePhase } = /** @type {any} */ (window);
  const began = performance.now();
  const script = Object.assign(document.createElement('script'), { type: 'module', src: '/dist/volume-view.js' });
  document.head.append(script);
  const element = document.createElement('volume-view');
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.style.cssText = `display: block; width: ${pixels}px; height: ${pixels}px; max-height: none; aspect-ratio: auto`;
  element.addEventListener('progress', ({ detail: { phase } }) => notePhase(phase));
  element.addEventListener('load', () => notePhase('load'));
  element.addEventListener('render', ({ detail: { converged } }) => notePhase(converged ? 'final' : 'first'));
  document.body.append(element);
  await customElements.whenDefined('volume-view');
  notePhase('script');
  await element.whenRendered();
  const x3dom = performance.getEntriesByType('resource').find(({ name }) => name.endsWith('/x3dom.js'));
  if (x3dom) phases.x3dom = x3dom.startTime + x3dom.duration;
  return Object.fromEntries(Object.entries(phases).map(([name, time]) => [name, time - began]));
}
