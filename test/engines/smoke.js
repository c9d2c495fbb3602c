// The built package in an engine: load, right picture, orbit, remove and re-insert; then the same in WebGL 1, in a frame.
import {
  ball,
  comparePictures,
  decodePicture,
  drawReference,
  orbitCamera,
  plainAttributes,
  plainOrbit,
} from '../../node_modules/.cache/volume-view/engines/reference.js';

const isWebGl1 = location.search === '?webgl1';
const prefix = isWebGl1 ? 'WebGL 1: ' : '';
const data = '/test/e2e/pages/data';
// The frame adds to the page's own lists.
const { passed, failed } = isWebGl1
  ? window.parent.__smoke
  : (window.__smoke = { done: false, passed: [], failed: [] });

/** Run one check, which throws the reason where it fails. */
async function check(name, act) {
  try {
    await act();
    passed.push(prefix + name);
  } catch (error) {
    failed.push(`${prefix}${name}: ${error?.message ?? error}`);
  }
}

function expect(condition, reason) {
  if (!condition) throw new Error(reason);
}

function makeElement(attributes) {
  const element = document.createElement('volume-view');
  for (const [name, value] of Object.entries({ ...plainAttributes, ...attributes })) element.setAttribute(name, value);
  return element;
}

const nextEvent = (element, type) =>
  new Promise((resolve) => void element.addEventListener(type, ({ detail }) => resolve(detail), { once: true }));

const contextOf = (element) => element.shadowRoot.querySelector('canvas').getContext(isWebGl1 ? 'webgl' : 'webgl2');

/** The pixels on the canvas, as the GPU left them. */
async function readPicture(element) {
  await element.whenRendered();
  // Of more elements than have a context at once, some show a snapshot by now.
  for (let i = 0; i < 50 && !contextOf(element); i++) {
    element.scrollIntoView();
    await new Promise(requestAnimationFrame);
    await element.redraw();
  }
  const gl = contextOf(element);
  const { width, height } = gl.canvas;
  const upsideDown = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, upsideDown);
  const data = new Float64Array(upsideDown.length);
  for (let row = 0; row < height; row++) {
    data.set(upsideDown.subarray((height - 1 - row) * width * 4, (height - row) * width * 4), row * width * 4);
  }
  return { width, height, data };
}

/** The issue's own bounds: 2/255 at any pixel, 0.5/255 RMSE. */
async function expectPicture(element, view) {
  expectSame(await readPicture(element), view);
}

function expectSame(got, view) {
  const expected = drawReference(view);
  expect(got.width === expected.width && got.height === expected.height, `${got.width} x ${got.height} pixels`);
  const { worst, rmse } = comparePictures(got, expected);
  expect(
    expected.data.some((x, i) => i % 4 < 3 && x > 80),
    'the reference shows nothing',
  );
  expect(worst <= 2 && rmse <= 0.5, `worst pixel ${worst.toFixed(2)}, RMSE ${rmse.toFixed(2)} of 255`);
}

/** Press a key; resolves with the orbit once the camera has come to rest. */
async function pressKey(element, key) {
  let orbit = null;
  const listen = ({ detail }) => (orbit = detail.orbit);
  element.addEventListener('camera-change', listen);
  const moved = nextEvent(element, 'camera-change');
  element.shadowRoot.querySelector('.picture').dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
  await moved;
  await element.whenRendered();
  element.removeEventListener('camera-change', listen);
  return orbit;
}

const cameraOf = (orbit) => orbitCamera(orbit, [0, 0, 0], (32 * Math.PI) / 180);

await customElements.whenDefined('volume-view');
const element = makeElement({ src: `${data}/field.nii.gz`, alt: 'A smooth field' });

await check('it loads', async () => {
  const loaded = nextEvent(element, 'load');
  const failure = nextEvent(element, 'error').then(({ code, message }) =>
    Promise.reject(new Error(`${code}: ${message}`)),
  );
  document.body.append(element);
  const { dimensions, format } = await Promise.race([loaded, failure]);
  expect(dimensions.join() === '24,20,16' && format.startsWith('NIfTI'), `${format} of ${dimensions}`);
});

