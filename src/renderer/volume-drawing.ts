import { VolumeViewError } from '../errors.ts';
import { setUpRays } from '../optics/rays.ts';
import type { PixelLattice, RaySetup } from '../optics/rays.ts';
import { maxSubsteps } from '../optics/segment.ts';
import type { Slice } from '../radar/slices.ts';
import type { ShaderFeatures } from './features.ts';
import type { GridFrame } from '../volume/grid.ts';
import type { Matrix4 } from '../volume/matrix.ts';
import { isPolar } from '../volume/volume.ts';
import type { Volume } from '../volume/volume.ts';
import { Classification } from './classification.ts';
import type { Optics } from './classification.ts';
import type { Device, Gl } from './device.ts';
import type { DrawTarget } from './draw-target.ts';
import { finishUpload } from './fill-texture.ts';
import type { Upload } from './fill-texture.ts';
import type { Size } from './pass-drawing.ts';
import type * as PolarTextures from '../radar/gpu/polar-textures.ts';
import type { ProgramInputs } from './program.ts';
import { tableInShader, uploadVolume } from './textures.ts';
import type { VolumeTexture } from './textures.ts';
import { opticalUniforms, surfaceUniforms, volumeUniforms } from './uniforms.ts';
import { quickBytes, uploadGradually } from './upload-gradually.ts';

/** Where the scene is looked at from. */
export interface View {
  /** Row-major world-to-eye matrix. */
  readonly view: Matrix4;
  /** Row-major. */
  readonly projection: Matrix4;
}

/** The scene's opaque shapes, at which rays end. */
export interface Surfaces {
  readonly depth: DrawTarget;
  readonly projection: Matrix4;
  /** Pixels of the picture that they were drawn in. */
  readonly picture: Size;
  readonly lattice: PixelLattice;
}

/** A volume on the GPU, what of it is shown, and what it looks like: all that a program has to know to cast rays into it. */
export class VolumeDrawing {
  readonly #classification: Classification;
  #volume: Volume | null = null;
  #texture: VolumeTexture | null = null;
  /** The part that only radar volumes need. */
  #polar: typeof PolarTextures | null = null;
  #slices: readonly Slice[] = [];
  optics: Optics | null = null;
  /** One part of the volume that is shown alone, see volume/region.ts; null for all of it. */
  region: GridFrame | null = null;
  /** Whether rays cross empty space without looking. */
  skipping = true;
  /** The most parts that a step is cut into. */
  maxSubsteps: number = maxSubsteps;

  constructor(readonly gl: Gl, readonly device: Device) {
    this.#classification = new Classification(gl, device);
  }

  get volume(): Volume | null {
    return this.#volume;
  }

  /** Present with the volume. */
  get texture(): VolumeTexture | null {
    return this.#texture;
  }

  /** A volume that is not a radar's has none. */
  set slices(slices: readonly Slice[]) {
    this.#slices = slices;
  }

  get slices(): readonly Slice[] {
    return this.#volume?.grid.kind === 'polar' ? this.#slices : [];
  }

  /**
   * Load what only some volumes need, before they are set.
   * @throws {VolumeViewError} `format/unsupported` where that part of the package is not there
   */
  async prepare(volume: Volume): Promise<void> {
    if (!isPolar(volume) || this.#polar) return;
    try {
      this.#polar = await import('../radar/gpu/polar-textures.ts');
    } catch (cause) {
      throw new VolumeViewError(
        'format/unsupported',
        'the part of volume-view that shows radar volumes could not be loaded; check that all files of the package are on the server',
        { cause },
      );
    }
  }

  /** Put a volume on the GPU in place of the one before, at once. */
  set(volume: Volume): void {
    this.#replace(volume, finishUpload(this.#upload(volume)));
  }

  /**
   * The same, bit by bit between frames where the volume is large.
   * @param givenUp - whether it is still wanted
   * @returns whether it is in place; not where it was given up or the context was lost
   */
  async bring(volume: Volume, givenUp: () => boolean): Promise<boolean> {
    const upload = this.#upload(volume);
    const isQuick = volume.samples.byteLength <= quickBytes;
    const texture = isQuick ? finishUpload(upload) : await uploadGradually(this.gl, upload, givenUp);
    if (texture) this.#replace(volume, texture);
    return texture !== null;
  }

  #upload(volume: Volume): Upload<VolumeTexture> {
    if (!isPolar(volume)) return uploadVolume(this.gl, volume, this.device);
    if (!this.#polar) throw new TypeError('prepare() has to be awaited before a radar volume is set');
    return this.#polar.uploadPolarVolume(this.gl, volume, this.device);
  }

  #replace(volume: Volume, texture: VolumeTexture): void {
    this.#deleteTexture();
    this.#texture = texture;
    this.#volume = volume;
  }

  /** What the ray-caster has to be able to do; there has to be a volume. @param surfaces - whether shapes end rays */
  features(surfaces: boolean): ShaderFeatures {
    const slices = this.slices.length > 0;
    const adaptive = this.device.quadPoints && !surfaces && !slices;
    return { ...this.#texture!.features, tableInShader: tableInShader(this.device), surfaces, slices, adaptive };
  }

  /** The rays of a view, or null without a volume, and where the grid is singular. */
  raysOf({ view, projection }: View): RaySetup | null {
    return this.#volume && setUpRays(this.#volume.grid, view, projection, this.region);
  }

  /**
   * What the ray-caster reads but for the rays themselves; there have to be a volume and optics.
   * @param surfaces - null where no shapes end rays
   */
  inputs(rays: RaySetup, surfaces: Surfaces | null): ProgramInputs {
    const [volume, texture, optics] = [this.#volume!, this.#texture!, this.optics!];
    const slices = this.slices.length > 0 ? this.#polar : null;
    const classified = this.#classification.of(volume, optics, { skipping: this.skipping, slices });
    const units = [texture.unit, ...classified.units, texture.polar?.unit, surfaces?.depth.units[0]];
    return {
      uniforms: {
        ...volumeUniforms(volume, texture, classified.table),
        ...opticalUniforms(rays, optics),
        uMaxSubsteps: this.maxSubsteps,
        ...classified.uniforms,
        ...(isPolar(volume) ? slices?.sliceUniforms(this.slices, volume.grid.sweeps) : {}),
        ...(surfaces ? surfaceUniforms(rays, surfaces.projection, surfaces.picture, surfaces.lattice) : {}),
      },
      units: units.filter((one) => one !== undefined),
    };
  }

  dispose(): void {
    this.#deleteTexture();
    this.#classification.dispose();
  }

  #deleteTexture(): void {
    if (!this.#texture) return;
    this.gl.deleteTexture(this.#texture.unit.texture);
    this.gl.deleteTexture(this.#texture.polar?.unit.texture ?? null);
    this.#texture = null;
  }
}
