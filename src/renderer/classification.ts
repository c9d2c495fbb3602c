import { brighten } from '../optics/brighten.ts';
import { measureEmptySpace } from '../optics/empty-space-distance.ts';
import { buildSubstepTable } from '../optics/substep-table.ts';
import type { RunningIntegral } from '../optics/running-integral.ts';
import { averageSpans, integrateForTable } from '../optics/preintegration-table.ts';
import type { PreintegrationTable } from '../optics/preintegration-table.ts';
import type { OpticalFactors, TransferFunction } from '../optics/transfer-function.ts';
import { finestSpacing } from '../volume/grid.ts';
import type { Volume } from '../volume/volume.ts';
import type { Device, Gl } from './device.ts';
import type * as PolarTextures from '../radar/gpu/polar-textures.ts';
import type { StopsTexture } from '../radar/gpu/slice-textures.ts';
import { uploadEmptySpace, uploadSubstepTable, uploadTable } from './textures.ts';
import type { EmptySpaceTexture } from './textures.ts';
import { emptySpaceUniforms } from './uniforms.ts';
import type { Uniforms } from './uniforms.ts';
import type { TextureUnit } from './texture-unit.ts';

/** What a volume looks like, whatever the view. */
export interface Optics extends OpticalFactors {
  readonly transferFunction: TransferFunction;
  /** World length over which a stop's opacity holds. */
  readonly referenceLength: number;
}

/** What a transfer function makes of a volume, as the shader reads it. */
export interface ClassifiedVolume {
  readonly table: PreintegrationTable;
  readonly units: readonly TextureUnit[];
  readonly uniforms: Uniforms;
}

/** The transfer function as tables for the shader. */
interface Tables {
  readonly bright: TransferFunction;
  readonly integral: RunningIntegral;
  readonly table: PreintegrationTable;
  readonly unit: TextureUnit;
}

/** Something that is made again only when what it depends on changes. */
class Kept<T> {
  last: T | null = null;
  #key: readonly unknown[] = [];

  get(key: readonly unknown[], make: (last: T | null) => T): T {
    if (this.last === null || key.some((part, i) => part !== this.#key[i])) this.last = make(this.last);
    this.#key = key;
    return this.last;
  }
}

/** The textures that depend on the transfer function. Each is filled again when it changes, in place. */
export class Classification {
  readonly #gl: Gl;
  readonly #device: Device;
  readonly #tables = new Kept<Tables>();
  readonly #emptiness = new Kept<EmptySpaceTexture>();
  readonly #substeps = new Kept<TextureUnit>();
  readonly #stops = new Kept<StopsTexture>();

  constructor(gl: Gl, device: Device) {
    this.#gl = gl;
    this.#device = device;
  }

  /** Bytes of its largest texture. */
  get bytes(): number {
    return this.#tables.last?.table.texels.byteLength ?? 0;
  }

  /**
   * @param skipping - whether rays cross empty space without looking
   * @param slices - the part of the package that draws slices, where there are any
   */
  of(volume: Volume, optics: Optics, { skipping, slices }: { skipping: boolean; slices: typeof PolarTextures | null }): ClassifiedVolume {
    const gl = this.#gl;
    const { transferFunction, lightFactor, opacityFactor, referenceLength } = optics;
    const { bright, integral, table, unit } = this.#tables.get([transferFunction, lightFactor], (last) => this.#makeTables(optics, last));
    const emptiness = this.#emptiness.get([transferFunction, volume, skipping], (last) => {
      const { macrocells } = volume;
      const distances = skipping ? measureEmptySpace(macrocells, transferFunction, volume) : new Uint8Array(macrocells.low.length);
      return uploadEmptySpace(gl, distances, macrocells.dimensions, { previous: last?.unit.texture ?? null, device: this.#device });
    });
    const voxelRatio = (finestSpacing(volume.grid) / referenceLength) * opacityFactor;
    const substeps = this.#substeps.get([integral, voxelRatio], (last) => uploadSubstepTable(gl, buildSubstepTable(integral, voxelRatio), last?.texture ?? null));
    const stops = slices && this.#stops.get([bright], (last) => slices.uploadStops(gl, bright, table, last?.unit.texture ?? null));
    return {
      table,
      units: [unit, emptiness.unit, substeps, ...(stops ? [stops.unit] : [])],
      uniforms: { ...emptySpaceUniforms(emptiness), ...stops?.uniforms },
    };
  }

  dispose(): void {
    const units = [this.#tables.last?.unit, this.#emptiness.last?.unit, this.#substeps.last, this.#stops.last?.unit];
    for (const unit of units) this.#gl.deleteTexture(unit?.texture ?? null);
  }

  #makeTables({ transferFunction, lightFactor }: Optics, last: Tables | null): Tables {
    const bright = brighten(transferFunction, lightFactor);
    const integral = integrateForTable(bright);
    const table = averageSpans(integral);
    return { bright, integral, table, unit: uploadTable(this.#gl, table, last?.unit.texture ?? null, this.#device) };
  }
}