await check("the picture is the reference's", () => expectPicture(element));

await check('rays that the processor casts in 64 bits are the same', async () => {
  const { rays, off, max, agrees } = await element.checkPicture();
  expect(
    rays >= 20 && agrees && off === 0 && max <= 1,
    `${off} of ${rays} rays off, by up to ${max.toFixed(2)} of 255`,
  );
});

await check('it draws by the version of WebGL that was asked for', () => {
  const isWebGl2 = element.shadowRoot.querySelector('canvas').getContext('webgl2') !== null;
  expect(isWebGl2 === !isWebGl1, `WebGL ${isWebGl2 ? 2 : 1}`);
});

await check('keys orbit', async () => {
  const left = await pressKey(element, 'ArrowLeft');
  expect(left.theta > plainOrbit.theta + 0.05, `theta went from ${plainOrbit.theta} to ${left.theta}`);
  await expectPicture(element, { camera: cameraOf(left) });
  const near = await pressKey(element, '+');
  expect(near.radius < plainOrbit.radius * 0.95, `radius went from ${plainOrbit.radius} to ${near.radius}`);
  await expectPicture(element, { camera: cameraOf(near) });
  await pressKey(element, '0');
  await expectPicture(element);
});

/** Events as a hand makes them; the engines' protocols have none for fingers. */
function point(type, [x, y], options = {}) {
  const { left, top } = element.getBoundingClientRect();
  const picture = element.shadowRoot.querySelector('.picture');
  picture.setPointerCapture = () => {}; // There is no such pointer.
  picture.dispatchEvent(
    new PointerEvent(type, {
      pointerId: 7,
      pointerType: 'touch',
      clientX: left + x,
      clientY: top + y,
      bubbles: true,
      cancelable: true,
      ...options,
    }),
  );
}

await check('a click picks the place under it, and a readout says so', async () => {
  const readout = document.createElement('volume-readout');
  element.after(readout);
  for (let i = 0; i < 200 && !readout.shadowRoot?.querySelector('[part=row]'); i++)
    await new Promise((resolve) => void setTimeout(resolve, 25));
  const picked = nextEvent(element, 'volume-pick');
  const { left, top } = element.getBoundingClientRect();
  point('pointerdown', [60, 45], { pointerType: 'mouse', isPrimary: true, composed: true });
  point('pointerup', [60, 45], { pointerType: 'mouse', isPrimary: true, composed: true });
  element.shadowRoot
    .querySelector('.picture')
    .dispatchEvent(new MouseEvent('click', { clientX: left + 60, clientY: top + 45, bubbles: true, composed: true }));
  const detail = await picked;
  const again = await element.pick(60, 45);
  expect(
    Number.isFinite(detail?.value) && JSON.stringify(detail) === JSON.stringify(again),
    JSON.stringify([detail, again]),
  );
  const words = () => readout.shadowRoot.querySelector('[part=row]').textContent.replace(/\s+/g, ' ');
  for (let i = 0; i < 100 && words().includes('\u2013'); i++)
    await new Promise((resolve) => void setTimeout(resolve, 25));
  expect(/^Value ?\d/.test(words()), words());
  readout.remove();
});

