import ambient from '../../../../shaders/chunks/shade/ambient.glsl?raw';
import { margin, measureAmbientLight } from '../../../optics/rays/ambient-light.ts';
import type { AmbientLight } from '../../../optics/rays/ambient-light.ts';
import type { CutFaces } from '../../../optics/rays/cut-fade.ts';
import { atlasLayout, packAtlas } from '../../../volume/atlas.ts';
import type { Matrix4 } from '../../../volume/matrix.ts';
import { Kept } from '../../device/kept.ts';
import type { Device, Gl } from '../../device/device.ts';
import type { ProgramInputs } from '../../device/inputs.ts';
import { textureUnit } from '../../device/texture-unit.ts';
import { prepareUpload, uploadPlane } from '../../textures/fill-texture.ts';
import type { RayModule, RayText, RayTwin, TwinFrame } from '../ray-module.ts';
import { shadingTwins } from './field-taps.ts';
import type { CutsOfRays } from './lit-cuts.ts';

/** Its chunk needs those of `lit`. */
export const ambientText: RayText = {
  name: 'ambient',
  stage: 'shade',
  defines: {},
  chunks: [ambient],
  samplers: ['uAmbient'],
};

type HidingFrame = Pick<TwinFrame, 'volume' | 'optics' | 'rays'>;

/** The map of a picture, which its twin reads too. */
class AmbientMap {
  readonly #kept = new Kept<AmbientLight>();

  of({ volume, optics, rays }: HidingFrame, cuts: CutsOfRays): AmbientLight {
    const { transferFunction, referenceLength, opacityFactor } = optics;
    const all = facesOf(cuts, rays.unitToRegion);
    // Labels and layers make another volume of the same samples.
    const { samples, grid } = volume;
    return this.#kept.get([samples, grid, transferFunction, referenceLength, opacityFactor, JSON.stringify(all)], () =>
      measureAmbientLight({ volume, transferFunction, referenceLength, opacityFactor, cuts: all }),
    );
  }
}

const facesOf = (cuts: CutsOfRays, unitToRegion: Matrix4): CutFaces => ({ ...cuts, unitToRegion });

/** Only places matter to a pick: then light is left out. */
const ambientTwin = (map: AmbientMap, cuts: CutsOfRays): RayTwin => ({
  load: ({ placesOnly }) => (placesOnly ? Promise.resolve() : shadingTwins.load()),
  parts: (frame) =>
    frame.placesOnly
      ? {}
      : {
          shades: [
            shadingTwins.code.ambientShade(
              map.of(frame, cuts),
              frame.volume.grid,
              facesOf(cuts, frame.rays.unitToRegion),
            ),
          ],
        },
});

/** Ambient occlusion, on volumes that are lit. */
export class AmbientRays {
  readonly #map = new AmbientMap();
  readonly #inputs = new Kept<ProgramInputs>();

  constructor(
    readonly gl: Gl,
    readonly device: Device,
  ) {}

  module(cuts: CutsOfRays): RayModule<'shade'> {
    return {
      ...ambientText,
      stage: 'shade',
      sparesRays: true,
      order: 2,
      twin: ambientTwin(this.#map, cuts),
      inputs: (frame) => {
        const map = this.#map.of(frame, cuts);
        return this.#inputs.get([map], (last) => this.#upload(map, last));
      },
    };
  }

  #upload({ dimensions, light, ahead }: AmbientLight, last: ProgramInputs | null): ProgramInputs {
    const { gl } = this;
    const atlas = atlasLayout(dimensions, this.device.maxTextureSize)!;
    const texture = last?.units[0].texture ?? gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    prepareUpload(gl);
    uploadPlane(gl, packAtlas(light, dimensions, atlas), atlas);
    return {
      uniforms: {
        uAmbientGrid: [...dimensions, atlas.columns],
        uAmbientScale: [1 / atlas.width, 1 / atlas.height, margin, ahead],
      },
      units: [textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.LINEAR, samplerName: 'uAmbient' })],
    };
  }

  dispose(): void {
    this.gl.deleteTexture(this.#inputs.last?.units[0].texture ?? null);
  }
}
