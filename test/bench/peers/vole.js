// vole-core of the Allen Institute, as its readme uses it: an OME-Zarr that its loader reads in a worker, and its ray march. Of a pyramid it shows one
// level as a whole: the finest of which all slices fit into one texture, by default of 4096 x 4096 texels.
import { LoadSpec, View3d, VolumeLoaderContext } from '@aics/vole-core';

/** So long it must draw nothing to be finished, ms. */
const quiet = 500;

/** Any number from that of the last level. */
const coarsest = 99;

/**
 * @param {HTMLElement} host
 * @param {{
 *   url: string,
 *   colorAt: (value: number) => number[],
 *   density: number,
 *   camera: { eye: number[], up: number[], degrees: number },
 *   maxAtlasEdge?: number,
 * }} scene - colorAt: red, green and blue, 0 to 1, of which it makes the opacity, too; camera: the volume's longest edge is 1, its middle the origin;
 *   maxAtlasEdge: for a finer level. It reads the coarsest one first, as it limits its requests at a time from the second load on, and a browser refuses
 *   thousands of them
 * @returns {Promise<{ first: number, final: number, size: number[], draws: number }>} when it drew its first picture with data and its last one, and when
 *   it was asked to: `performance.now()`
 */
export async function show(host, { url, colorAt, density, camera, maxAtlasEdge }) {
  const context = new VolumeLoaderContext();
  const view = new View3d({ parentElement: host });
  const gl = view.getCanvasDOMElement().getContext('webgl2');
  /** Whether data came that it has not drawn. */
  let isWaiting = true;
  let hasData = false;
  let first = 0;
  let last = 0;
  let draws = 0;
  view.setOnRenderCallback(() => {
    // It waits for the GPU.
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    last = performance.now();
    draws++;
    if (hasData) {
      first ||= last;
      isWaiting = false;
    }
  });
  await context.onOpen();
  const loader = await context.createLoader(url);
  const spec = new LoadSpec();
  if (maxAtlasEdge) {
    Object.assign(spec, { maxAtlasEdge, multiscaleLevel: coarsest });
    turnAtlas(loader);
  }
  const volume = await loader.createVolume(spec, (loaded, index) => {
    const channel = loaded.getChannel(index);
    loaded.setColorPalette(index, makePalette(colorAt, channel.rawMin, channel.rawMax));
    loaded.setColorPaletteAlpha(index, 1);
    view.onVolumeData(loaded, [index]);
    view.setVolumeChannelEnabled(loaded, index, true);
    view.updateActiveChannels(loaded);
    view.updateLuts(loaded);
    view.redraw();
    hasData = isWaiting = true;
  });
  view.addVolume(volume);
  view.setShowBoundingBox(volume, false);
  view.updateDensity(volume, density);
  view.updateExposure(0.5); // Colours as they are in the palette.
  view.updateCamera(camera.degrees, 0, 0);
  view.setCameraState({ position: camera.eye, up: camera.up, target: [0, 0, 0], fov: camera.degrees });
  await loader.loadVolumeData(volume);
  if (maxAtlasEdge) await volume.updateRequiredData({ multiscaleLevel: 0 });
  const isFinished = () => !isWaiting && performance.now() - last >= quiet;
  while (!isFinished()) await new Promise((resolve) => setTimeout(resolve, 20));
  const { x, y, z } = volume.imageInfo.subregionSize;
  context.close();
  return { first, final: last, size: [x, y, z], draws };
}

/**
 * It has as many slices in a row as should be in a column, so that its texture may be wider than the GPU can: with 20 x 16 slices of 512 x 384 voxels 10240
 * texels, but 16 x 20 of them fit into 8192 x 8192.
 */
function turnAtlas(loader) {
  const load = loader.loadRawChannelData.bind(loader);
  loader.loadRawChannelData = (image, spec, onImage, onData) =>
    load(
      image,
      spec,
      (found, foundSpec) => onImage(found && { ...found, atlasTileDims: found.atlasTileDims.toReversed() }, foundSpec),
      onData,
    );
}

/** Colours of the values from the smallest to the largest one that a level has: each texel holds for its middle. */
function makePalette(colorAt, min, max) {
  const palette = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) {
    const color = colorAt(min + ((i + 0.5) / 256) * (max - min));
    palette.set([...color.map((c) => Math.round(255 * c)), 255], 4 * i);
  }
  return palette;
}