await check("a click picks the same place in an author's shadow root that CSS turns and scales", async () => {
  const before = await element.pick(60, 45);
  const [parent, next, style] = [element.parentNode, element.nextSibling, element.style.cssText];
  const [cos, sin] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
  // The page shows the picture's place (60, 45) at whole pixels: engines cut the fractions of a click off.
  const at = { clientX: 134, clientY: 124, bubbles: true, composed: true };
  const [left, top] = [at.clientX - 1.5 * (60 * cos - 45 * sin), at.clientY - 1.5 * (60 * sin + 45 * cos)];
  const host = document.createElement('div');
  host.style.cssText = `position: fixed; left: 0; top: 0; transform-origin: 0 0; transform: translate(${left}px, ${top}px) rotate(30deg) scale(1.5)`;
  document.body.append(host);
  // The style sheet of the page does not reach into a shadow root: without this, the element has its own size there.
  element.style.cssText = 'width: 120px; height: 90px';
  host.attachShadow({ mode: 'open' }).append(element);
  try {
    await element.whenRendered();
    expect(
      element.clientWidth === 120 && element.clientHeight === 90,
      `${element.clientWidth} x ${element.clientHeight}`,
    );
    const mouse = { ...at, pointerId: 1, pointerType: 'mouse', isPrimary: true };
    const picture = element.shadowRoot.querySelector('.picture');
    picture.setPointerCapture = () => {}; // There is no such pointer.
    const picks = [];
    void nextEvent(element, 'volume-pick').then((detail) => picks.push(detail));
    element.pickable = true;
    // The code that picks has to load first.
    for (let i = 0; i < 100 && picks.length === 0; i++) {
      picture.dispatchEvent(new PointerEvent('pointerdown', mouse));
      picture.dispatchEvent(new PointerEvent('pointerup', mouse));
      picture.dispatchEvent(new MouseEvent('click', at));
      await new Promise((resolve) => void setTimeout(resolve, 50));
    }
    expect(picks[0], picks.length > 0 ? 'a click has found nothing' : 'no click has picked');
    const [{ world }] = picks;
    const off = Math.max(...world.map((x, i) => Math.abs(x - before.world[i])));
    expect(off < 0.05, `${JSON.stringify(world)}, and not ${JSON.stringify(before.world)}`);
  } finally {
    element.pickable = false;
    element.style.cssText = style;
    parent.insertBefore(element, next);
    host.remove();
    await element.whenRendered();
  }
});

/** Wait up to 10 s. @returns whether the condition came true */
async function until(condition) {
  for (let i = 0; i < 400 && !condition(); i++) await new Promise((resolve) => void setTimeout(resolve, 25));
  return Boolean(condition());
}

await check('a note stands where a pick finds its place, opens, and goes', async () => {
  const { world } = await element.pick(60, 45);
  const note = document.createElement('volume-note');
  for (const [name, value] of Object.entries({ position: world.join(' '), label: 'There', hide: 'never' }))
    note.setAttribute(name, value);
  note.append(Object.assign(document.createElement('p'), { textContent: 'What it says' }));
  element.append(note);
  const find = (selector) => element.shadowRoot.querySelector(selector);
  await until(() => find('.pin:not(.out)'));
  expect(find('.pin:not(.out)'), 'it has no pin');
  const [pin, box] = [find('.pin'), element].map((one) => one.getBoundingClientRect());
  const off = Math.hypot(pin.x + pin.width / 2 - box.x - 60, pin.y + pin.height / 2 - box.y - 45);
  expect(off < 1, `its pin is ${off.toFixed(2)} pixels off`);
  find('button.note').click();
  const text = () => note.firstElementChild.getBoundingClientRect().height;
  await until(() => text() > 0);
  expect(note.open && text() > 0, 'its text does not open');
  note.remove();
  await until(() => !find('.notes'));
  expect(!find('.notes'), 'it leaves something');
});

/** A click of a mouse on the picture, CSS pixels from its left and top edge. */
function clickOn(view, [x, y]) {
  const { left, top } = view.getBoundingClientRect();
  const at = { clientX: left + x, clientY: top + y, bubbles: true, composed: true };
  const picture = view.shadowRoot.querySelector('.picture');
  picture.setPointerCapture = () => {}; // There is no such pointer.
  const mouse = { ...at, pointerId: 1, pointerType: 'mouse', isPrimary: true };
  picture.dispatchEvent(new PointerEvent('pointerdown', mouse));
  picture.dispatchEvent(new PointerEvent('pointerup', mouse));
  picture.dispatchEvent(new MouseEvent('click', at));
}

