/**
 * A ray has five stages: **interval** (where it runs) -> **field** (what is there) -> **classify** (what that looks like) ->
 * **shade** (how light or style changes it) -> **gather** (what all of it comes to). A stage holds modules; a module is one
 * place: a file in `modules/` and its chunk of GLSL. `shaders/programs/ray-caster.frag.glsl` walks the ray and calls the stages.
 *
 * To add a module, a shading module `tint` say:
 *
 * 1. `shaders/chunks/tint.glsl`: `vec4 tintShade(Segment segment, vec4 seen)`, with its uniforms.
 * 2. `src/optics/tint.ts`: the same in float64, a function that gives the `ShadeStage` of optics/rays/ray-stages.ts. A line in
 *    optics/usual-twins.ts or optics/shading-twins.ts: these files are loaded with the first ray that is cast on the processor.
 * 3. `src/renderer/ray/modules/tint.ts`: a function that makes the `RayModule`: chunk, samplers, what follows from it for
 *    others, `inputs`, which gives its uniforms and textures for a frame, and `twin`, which gives its stage in float64.
 * 4. `src/renderer/layers/volume-layer.ts`: makes it and gives it back; a line in `modules()` says when it takes part. That list
 *    is the only one: pictures are drawn of it, and picks, checks and the reference of tests are cast of it (compose-twins.ts).
 * 5. `test/helpers/ray-modules.ts`: a line, by which it is compiled alone and in pairs with modules of other stages; and a
 *    test of its picture against the reference's.
 *
 * What a chunk has to have, by stage, where `tint` is the module's name:
 * - interval: `Interval tintInterval(Ray ray, Interval interval)`. Any number of them. It may call `classifyValue`.
 * - field: `bool sampleVolume(vec3 p, out float value)`, the stored value at a point of the unit cube, false where there is no
 *   data; and `bool isFolded(float from, float to)` where it defines FOLDS as 1. One of them. Any number of others, which have
 *   `members`, add these to the sample: `Sample tintField(vec3 p, Sample known)`.
 * - classify: `vec4 classifySegment(Segment segment)` and `vec4 classifyValue(float value)`. One.
 * - shade: `vec4 tintShade(Segment segment, vec4 seen)`. Any number.
 * - gather: `struct Gathered`, `Gathered beginGathering()`, `void gatherSegment(Segment segment, inout Gathered gathered)`,
 *   `bool isSettled(Gathered gathered)`, `float chooseSubsteps(Sample front, Sample back, Gathered gathered)` where SUBSTEPS is defined (see count-substeps.glsl),
 *   `Ahead lookAhead(CellRay cells, float number, Gathered gathered)`, see cells.glsl, and
 *   `vec4 finishGathering(Gathered gathered, Path path)`, premultiplied. Where it defines LOOKS also
 *   `void lookCloser(Segment segment, inout Gathered gathered)`: a ray that `isSettled` may only wait for it, with its last segment: what
 *   takes much and few segments need. One. It may call `seeSegment`, which classifies and
 *   shades, `classifyValue`, and `sampleField(path.origin + path.forward * along)`.
 *
 * Values in chunks are shares of the transfer function's domain; colours are premultiplied; lengths are bounding diameters
 * from where the ray enters. A `Sample` has `value` and `valid`; a `Segment` has `front`, `back`, `begin`, `span` and
 * `visible`, the share of it that reaches the eye.
 */
