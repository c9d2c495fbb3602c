// In the browser: real volumes as we draw them and as others do.
import { defaultReferenceLength } from '../../demos/accuracy/study-view.ts';
import { loadVolume } from '../../src/worker/load.ts';
import type { LoadRequest } from '../../src/formats/base/load-request.ts';
import { framingDistance, orbitCamera } from '../../src/optics/rays/camera.ts';
import { plainMaterial } from '../../src/optics/transfer/lights.ts';
import type { RayStyle } from '../../src/optics/rays/ray-style.ts';
import { resolveTransferFunction } from '../../src/optics/transfer/resolve-transfer-function.ts';
import { windowFromHistogram } from '../../src/optics/transfer/window.ts';
import { cutSteps } from '../../src/quality/levels.ts';
import { autoSteps, stepLengthOf } from '../../src/quality/steps.ts';
import { boundingSphere } from '../../src/volume/grid.ts';
import type { Volume } from '../../src/volume/volume.ts';
import { VolumeScene } from '../../src/x3d/scene.ts';
import { changePlan, drawAt } from '../helpers/change-plan.ts';
import { edgeCurvature } from './edges-page.ts';
import { alignVolume, describeScene } from './peer-scene.ts';
import type { PeerCamera, PeerLight } from './peer-scene.ts';
import '../helpers/provide-substeps.ts';

interface Subject {
  readonly id: string;
  readonly url: string;
  readonly more?: Partial<LoadRequest>;
  readonly look: string;
  /** Values, of the same things. */
  readonly surface: { readonly value: number; readonly color: readonly [number, number, number] };
  /** Degrees. */
  readonly side: readonly [theta: number, phi: number];
  /** How far the camera stands, as a share of the distance that shows the sphere around the volume. */
  readonly near?: number;
}

const data = '/shared-data/medical/';
const demos = '/demos/data/';
const limits = { maxVoxelsPerAxis: 2048, maxAtlasSize: null, maxBytes: 2 ** 31 };
const bone = [0.93, 0.87, 0.75] as const;
const skin = [0.85, 0.68, 0.58] as const;

const subjects: readonly Subject[] = [
  {
    id: 'skull',
    url: `${data}cranium_ct/cranium_ct.nii.gz`,
    look: 'ct-bone',
    surface: { value: 250, color: bone },
    side: [35, 80],
  },
  {
    id: 'head',
    url: `${data}cranium_ct/cranium_ct.nii.gz`,
    look: '-400 #c98f73 0, -250 #d9a489 60%, 200 #f0c8a8 90%',
    surface: { value: -300, color: skin },
    side: [35, 80],
  },
  {
    id: 'soft',
    url: `${data}cranium_ct/cranium_ct.nii.gz`,
    look: 'ct-soft-tissue',
    surface: { value: 40, color: skin },
    side: [35, 80],
  },
  {
    id: 'aorta',
    url: `${data}aorta_mosaic/aorta4096.png`,
    more: { settings: { mosaic: { columns: 10, rows: 10 }, slices: 96, spacing: [0.8, 0.8, -3] } },
    look: '80 #4a080e 0, 110 #b03020 4%, 150 #f0b090 9%, 255 #fff4e0 20%',
    surface: { value: 120, color: [0.85, 0.4, 0.3] },
    side: [20, 80],
  },
  {
    id: 'stent',
    url: `${data}stent_nrrd/stent.nrrd`,
    look: '30% #4a080e 0, 40% #b03020 4%, 55% #f0b090 14%, 100% #fff4e0 30%',
    surface: { value: 0.45, color: bone },
    side: [20, 85],
  },
  {
    id: 'brain',
    url: `${data}mni152_nilearn/mni_icbm152_t1_tal_nlin_sym_09a_converted.nii.gz`,
    look: 'mri',
    surface: { value: 95, color: [0.88, 0.72, 0.65] },
    side: [125, 66],
  },
  {
    id: 'gray',
    url: `${data}mni152_nilearn/mni_icbm152_t1_tal_nlin_sym_09a_converted.nii.gz`,
    look: 'gray',
    surface: { value: 120, color: [0.9, 0.9, 0.9] },
    side: [125, 66],
  },
  {
    id: 'demo-brain',
    url: `${demos}mni152-t1.nii.gz`,
    look: '0% #d8a48f 0, 33% #d8a48f 0, 40% #e2b9a6 60%, 100% #f4e4d8 90%',
    surface: { value: 135, color: [0.89, 0.73, 0.65] },
    side: [65, 75],
    near: 0.74,
  },
  {
    id: 'demo-head',
    url: `${demos}colin27-t1.nii.gz`,
    look: '38 #5a3028 0, 52 #c08068 75%, 80 #e3b8a0 90%, 120 #fff2e6 95%',
    surface: { value: 45, color: skin },
    side: [35, 78],
    near: 0.74,
  },
  {
    id: 'demo-torso',
    url: `${demos}ct-phantom.nii.gz`,
    look: '150 #d9b88a 0, 250 #e6cfa5 50%, 700 #fff6e5 90%',
    surface: { value: 250, color: bone },
    side: [25, 80],
    near: 0.86,
  },
];

