// A view with a small volume that draws nothing: for tests of what X3D nodes among its children attach to that volume.
import { ErrorState } from '../../src/viewer/model/error-state.ts';
import { withVolumeNodes } from '../../src/viewer/attachments/read-volume-nodes.ts';
import type { ViewLabels } from '../../src/viewer/model/view-labels.ts';
import type { ViewOverlay } from '../../src/viewer/model/view-overlay.ts';
import type { VolumeOptics } from '../../src/viewer/model/volume-info.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import { axialIndexToWorld, cartesianGrid } from '../../src/volume/grid.ts';
import { fakeScene, fakeSocketView, fakeSocketViewer } from './fake.ts';

export const plainAppearance: VolumeOptics = {
  transferFunction: [],
  window: [0, 200],
  referenceLength: 1,
  opacityFactor: 1,
  lightFactor: 1,
  projection: null,
  shading: 'unlit',
  surfaces: null,
};

export function viewOf(html: string): HTMLElement {
  const host = document.createElement('volume-view');
  host.innerHTML = html;
  return host;
}

/** An atlas of two slices next to each other, one pixel high. @param field - its containerField in the node around it */
export function atlasOf(field: string, pixels: readonly number[]): string {
  const canvas = Object.assign(document.createElement('canvas'), { width: pixels.length, height: 1 });
  canvas
    .getContext('2d')!
    .putImageData(new ImageData(new Uint8ClampedArray(pixels.flatMap((x) => [x, x, x, 255])), pixels.length), 0, 0);
  return `<ImageTextureAtlas containerField="${field}" url="${canvas.toDataURL()}" numberOfSlices="2" slicesOverX="2" slicesOverY="1"></ImageTextureAtlas>`;
}

export interface FakeView {
  readonly host: HTMLElement;
  readonly errors: ErrorState;
  readonly shown: { readonly labels: ViewLabels | null; readonly overlay: ViewOverlay | null };
  /** Reads the appearance, and waits for files that it loads. */
  read(): Promise<VolumeOptics>;
}

/** A view of 2 x 1 x 2 voxels. */
export function fakeView(html: string): FakeView {
  const host = viewOf(html);
  const work: Promise<unknown>[] = [];
  const errors = new ErrorState({ file: 'ct.png', changed: () => {}, failed: () => {} });
  const grid = cartesianGrid([2, 1, 2], axialIndexToWorld([2, 1, 2], [1, 1, 1]));
  const scene = fakeScene({ setLabels: async () => {}, setOverlay: async () => {} });
  const socket = socketOf(host);
  socket.view = fakeSocketView({
    host,
    awake: true,
    settings: { src: 'ct.png' },
    errors,
    look: { current: plainAppearance, replacement: null, attachmentsChanged: () => {} },
    volume: { grid, samples: new Uint8Array(4), slope: 1, intercept: 0, format: 'png mosaic', range: [0, 200] },
    viewer: fakeSocketViewer({ scene, invalidate: () => {} }),
    track: (one: Promise<unknown>) => work.push(one),
    fileNotices: new Map(),
    user: { changed: () => {} },
  });
  const read = async (): Promise<VolumeOptics> => {
    const appearance = await withVolumeNodes({ user: { host } }, plainAppearance, { grid });
    while (work.length > 0) await work.shift();
    return appearance;
  };
  return {
    host,
    errors,
    shown: {
      get labels() {
        return socket.last('labels');
      },
      get overlay() {
        return socket.last('overlay');
      },
    },
    read,
  };
}