import type { DeviceRectangle } from '../../optics/cells/bound-seen-cells.ts';
import type { Pixels } from '../../optics/rays/between-pixels.ts';
import type { Contribution } from '../../optics/cells/empty-space-distance.ts';
import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import type { RayStages } from '../../optics/rays/ray-stages.ts';
import type { PixelLattice, Ray, RaySetup } from '../../optics/rays/rays.ts';
import type { OpticalFactors, TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { Matrix4 } from '../../volume/matrix.ts';
import type { Volume } from '../../volume/volume.ts';
import type { Defines } from '../device/compose-stage.ts';
import type { Device, Gl } from '../device/device.ts';
import type { DrawTarget } from '../device/draw-target.ts';
import type { Upload } from '../textures/fill-texture.ts';
import type { ProgramInputs } from '../device/inputs.ts';

/** How a ray is walked, whatever it meets. */
type Walk = 'eyeT' | 'step' | 'maxSubsteps' | 'leastSubsteps';

/** The five stages of a ray in float64. */
export type TwinStages = Omit<RayStages, Walk>;

/** What a ray is cast through: what `RayFrame` is to the GPU. */
export interface TwinFrame {
  readonly volume: Volume;
  readonly optics: Optics;
  readonly rays: RaySetup;
  /** Whether places and opacities are all that matters, as to a pick: light, which changes neither, may be left out. */
  readonly placesOnly: boolean;
  /** t at which the nearest opaque shape of the scene stands, Infinity where there is none; absent where no shape ends rays. */
  readonly shapeT?: (ray: Ray) => number;
}

/** A module in float64. */
export interface RayTwin {
  /** Load its code. @throws {VolumeViewError} `format/unsupported` */
  load(frame: TwinFrame): Promise<unknown>;
  /**
   * What it adds, as soon as its code is there: lists are added to those of other modules, and single stages replace them.
   * @param before - the stages so far, which come in this order: field, interval, classify, shade, gather
   */
  parts(frame: TwinFrame, before: TwinStages): Partial<TwinStages>;
}

export type StageName = 'interval' | 'field' | 'classify' | 'shade' | 'gather';

/** What a module adds to the vertices of rays. */
export interface BetweenText {
  readonly defines: Defines;
  /** With quad-place.glsl before the others. */
  readonly chunks: readonly string[];
  readonly samplers: readonly string[];
  /** GLSL that is true where a quad needs rays: of `QuadPlace place`, see quad-place.glsl, and `Surroundings around`, see between-pixels.glsl. */
  readonly needsRays: string;
}

/** What a program's text has of a module. */
export interface RayText {
  /** In camelCase; the first part of the names of its functions. */
  readonly name: string;
  readonly stage: StageName;
  /** Its options, and constants of its twin; they tell programs apart. */
  readonly defines: Defines;
  /** GLSL. What several modules need is in the program once. */
  readonly chunks: readonly string[];
  /** Samplers of its chunks: a program has no more than 8, which WebGL 1 guarantees. */
  readonly samplers: readonly string[];
  /** Has a say in which quads of pixels get rays of their own, whatever the curvature of the picture. */
  readonly between?: BetweenText;
  /** Of a gather module that does not take steps: GLSL with `walkRay`, in place of what walks other rays. */
  readonly walk?: string;
  /** Of a field module that finds out more of a place: what it adds to struct Sample, "float label" for instance. */
  readonly members?: readonly string[];
}

/** One module of a ray, with its textures on a context. */
export interface RayModule<S extends StageName = StageName> extends RayText {
  readonly stage: S;
  /** Whether pixels may do without rays of their own: not where it makes the picture jump, as an edge does. */
  readonly sparesRays: boolean;
  /**
   * Order of convergence with the step length on a smooth field, where all else of the ray is exact; Infinity where steps do not
   * matter to it. That of a ray is the lowest of its modules'.
   */
  readonly order: number;
  /** Which values can show; all where absent. Kept while the optics are the same. */
  contributes?(optics: Optics): Contribution;
  /** Its uniforms and textures, which it makes as they are needed. */
  inputs(frame: RayFrame): ProgramInputs;
  /** What it is in float64, for picks, checks and tests; null where the twin of another module says it all. */
  readonly twin: RayTwin | null;
  /** Casts more rays where it makes the picture jump, for pictures at rest; absent where it does not. */
  edges?(): EdgeDrawing;
  /** Give its textures back. */
  dispose?(): void;
}

/** How a ray of some rows of pixels is cast. */
export interface EdgeCast {
  readonly program: WebGLProgram;
  /** For the box. */
  readonly inputs: ProgramInputs;
  readonly firstRow: number;
  readonly rows: number;
}

/** Draws more rays for those pixels of a picture that an edge runs through. */
export interface EdgeDrawing {
  /** Where they go, one after the other: pixels across and up, from the pixel's middle. */
  readonly offsets: readonly (readonly [number, number])[];
  /**
   * Find these pixels. Binds the picture's framebuffer, and waits for it.
   * @param edgeCurvature - 1/255, see optics/rays/edge-rays.ts
   * @param asPoints - whether the program that casts the rays draws quads of pixels as points
   */
  find(picture: DrawTarget, edgeCurvature: number, asPoints: boolean): void;
  /** Mix one more ray into these pixels of the picture that is bound. @param number - of its offset */
  mix(number: number, cast: EdgeCast): void;
}

/** A volume on the GPU. */
export interface FieldModule extends RayModule<'field'> {
  /** Stored sample = what the chunk's `sampleVolume` gives, times this. */
  readonly storedScale: number;
  /** On the GPU. */
  readonly bytes: number;
  inputs(): ProgramInputs;
  dispose(): void;
}

/** Surfaces in a volume at which rays end; renderer does not know what they are. */
export interface SliceModule<Slice = unknown> extends RayModule<'interval'> {
  slices: readonly Slice[];
}

/** What of an author's cuts rays, and what makes the module that does: it comes with the code that reads the cuts. */
export interface RayCut<Item = unknown> {
  readonly create: (gl: Gl) => SliceModule<Item>;
  readonly items: readonly Item[];
}

/** Ends rays at the scene's shapes. */
export interface SurfacesModule extends RayModule<'interval'> {
  /** In which quads of the lattice that it was last asked for rays end unforeseen, see optics/rays/depth-jumps.ts. Binds a framebuffer. */
  readJumps(): Pixels;
}

/** How volumes of a kind of grid are brought to the GPU. */
export interface FieldProvider {
  /** @throws {VolumeViewError} `format/too-large` where it does not fit the device */
  upload(gl: Gl, volume: Volume, device: Device): Upload<FieldModule>;
  /** Absent where such volumes have no slices. */
  createSlices?(gl: Gl): SliceModule;
  /** What brings another volume on the same grid to the GPU, read with the first: loaded with the first of them. Absent where there is none. */
  second?(): Promise<(gl: Gl, overlay: ShownOverlay, device: Device) => Upload<SecondField>>;
}

/** A second volume on the GPU, over a first one. */
export interface SecondField {
  /** What its field, and what shows of it, are in float64. @param overlay - that is shown */
  twins(overlay: ShownOverlay): { readonly field: RayTwin; readonly look: RayTwin };
  /** Of a field module that adds `float overlay` to the sample. */
  readonly text: RayText;
  /** What the chunk's stored value means, see `StoredValues` of optics/transfer/share-map.ts. */
  readonly stored: { readonly slope: number; readonly intercept: number; readonly storedScale: number };
  /** Data values more than this apart are on two sides of a fold; Infinity where none fold. */
  readonly foldFrom: number;
  inputs(over: Volume): ProgramInputs;
  dispose(): void;
}

/** What a volume looks like, whatever the view. */
export interface Optics extends OpticalFactors {
  readonly transferFunction: TransferFunction;
  /** World length over which a stop's opacity holds. */
  readonly referenceLength: number;
}

/** How deep opaque shapes stand in a picture. */
export interface ShapeDepths {
  readonly all: DrawTarget;
  /** Of those that are neither lines nor points; the same if all are. */
  readonly solid: DrawTarget;
  /** The part of the picture that they may stand in, in device coordinates. */
  readonly bounds: DeviceRectangle;
  /** null where there are none. */
  readonly solidBounds: DeviceRectangle | null;
}

/** Pixels of a picture with shapes. */
export interface SurfaceLattice extends PixelLattice {
  /** The lattice before, from which pixels are interpolated; null or absent if all get rays. */
  readonly half?: unknown;
  /** Whether it serves for nothing but to interpolate others: lines and points end none of its rays. */
  readonly isCoarse?: boolean;
}

/** The scene's opaque shapes, at which rays end. */
export interface Surfaces {
  readonly depths: ShapeDepths;
  readonly projection: Matrix4;
  /** Pixels of the picture that they were drawn in. */
  readonly picture: { readonly width: number; readonly height: number };
  readonly lattice: SurfaceLattice;
  /** World length. */
  readonly stepLength: number;
}

/** What a picture is drawn of. */
export interface RayFrame {
  readonly volume: Volume;
  readonly field: FieldModule;
  readonly optics: Optics;
  /** Data values that are 0 and 1 of the transfer function's domain. */
  readonly domain: readonly [number, number];
  readonly rays: RaySetup;
  readonly surfaces: Surfaces | null;
  /** Whether a ray shows the less the shorter it is. */
  readonly fades: boolean;
  /** Whether rays cross empty space without looking. */
  readonly skipping: boolean;
  /** The most substeps of a step. */
  readonly maxSubsteps: number;
  /** How finely each macrocell has to be sampled, see optics/cells/cell-detail.ts; null where nothing is known of it. */
  readonly detail: Uint8Array | null;
  /** Voxels of the finest axis that a step is long; 0 where `detail` has no say. */
  readonly voxelsPerStep: number;
  /** Of all modules that have some. */
  readonly contributions: readonly Contribution[];
}