await check('authors get the tag of a note at the place that they click, and it stands there', async () => {
  const inside = (selector) => element.shadowRoot.querySelector(selector);
  element.toggleAttribute('authoring', true);
  expect(await until(() => inside('.authoring')), 'no panel came');
  clickOn(element, [60, 45]);
  expect(await until(() => inside('.authoring textarea')), 'a click gives no tag');
  const field = inside('.authoring input');
  field.value = 'A "name" & <b>';
  field.dispatchEvent(new Event('input', { bubbles: true }));
  await element.updateComplete;
  const [note, ...others] = new DOMParser()
    .parseFromString(inside('.authoring textarea').value, 'text/html')
    .body.querySelectorAll('*');
  expect(note.localName === 'volume-note' && others.length === 0, inside('.authoring textarea').value);
  expect(note.getAttribute('label') === field.value, `its name is ${note.getAttribute('label')}`);
  const { left, top } = element.getBoundingClientRect();
  const { position } = await element.positionFromPoint(left + 60, top + 45);
  const off = Math.max(
    ...note
      .getAttribute('position')
      .split(' ')
      .map((x, i) => Math.abs(x - position[i])),
  );
  expect(off < 0.06, `${note.getAttribute('position')}, and not ${position}`);
  expect(await until(() => inside('.pin:not(.out)')), 'its preview has no pin');
  element.toggleAttribute('authoring', false);
  expect(await until(() => !inside('.authoring') && !inside('.aim') && !inside('.pin')), 'it leaves something');
});

/** A question about the element, in the page. */
function ask(attributes, html) {
  const question = document.createElement('volume-question');
  element.id = 'asked';
  for (const [name, value] of Object.entries({ for: 'asked', ...attributes })) question.setAttribute(name, value);
  question.innerHTML = html;
  element.after(question);
  return question;
}

await check('a question takes a place that is clicked, and one that keys choose', async () => {
  const { left, top } = element.getBoundingClientRect();
  const { position } = await element.positionFromPoint(left + 60, top + 45);
  const question = ask({ type: 'find', position: position.join(' '), radius: '0.5' }, '<p>Where?</p>');
  try {
    const button = () => question.shadowRoot?.querySelector('.aiming');
    expect(await until(button), 'it has no button');
    // The code that picks has to load first.
    expect(
      await until(() => {
        if (!question.result) clickOn(element, [90, 45]);
        return question.result;
      }),
      'a click is no answer',
    );
    expect(!question.result.correct, 'a wrong place is right');
    await until(() => element.shadowRoot.querySelector('.pin:not(.out)'));
    button().click();
    const crosshair = element.shadowRoot.querySelector('.aim [role=application]');
    expect(crosshair && element.shadowRoot.activeElement === crosshair, 'the crosshair has no focus');
    crosshair.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true }));
    expect(await until(() => question.done), 'Enter is no answer');
    expect(question.result.correct, `the middle is wrong: ${question.result.response}`);
  } finally {
    question.remove();
  }
  expect(await until(() => !element.shadowRoot.querySelector('.pin, .aim')), 'it leaves something');
});

await check('a question takes a choice, and says so', async () => {
  const question = ask({}, '<p>Which?</p><ul><li>This</li><li correct>That <em>one</em></li></ul>');
  try {
    const inputs = () => question.shadowRoot?.querySelectorAll('input') ?? [];
    expect(await until(() => inputs().length === 2), `${inputs().length} answers`);
    inputs()[1].click();
    question.shadowRoot.querySelector('form button').click();
    expect(await until(() => question.done), 'it is not answered');
    const { response, correct } = question.result;
    expect(correct && response === 'That one', `${response}: ${correct}`);
    expect(await until(() => question.shadowRoot.querySelector('[part=feedback]')), 'it says nothing');
  } finally {
    question.remove();
  }
});

