import { VolumeViewError } from '../core/errors.ts';
import { probeDevice } from '../renderer/probes/probe-device.ts';
import type { X3dCanvas, X3dDocument, X3dElement, X3dNode, X3dom } from './x3dom-types.ts';

/** A running x3dom document inside a container of ours. */
export interface StartedCanvas {
  readonly element: X3dElement;
  readonly canvas: X3dCanvas;
  readonly document: X3dDocument;
}

let count = 0;

/**
 * Starts x3dom by hand on an X3D element inside a shadow root, where x3dom would not look for one. It gets neither
 * x3dom's mouse, wheel and key listeners (they trap the page's scrolling) nor its endless frame loop: `hasRuntime` is
 * false, and the caller draws when something changed.
 * @param markup - builds the scene's own nodes
 * @param needsFrame - called whenever x3dom wants to draw
 * @throws {VolumeViewError} `webgl/unavailable`
 */
export function startCanvas(
  x3dom: X3dom,
  container: Element,
  options: { buildScene: () => Element; needsFrame: () => void },
): StartedCanvas {
  const element = document.createElement('x3d') as X3dElement;
  element.append(options.buildScene());
  container.append(element);
  element.hasRuntime = false;
  const canvas = withPremultipliedContext(x3dom, () =>
    withoutSpareContext(x3dom, () => new x3dom.X3DCanvas(element, count++)),
  );
  if (!canvas.gl) {
    element.remove();
    throw new VolumeViewError(
      'webgl/unavailable',
      'there is no WebGL context: the page may have too many 3D pictures, or the graphics driver stopped; reload the page',
    );
  }
  // It would ask for VR headsets, and a frame without that permission reports this on the console.
  canvas.checkForVRSupport = () => {};
  // It counts its frames for a hidden box, once a second and forever, and that keeps the scene in memory.
  clearInterval(canvas.stateViewer.updateMethodID);
  // Its canvas is a picture inside our own control: the host has role, label and focus.
  canvas.canvas.removeAttribute('tabindex');
  canvas.canvas.removeAttribute('id');
  canvas.canvas.setAttribute('aria-hidden', 'true');
  for (const child of [...element.children]) if (child.localName === 'div') child.remove();

  const runtime = new x3dom.Runtime(element, canvas);
  element.runtime = runtime;
  runtime.initialize(element, canvas);
  const properties = new x3dom.Properties();
  for (const [name, value] of Object.entries(defaultProperties)) properties.setProperty(name, value);
  withoutControllers(x3dom, () => canvas.load(element, 0, properties));
  // It watches the whole document for removed X3D elements; the owner of our scene removes it.
  canvas.doc.X3DMutationObserver.disconnect();
  // x3dom flies to a bound viewpoint for a second; here the change is immediate.
  canvas.doc._viewarea._mixer.reset();
  canvas.doc._viewarea.animateTo = () => {};
  watchNeedRender(canvas.doc, options.needsFrame);
  return { element, canvas, document: canvas.doc };
}

const defaultProperties = {
  showLog: 'false',
  showStat: 'false',
  showProgress: 'false',
  PrimitiveQuality: 'High',
  useGeoCache: 'true',
  baseURL: '',
};

/**
 * x3dom requests a context with straight alpha, in which half transparent pixels over nothing come out too dark. What
 * both it and the ray-caster leave in the buffer is premultiplied, so the context has to be premultiplied too.
 */
function withPremultipliedContext<T>(x3dom: X3dom, make: () => T): T {
  const prototype = x3dom.X3DCanvas.prototype;
  const original = prototype._createHTMLCanvas;
  return withOther(
    prototype,
    '_createHTMLCanvas',
    function (this: unknown, element: Element) {
      const canvas = original.call(this, element);
      const getContext = canvas.getContext.bind(canvas) as (
        type: string,
        attributes?: object,
      ) => RenderingContext | null;
      canvas.getContext = ((type: string, attributes?: object) =>
        getContext(type, {
          ...attributes,
          premultipliedAlpha: true,
          failIfMajorPerformanceCaveat: false,
        })) as HTMLCanvasElement['getContext'];
      return canvas;
    },
    make,
  );
}

/**
 * x3dom makes a second context with each canvas, just to test for WebGL 2, and leaves it to the garbage collector.
 * Browsers allow 16 in all; beyond that the oldest picture of the page is lost.
 */
function withoutSpareContext<T>(x3dom: X3dom, make: () => T): T {
  return withOther(x3dom.Utils, 'isWebGL2Enabled', () => probeDevice().webgl2, make);
}

/** x3dom puts models of VR controllers into the first scene of the page, whoever owns it. */
function withoutControllers<T>(x3dom: X3dom, make: () => T): T {
  return withOther(x3dom.VRControllerManager.prototype, '_addInlines', () => {}, make);
}

function withOther<O, K extends keyof O, T>(owner: O, name: K, other: O[K], make: () => T): T {
  const original = owner[name];
  owner[name] = other;
  try {
    return make();
  } finally {
    owner[name] = original;
  }
}

/** x3dom sets a flag when it wants to draw; turn the flag into a call. */
function watchNeedRender(doc: X3dDocument, needsFrame: () => void): void {
  let value: boolean | number = doc.needRender;
  Object.defineProperty(doc, 'needRender', {
    configurable: true,
    get: () => value,
    set: (next: boolean | number) => {
      value = next;
      if (next) needsFrame();
    },
  });
}

/** Whether x3dom animates something by itself. */
export function isAnimating({ document }: StartedCanvas): boolean {
  const running = ({ _vf }: X3dNode): boolean => Boolean(_vf.enabled) && Boolean(_vf.isActive || _vf.loop);
  return document.isAnimating() || document._nodeBag.timer.some(running);
}
