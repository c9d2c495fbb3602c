// Labels of a layer's volume, and volumes of labels: loaded with the first of them.
import type { ShownLabels } from '../volume/labels.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import type { Device, Gl } from './device.ts';
import { finishUpload, prepareUpload, quickBytes } from './fill-texture.ts';
import type { ProgramInputs, Uniforms } from './inputs.ts';
import { Kept } from './kept.ts';
import { uploadBlock } from './ray/modules/cartesian-field.ts';
import type { BlockTexture } from './ray/modules/cartesian-field.ts';
import { labelLooks } from './ray/modules/label-looks.ts';
import { labelsAcross, labelsText } from './ray/modules/labels.ts';
import type { RayModule } from './ray/ray-module.ts';
import { isWebGl2 } from './device.ts';
import { textureUnit } from './texture-unit.ts';
import type { TextureUnit } from './texture-unit.ts';
import { uploadGradually } from './upload-gradually.ts';

export { discreteProvider } from './ray/modules/discrete-field.ts';

/** Labels on the GPU, and the modules that draw them. */
export class LabelLayer {
  #shown: ShownLabels | null = null;
  #wanted: ShownLabels | null = null;
  /** The map's texture, with what else tells where its voxels lie. */
  #map: BlockTexture | null = null;
  readonly #styles = new Kept<TextureUnit>();

  constructor(readonly gl: Gl, readonly device: Device) {}

  /**
   * @returns resolves when the next picture shows them; a later call takes its place
   * @throws {VolumeViewError} `format/too-large` where the device has no room for them
   */
  async show(labels: ShownLabels | null): Promise<void> {
    this.#wanted = labels;
    if (labels?.map !== this.#shown?.map) {
      const map = labels && (await this.#bring(labels));
      if (this.#wanted !== labels) return map?.dispose();
      if (labels && !map) return; // The context was lost.
      this.#map?.dispose();
      this.#map = map;
    }
    this.#shown = labels;
  }

  /** The map as a volume's samples are brought there: at once, or bit by bit between frames where it is large. */
  async #bring(labels: ShownLabels): Promise<BlockTexture | null> {
    const { numbers, dimensions } = labels.map;
    const upload = uploadBlock(this.gl, { samples: numbers, grid: { dimensions }, hasNoData: false }, { device: this.device, filterInShader: true });
    return numbers.byteLength <= quickBytes ? finishUpload(upload) : uploadGradually(this.gl, upload, () => this.#wanted !== labels);
  }

  /** Those of a volume that has labels. @param projects - whether rays show values, to which opacity does not matter */
  modules(volume: Volume, projects: boolean): readonly RayModule[] {
    const labels = this.#labelsOf(volume);
    if (!labels) return [];
    const text = labelsText({ texture3d: this.device.webgl2, twoBytes: labels.map.numbers instanceof Uint16Array, hides: projects });
    const field: RayModule<'field'> = { ...text, stage: 'field', sparesRays: true, order: 1, inputs: () => this.#inputs(labels) };
    return projects ? [field] : [field, labelLooks];
  }

  /** A radar's grid has no voxels to label. */
  #labelsOf(volume: Volume): ShownLabels | null {
    const labels = this.#shown;
    return labels && !isPolar(volume) && labels.map.dimensions.every((n, axis) => n === volume.grid.dimensions[axis]) ? labels : null;
  }

  #inputs({ styles }: ShownLabels): ProgramInputs {
    const { uniforms: { uMosaic }, units: [unit] } = this.#map!.inputs();
    const looks = this.#styles.get([styles], (last) => uploadStyles(this.gl, styles, last?.texture ?? null));
    const uniforms: Uniforms = { uLabelStyleRow: 1 / Math.ceil(styles.length / labelsAcross), ...(uMosaic && { uLabelMosaic: uMosaic }) };
    return { uniforms, units: [{ ...unit, samplerName: 'uLabels' }, looks] };
  }

  dispose(): void {
    this.#map?.dispose();
    this.gl.deleteTexture(this.#styles.last?.texture ?? null);
  }
}

/** A texel a label: colour, factor of the extinction. */
function uploadStyles(gl: Gl, styles: ShownLabels['styles'], previous: WebGLTexture | null): TextureUnit {
  const rows = Math.ceil(styles.length / labelsAcross);
  const texels = new Float32Array(4 * labelsAcross * rows);
  styles.forEach(({ color, opacityFactor }, i) => texels.set([...color, Math.max(0, opacityFactor)], 4 * i));
  const texture = previous ?? gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  prepareUpload(gl);
  gl.texImage2D(gl.TEXTURE_2D, 0, isWebGl2(gl) ? gl.RGBA32F : gl.RGBA, labelsAcross, rows, 0, gl.RGBA, gl.FLOAT, texels);
  return textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uLabelStyles' });
}
