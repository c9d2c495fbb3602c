// The script of a widget in the page of a notebook. The element is in a page of one file, which Python sends once; its scripts become those
// of this page.

/** @typedef {{ get(name: string): any, set(name: string, value: any): void, save_changes(): void, on(event: string, listener: any): void, off(event: string, listener: any): void, send(content: any): void }} Model */

/** Milliseconds after which a page asks another widget's Python. */
const patience = 60_000;

/** @type {Promise<void> | null} */
let element = null;

/** @param {Model} model */
function askForPlayer(model) {
  return new Promise((resolve, reject) => {
    /** @param {any} content @param {DataView[]} buffers */
    const listen = (content, buffers) => {
      if (!content?.player) return;
      model.off('msg:custom', listen);
      resolve(new TextDecoder().decode(buffers[0]));
    };
    model.on('msg:custom', listen);
    setTimeout(() => reject(new Error('Python does not answer: run the cell again')), patience);
    model.send({ ask: 'player' });
  });
}

/** Defines the element once a page. @param {Model} model */
async function loadElement(model) {
  if (customElements.get('volume-view')) return;
  const page = new DOMParser().parseFromString(await askForPlayer(model), 'text/html');
  for (const text of page.querySelectorAll('script[type="text/plain"]'))
    document.head.append(document.importNode(text, true));
  for (const { textContent } of page.querySelectorAll('script[nonce]')) {
    const script = document.createElement('script');
    script.textContent = textContent;
    document.head.append(script);
    script.remove();
  }
  await customElements.whenDefined('volume-view');
}

/** What JSON can hold: no-data values are null. @param {unknown} value */
const plain = (value) => JSON.parse(JSON.stringify(value ?? null));

/** @param {{ model: Model, el: HTMLElement }} widget */
async function render({ model, el }) {
  const box = document.createElement('div');
  box.style.cssText = 'width: 100%; min-height: 20em';
  el.append(box);
  try {
    await (element ??= loadElement(model));
  } catch (error) {
    element = null;
    box.textContent = error instanceof Error ? error.message : String(error);
    return;
  }
  /** @type {any} */
  const view = document.createElement('volume-view');
  view.loading = 'eager';
  view.style.cssText = 'width: 100%; height: 400px';
  const names = /** @type {Record<string, string>} */ (model.get('_attributes_of'));
  /** @param {string} name */
  const write = (name) => {
    const value = model.get(name);
    if (value === null || value === undefined || value === false) view.removeAttribute(names[name]);
    else view.setAttribute(names[name], value === true ? '' : value);
  };
  /** @param {string} name @param {unknown} value */
  const report = (name, value) => {
    model.set(name, value);
    model.save_changes();
  };
  const size = () => {
    for (const side of ['width', 'height']) {
      const value = model.get(side);
      if (value) view.style[side] = /^\d+(\.\d+)?$/.test(value) ? `${value}px` : value;
    }
  };
  for (const name of Object.keys(names)) write(name);
  if (model.get('alt') === null) view.setAttribute('alt', 'A volume');
  size();
  const open = () => {
    /** @type {DataView} */
    const file = model.get('_file');
    view.files = file.byteLength > 0 ? [new File([file], model.get('_name'))] : null;
  };
  open();
  let timer = 0;
  const takePicture = async () => {
    await view.whenRendered();
    const picture = await view.toBlob();
    report('picture', new DataView(await picture.arrayBuffer()));
  };
  view.addEventListener('load', () => {
    const { format = null, unit = '', left = [], dimensions = null, spacing = null } = view.volume ?? {};
    report('error', null);
    report('volume', plain({ format, unit, left, dimensions, spacing }));
    takePicture().catch(() => undefined); // A still picture is nice to have.
  });
  view.addEventListener('error', (/** @type {CustomEvent} */ { detail }) =>
    report('error', detail?.message ?? 'error'),
  );
  view.addEventListener('volume-pick', (/** @type {CustomEvent} */ { detail }) => report('pick', plain(detail)));
  view.addEventListener('camera-change', () => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      const seen = view.getView();
      report(
        'camera',
        plain({
          camera_orbit: seen['camera-orbit'],
          camera_target: seen['camera-target'],
          field_of_view: seen['field-of-view'],
        }),
      );
    }, 100);
  });
  const listeners = Object.keys(names).map(
    (name) => /** @type {const} */ ([`change:${name}`, () => (write(name), size())]),
  );
  for (const [event, listener] of [...listeners, /** @type {const} */ (['change:_file', open])])
    model.on(event, listener);
  box.append(view);
  return () => {
    clearTimeout(timer);
    for (const [event, listener] of [...listeners, /** @type {const} */ (['change:_file', open])])
      model.off(event, listener);
    view.remove();
  };
}

export default { render };