await check('two views that are compared have one camera, and keys move what divides them', async () => {
  const compare = document.createElement('volume-compare');
  compare.setAttribute('layout', 'slider');
  const views = ['field.nii.gz', 'ball.nii'].map((name) => makeElement({ src: `${data}/${name}`, alt: name }));
  compare.append(...views);
  compare.style.cssText = 'width: 120px';
  document.body.append(compare);
  try {
    for (const view of views) await view.whenRendered();
    const divider = () => compare.shadowRoot?.querySelector('[role=slider]');
    expect(await until(divider), 'nothing divides them');
    divider().dispatchEvent(new KeyboardEvent('keydown', { key: 'End', bubbles: true, composed: true }));
    expect(
      await until(() => divider().getAttribute('aria-valuenow') === '100'),
      `it is at ${divider().getAttribute('aria-valuenow')}`,
    );
    await pressKey(views[0], 'ArrowRight');
    const eyes = () => views.map(({ camera }) => camera.eye.map((x) => x.toFixed(3)).join(' '));
    expect(await until(() => eyes()[0] === eyes()[1]), eyes().join(', and '));
  } finally {
    compare.remove();
  }
});

await check('a drag with Shift moves what is seen, and a pinch on a trackpad zooms to the pointer', async () => {
  point('pointerdown', [60, 45], { pointerType: 'mouse', shiftKey: true });
  point('pointermove', [70, 45], { pointerType: 'mouse', shiftKey: true, buttons: 1 });
  point('pointerup', [70, 45], { pointerType: 'mouse' });
  await element.whenRendered();
  const moved = Math.hypot(...element.camera.target);
  expect(moved > 1 && element.camera.orbit.theta === plainOrbit.theta, `the target is ${moved} away`);
  const wheel = { deltaY: -10, ctrlKey: true, bubbles: true, cancelable: true };
  element.shadowRoot.querySelector('.picture').dispatchEvent(new WheelEvent('wheel', wheel));
  await element.whenRendered();
  const factor = element.camera.orbit.radius / plainOrbit.radius;
  expect(Math.abs(factor - Math.exp(-0.1)) < 1e-6, `the distance is ${factor} times what it was`);
  await pressKey(element, '0');
});

await check('a finger whose page scrolls leaves the camera as it was', async () => {
  point('pointerdown', [60, 45]);
  for (let i = 1; i < 6; i++) point('pointermove', [60 + 4 * i, 45 - 12 * i], { buttons: 1 });
  point('pointercancel', [80, 0]);
  await element.whenRendered();
  const orbit = element.getView()['camera-orbit'];
  expect(orbit === undefined, `the camera went to ${orbit}`); // getView() gives what differs from the tag.
});

await check('two fingers that pinch zoom, and bring back', async () => {
  const fingers = [7, 8].map((pointerId) => ({ pointerId, isPrimary: pointerId === 7 }));
  const spread = (type, half) =>
    fingers.forEach((finger, i) =>
      point(type, [60 + (i ? half : -half), 45], { ...finger, buttons: type === 'pointerup' ? 0 : 1 }),
    );
  spread('pointerdown', 10);
  for (const half of [12, 16, 20]) spread('pointermove', half);
  spread('pointerup', 20);
  await element.whenRendered();
  const factor = element.camera.orbit.radius / plainOrbit.radius;
  expect(Math.abs(factor - 0.5) < 0.02, `fingers twice as far apart made the distance ${factor} times what it was`);
  await pressKey(element, '0');
  await expectPicture(element);
});

await check('controls are loaded when they are asked for, turn the picture, and go', async () => {
  const inside = (selector) => element.shadowRoot.querySelector(selector);
  const controls = () => inside('.controls');
  element.toggleAttribute('controls', true);
  await until(controls);
  expect(controls(), 'no controls came');
  // A narrow picture leaves some of them out.
  const shown = [...controls().querySelectorAll('button')]
    .map((one) => one.getBoundingClientRect())
    .filter(({ width }) => width > 0);
  const small = shown.filter(({ width, height }) => Math.min(width, height) < 44);
  expect(shown.length >= 3, `${shown.length} buttons are shown`);
  expect(small.length === 0, `${small.length} of them are smaller than 44 pixels`);
  inside('[data-action=views]').click();
  await element.updateComplete;
  const moved = nextEvent(element, 'camera-change');
  inside('.views button:nth-child(3)').click(); // The left.
  await moved;
  await element.whenRendered();
  expect(Math.abs(element.camera.orbit.theta - Math.PI / 2) < 1e-6, `theta is ${element.camera.orbit.theta}`);
  element.toggleAttribute('controls', false);
  await until(() => !controls());
  expect(!controls(), 'they are still there');
  await pressKey(element, '0');
  await expectPicture(element);
});

