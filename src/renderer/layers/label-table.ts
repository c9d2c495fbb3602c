import { findUniform, listLabels } from '../../volume/label-cells.ts';
import type { LabelMap, LabelStyle } from '../../volume/labels.ts';
import { isWebGl2 } from '../device/device.ts';
import type { Device, Gl } from '../device/device.ts';
import { prepareUpload } from '../textures/fill-texture.ts';
import type { Upload } from '../textures/fill-texture.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import { labelsAcross } from '../ray/modules/labels.ts';
import { textureUnit } from '../device/texture-unit.ts';

/** Voxels along the edge of a cell, if the device has room for so many cells. In cells with one label, samples need no vote among labels. */
const finestEdge = 4;

/** The labels' appearance, and which cells have only one label: a texture. A map keeps it when only the appearance changes. */
export interface LabelTable {
  readonly inputs: ProgramInputs;
  /** Write the labels' appearance. @param styles - one for each id of the map */
  apply(styles: readonly LabelStyle[]): void;
  dispose(): void;
}

/** Fill the part of a map's table that does not depend on the labels' appearance. */
export function* createLabelTable(gl: Gl, map: LabelMap, { maxTextureSize }: Device): Upload<LabelTable> {
  const styleRows = Math.ceil(map.ids.length / labelsAcross);
  const countCells = (edge: number): number => map.dimensions.reduce((product, n) => product * Math.ceil(n / edge), 1);
  const rowsOf = (edge: number): number => Math.ceil(countCells(edge) / 4 / labelsAcross);
  let edge = finestEdge;
  while (styleRows + rowsOf(edge) > maxTextureSize) edge *= 2;
  const uniform = findUniform(yield* listLabels(map, edge));
  const rows = styleRows + rowsOf(edge);
  const texture = gl.createTexture();
  const upload = (numbers: Float32Array, firstRow: number): void => {
    const count = Math.ceil(numbers.length / 4 / labelsAcross);
    const texels = new Float32Array(4 * labelsAcross * count);
    texels.set(numbers);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    prepareUpload(gl);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, firstRow, labelsAcross, count, gl.RGBA, gl.FLOAT, texels);
  };
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, isWebGl2(gl) ? gl.RGBA32F : gl.RGBA, labelsAcross, rows, 0, gl.RGBA, gl.FLOAT, null);
  upload(uniform, styleRows);
  return {
    inputs: {
      uniforms: {
        uLabelTableRows: [styleRows, 1 / rows],
        uLabelCells: [...map.dimensions.map((n) => Math.ceil(n / edge)), 1 / edge],
      },
      units: [textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uLabelTable' })],
    },
    apply: (styles) =>
      upload(
        Float32Array.from(
          styles.flatMap(({ color: [red, green, blue], opacityFactor, group = 0 }) => [
            red + 2 * group,
            green,
            blue,
            Math.max(0, opacityFactor),
          ]),
        ),
        0,
      ),
    dispose: () => gl.deleteTexture(texture),
  };
}
