// NiiVue: its volume renderer, with its illumination by a picture of a lit sphere where a scene has a light. It classifies voxels and interpolates their colours, takes one sample a
// voxel, and uses a parallel projection; none of that can be set.
import { NVImage, Niivue } from '@niivue/niivue';

const headerBytes = 352;

/** Stops of its colour table. */
const tableSize = 256;

/** @see peers/README.md for what a peer is given and gives */
export async function start(host, scene) {
  const canvas = document.createElement('canvas');
  host.append(canvas);
  const view = new Niivue({
    backColor: [0, 0, 0, 1],
    show3Dcrosshair: false,
    isOrientCube: false,
    isColorbar: false,
    isResizeCanvas: false,
    isHighResolutionCapable: false,
    loadingText: '',
    logLevel: 'silent',
  });
  await view.attachToCanvas(canvas, false);
  view.addColormap('scene', makeTable(scene));
  const image = await NVImage.new(writeNifti(scene), 'scene.nii', 'scene', 1, null, ...scene.domain);
  view.addVolume(image);
  view.setSliceType(view.sliceTypeRender);
  if (scene.light) {
    await view.setVolumeRenderIllumination(0.6);
    if (scene.light.fadesFlat) await view.setGradientOpacity(scene.light.fadesFlat);
  }
  const { theta, phi } = scene.camera;
  view.setRenderAzimuthElevation(180 - (theta * 180) / Math.PI, 90 - (phi * 180) / Math.PI);
  // Half of the picture's height where the volume's centre is; it shows 0.8 of the sphere around the volume at scale 1.
  const halfHeight = scene.camera.distance * Math.tan(scene.camera.fieldOfView / 2);
  view.setScale((0.8 * view.furthestFromPivot) / halfHeight);
  return {
    isFixed: true,
    parallel: { target: [...view.pivot3D], halfHeight },
    setSize(size) {
      canvas.width = canvas.height = size;
    },
    draw: () => view.drawScene(),
    gl: view.gl,
    dispose() {
      view.gl.getExtension('WEBGL_lose_context')?.loseContext();
      canvas.remove();
    },
  };
}

/** Opacities hold for a voxel. */
function makeTable({ table, spacing, referenceLength }) {
  const texels = Array.from(
    { length: tableSize },
    (_, i) => Math.round((i / (tableSize - 1)) * (table.length / 4 - 1)) * 4,
  );
  const channel = (c) => texels.map((at) => Math.round(255 * table[at + c]));
  const voxel = Math.min(...spacing) / referenceLength;
  return {
    R: channel(0),
    G: channel(1),
    B: channel(2),
    A: texels.map((at) => Math.round(255 * (1 - (1 - table[at + 3]) ** voxel))),
    I: texels.map((_, i) => i),
  };
}

/** Source: the NIfTI-1 standard, nifti1.h */
function writeNifti({ dimensions, spacing, samples }) {
  const file = new Uint8Array(headerBytes + samples.byteLength);
  const view = new DataView(file.buffer);
  view.setInt32(0, 348, true);
  [3, ...dimensions, 1, 1, 1, 1].forEach((n, i) => view.setInt16(40 + 2 * i, n, true)); // dim
  const isBytes = samples instanceof Uint8Array;
  view.setInt16(70, isBytes ? 2 : 16, true); // datatype
  view.setInt16(72, isBytes ? 8 : 32, true); // bitpix
  [1, ...spacing].forEach((length, i) => view.setFloat32(76 + 4 * i, length, true)); // pixdim
  view.setFloat32(108, headerBytes, true); // vox_offset
  view.setFloat32(112, 1, true); // scl_slope
  view.setInt16(254, 1, true); // sform_code
  spacing.forEach((length, axis) => {
    view.setFloat32(280 + 16 * axis + 4 * axis, length, true); // srow_x, srow_y, srow_z
    view.setFloat32(280 + 16 * axis + 12, (-(dimensions[axis] - 1) / 2) * length, true);
  });
  [0x6e, 0x2b, 0x31, 0].forEach((byte, i) => view.setUint8(344 + i, byte)); // magic: n+1
  file.set(new Uint8Array(samples.buffer, samples.byteOffset, samples.byteLength), headerBytes);
  return file.buffer;
}