await check('in a flex row a bare tag has a size of its own', () => {
  const row = document.createElement('div');
  row.style.display = 'flex';
  const bare = document.createElement('volume-view');
  bare.style.cssText = 'width: auto; height: auto'; // The page's own says otherwise.
  row.append(bare);
  document.body.append(row);
  const { width, height } = bare.getBoundingClientRect();
  row.remove();
  expect(width === 300 && height === 225, `${width} x ${height}`);
});

await check('taken out and put back it shows the same', async () => {
  const before = await readPicture(element);
  for (let i = 0; i < 3; i++) {
    element.remove();
    await new Promise(requestAnimationFrame);
    document.body.append(element);
    await element.whenRendered();
  }
  expect(comparePictures(await readPicture(element), before).worst === 0, 'another picture');
});

await check('toBlob at another size', async () => {
  const size = { width: 150, height: 60 };
  const blob = await element.toBlob(size);
  expectSame(decodePicture(new Uint8Array(await blob.arrayBuffer())), size);
});

await check('another volume, of floats', async () => {
  element.src = `${data}/ball.nii`;
  await expectPicture(element, { volume: ball });
});

await check('a manifest and its mosaic', async () => {
  element.src = `${data}/field.json`;
  await expectPicture(element);
});

await check('a typing error is reported, and the picture stays', async () => {
  const told = nextEvent(element, 'error');
  element.transferFunction = '0 black 0, 1 whit 5%';
  const { code } = await told;
  expect(code === 'transfer-function/syntax', code);
  element.transferFunction = plainAttributes['transfer-function'];
  await expectPicture(element);
});

await check("a shape of the author's stands in it", async () => {
  const before = await readPicture(element);
  const template = document.createElement('template');
  template.innerHTML =
    '<shape><appearance><material diffusecolor="0 0 0" emissivecolor="0 1 0"></material></appearance><box size="8 8 60"></box></shape>';
  const drawn = nextEvent(element, 'render');
  element.append(template.content);
  await drawn;
  const { data: pixels } = await readPicture(element);
  const isGreen = (i) => pixels[i] < 8 && pixels[i + 1] > 245 && pixels[i + 2] < 8;
  const count = Array.from({ length: pixels.length / 4 }, (_, i) => isGreen(i * 4)).filter(Boolean).length;
  expect(count > 40, `${count} green pixels`);
  const drawnAgain = nextEvent(element, 'render');
  element.replaceChildren();
  await drawnAgain;
  expect(comparePictures(await readPicture(element), before).worst === 0, 'it left something behind');
});

await check('eight at once', async () => {
  const all = Array.from({ length: 8 }, (_, i) => makeElement({ src: `${data}/${i % 2 ? 'ball.nii' : 'field.nii'}` }));
  document.body.append(...all);
  for (const [i, one] of all.entries()) await expectPicture(one, i % 2 ? { volume: ball } : {});
  for (const one of all) one.remove();
});

/** The same page in a frame, with WebGL 1. */
async function runWebGl1() {
  const frame = document.createElement('iframe');
  frame.style.cssText = 'position: fixed; inset: 0; width: 700px; height: 400px'; // Frames out of sight draw nothing.
  frame.src = '?webgl1';
  document.body.append(frame);
  await new Promise((resolve) => (window.__frameDone = resolve));
  window.__messages.push(...frame.contentWindow.__messages);
}

if (isWebGl1) {
  window.parent.__frameDone();
} else {
  await runWebGl1();
  window.__smoke.done = true;
}