export interface LooksOptions {
  /** Pixels along each side of a picture. */
  readonly size: number;
  /** None for all. */
  readonly scenes: readonly string[];
  /** Addresses of bundled modules by name. */
  readonly modules: Readonly<Record<string, string>>;
}

interface Seen {
  readonly volume: Volume;
  readonly subject: Subject;
  readonly camera: PeerCamera;
}

interface Cell {
  readonly name: string;
  readonly picture: ImageBitmap;
}

/** @param notify - what is being done */
export async function drawLooks(
  { size, scenes, modules }: LooksOptions,
  notify: (what: string) => void,
): Promise<{ name: string; sheet: string }[]> {
  const sheets: { name: string; sheet: string }[] = [];
  for (const subject of subjects.filter(({ id }) => scenes.length === 0 || scenes.includes(id))) {
    notify(subject.id);
    const loaded = await loadVolume(
      { ...subject.more, url: subject.url, limits },
      { signal: new AbortController().signal, onProgress: () => {} },
    ).catch(() => null);
    if (!loaded) continue; // These data are not here.
    const volume = alignVolume(loaded);
    const { center, radius } = boundingSphere(volume.grid);
    const [theta, phi] = subject.side.map((degrees) => (degrees * Math.PI) / 180);
    const distance = (subject.near ?? 0.8) * framingDistance(radius, 0.5, 1);
    const seen = {
      volume,
      subject,
      camera: { ...orbitCamera({ theta, phi, radius: distance }, center, 0.5), theta, phi, distance },
    };
    const cells = await drawOurs(seen, size);
    const light: PeerLight = { ...plainMaterial, specular: 0.2 };
    for (const [name, module] of Object.entries(modules)) {
      cells.push(await drawPeer(name, module, { ...seen, size }));
      cells.push(await drawPeer(`${name}, lit`, module, { ...seen, size, light }));
      cells.push(
        await drawPeer(`${name}, lit, gradient opacity`, module, {
          ...seen,
          size,
          light: { ...light, fadesFlat: name === 'vtk' ? 0.1 : 0.3 },
        }),
      );
    }
    sheets.push({ name: subject.id, sheet: paint(cells, size) });
  }
  return sheets;
}

const appearanceOf = ({ subject, volume }: Seen): Promise<Awaited<ReturnType<typeof resolveTransferFunction>>> =>
  resolveTransferFunction(subject.look, volume.window ?? windowFromHistogram(volume.histogram));

async function drawOurs(seen: Seen, size: number): Promise<Cell[]> {
  const { volume, subject, camera } = seen;
  const host = document.body.appendChild(document.createElement('div'));
  const scene = await VolumeScene.create(host, host, () => {});
  const optics = {
    transferFunction: await appearanceOf(seen),
    referenceLength: defaultReferenceLength(volume),
    opacityFactor: 1,
    lightFactor: 1,
  };
  await scene.prepare(volume, optics);
  scene.setVolume(volume);
  await scene.setAppearance({ optics });
  changePlan(scene, { picture: { width: size, height: size } });
  changePlan(scene, { camera });
  const { surface } = subject;
  const styles: readonly [string, RayStyle | null][] = [
    ['ours', null],
    ['ours, lit', { lit: true }],
    ['ours, surface', { clear: true, surfaces: [{ value: surface.value, color: surface.color, opacity: 1 }] }],
  ];
  const cells: Cell[] = [];
  for (const [name, style] of styles) {
    await scene.setAppearance({ style });
    await scene.finished();
    // As at rest: edges of surfaces have more rays.
    const steps = autoSteps(volume.grid);
    changePlan(scene, { substeps: cutSteps({ steps, substeps: 1 }, steps, 1) });
    changePlan(scene, { maxCurvature: 0, edgeCurvature });
    drawAt(scene, stepLengthOf(volume.grid, steps));
    cells.push({ name, picture: await createImageBitmap(scene.canvas) });
  }
  scene.dispose();
  host.remove();
  return cells;
}

async function drawPeer(
  name: string,
  module: string,
  { size, light, ...seen }: Seen & { size: number; light?: PeerLight },
): Promise<Cell> {
  const host = document.body.appendChild(document.createElement('div'));
  const { start } = await import(/* @vite-ignore */ module);
  const peer = await start(host, {
    ...describeScene(seen.volume, await appearanceOf(seen), seen.camera),
    ...(light && { light }),
  });
  peer.setSize(size);
  drawAt(peer, stepLengthOf(seen.volume.grid, 2 * autoSteps(seen.volume.grid)));
  const picture = await createImageBitmap(peer.gl.canvas);
  peer.dispose();
  host.remove();
  return { name, picture };
}

/** Three pictures a row, over black. */
function paint(cells: readonly Cell[], size: number): string {
  const [columns, caption] = [3, 20];
  const canvas = Object.assign(document.createElement('canvas'), {
    width: columns * size,
    height: Math.ceil(cells.length / columns) * (size + caption),
  });
  const context = canvas.getContext('2d')!;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.font = '14px sans-serif';
  context.fillStyle = '#fff';
  for (const [i, { name, picture }] of cells.entries()) {
    const [x, y] = [(i % columns) * size, Math.floor(i / columns) * (size + caption)];
    context.drawImage(picture, x, y, size, size);
    context.fillText(name, x + 6, y + size + 15);
  }
  return canvas.toDataURL();
}
