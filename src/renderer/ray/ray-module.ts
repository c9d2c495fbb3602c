/**
 * A ray has five stages: **interval** (where the ray runs) -> **field** (the values on it) -> **classify** (the colour and opacity of
 * these values) -> **shade** (how light or a style changes the colour) -> **gather** (how all pieces add up to a pixel). A stage holds
 * modules; the code of a module is in one place: a file in `modules/` and its chunk of GLSL. `shaders/programs/ray-caster.frag.glsl`
 * walks the ray and calls the stages.
 *
 * To add a module, for example a shading module `tint`:
 *
 * 1. `shaders/chunks/tint.glsl`: `vec4 tintShade(Segment segment, vec4 seen)`, with its uniforms.
 * 2. `src/optics/tint.ts`: the same in float64, a function that returns the `ShadeStage` of optics/rays/ray-stages.ts. Add a line to
 *    optics/usual-twins.ts or optics/shading-twins.ts: the first ray that is cast on the processor loads these files.
 * 3. `src/renderer/ray/modules/tint.ts`: a function that makes the `RayModule`: its chunk, its samplers, what it means for other
 *    modules, `inputs`, which returns its uniforms and textures for a frame, and `twin`, which returns its stage in float64.
 * 4. `src/renderer/layers/volume-layer.ts`: makes the module and disposes it; a line in `modules()` says when it takes part. There is
 *    only this one list of modules: pictures use it, and so do picks, checks and the reference pictures of tests (compose-twins.ts).
 * 5. `test/helpers/ray-modules.ts`: add a line, so that tests compile the module alone and in pairs with modules of other stages. Also
 *    add a test that compares its picture with the reference picture.
 *
 * What a chunk has to define, by stage, if `tint` is the module's name:
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
import type { RayStyle } from '../../optics/rays/ray-style.ts';
import type { Pixels } from '../../optics/rays/between-pixels.ts';
import type { Contribution } from '../../optics/cells/empty-space-distance.ts';
import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import type { StageName, StageParts } from '../../optics/rays/compose-stages.ts';
import type { PixelLattice, Ray, RaySetup } from '../../optics/rays/rays.ts';
import type { OpticalFactors, TransferFunction } from '../../optics/transfer/transfer-function.ts';
import type { Matrix4 } from '../../volume/matrix.ts';
import type { VolumeData } from '../../volume/volume.ts';
import type { Defines } from '../device/compose-stage.ts';
import type { Device, Gl } from '../device/device.ts';
import type { DrawTarget } from '../device/draw-target.ts';
import type { Upload } from '../textures/fill-texture.ts';
import type { ProgramInputs } from '../device/inputs.ts';

/** The five stages of a ray in float64. */
export type TwinStages = StageParts;

/** The scene of a ray that is cast in float64; on the GPU, this is `RayFrame`. */
export interface TwinFrame {
  readonly volume: VolumeData;
  readonly optics: Optics;
  readonly rays: RaySetup;
  /** Whether only places and opacities matter, as for a pick. Light changes neither, so it may be left out. */
  readonly placesOnly: boolean;
  /** t of the nearest opaque shape of the scene on a ray, Infinity if there is none; absent if no shapes end rays. */
  readonly shapeT?: (ray: Ray) => number;
}

/** A module in float64. */
export interface RayTwin {
  /** Load its code. @throws {VolumeViewError} `format/unsupported` */
  load(frame: TwinFrame): Promise<unknown>;
  /**
   * The parts that the module adds; call it after `load`. Lists are added to those of other modules, and single stages replace them.
   * @param before - the stages so far; their order is: field, interval, classify, shade, gather
   */
  parts(frame: TwinFrame, before: TwinStages): Partial<TwinStages>;
}

export type { StageName } from '../../optics/rays/compose-stages.ts';

/** The text that a module adds to the vertex shader, which decides which quads of pixels need rays. */
export interface BetweenText {
  readonly defines: Defines;
  /** GLSL; quad-place.glsl comes before the others. */
  readonly chunks: readonly string[];
  readonly samplers: readonly string[];
  /** A GLSL expression that is true if a quad needs rays. It can use `QuadPlace place`, see quad-place.glsl, and `Surroundings around`,
   * see between-pixels.glsl. */
  readonly needsRays: string;
}

/** The text that a module adds to a program. */
export interface RayText {
  /** In camelCase; the names of its functions start with it. */
  readonly name: string;
  readonly stage: StageName;
  /** Its options, and constants that its twin also uses. Programs with other defines are different programs. */
  readonly defines: Defines;
  /** GLSL. A chunk that several modules have is in the program once. */
  readonly chunks: readonly string[];
  /** Samplers of its chunks. WebGL 1 guarantees only 8 to a program. */
  readonly samplers: readonly string[];
  /** Present if the module can require rays for quads of pixels, whatever the curvature of the picture. */
  readonly between?: BetweenText;
  /** For a gather module that does not take steps: GLSL with its own `walkRay`, which replaces the usual one. */
  readonly walk?: string;
  /** For a field module that finds out more about a place: what it adds to struct Sample, for example "float label". */
  readonly members?: readonly string[];
}

/** One module of a ray, with its textures on a context. */
export interface RayModule<S extends StageName = StageName> extends RayText {
  readonly stage: S;
  /** Whether pixels may be interpolated without rays of their own: false if the module makes the picture jump, as an edge does. */
  readonly sparesRays: boolean;
  /**
   * Order of convergence with the step length on a smooth field, if the rest of the ray is exact; Infinity if the result does not
   * depend on steps. The order of a ray is the lowest order of its modules.
   */
  readonly order: number;
  /** Data values at which the volume becomes opaque at once, if the module finds them wherever a ray touches them. */
  readonly found?: readonly number[];
  /** Which values can show; all values if absent. It returns the same function while the optics are the same. */
  contributes?(optics: Optics): Contribution;
  /** Its uniforms and textures; it makes the textures when they are needed. */
  inputs(frame: RayFrame): ProgramInputs;
  /** The module in float64, for picks, checks and tests; null if the twin of another module includes it. */
  readonly twin: RayTwin | null;
  /** Returns what casts more rays where the module makes the picture jump, for pictures at rest; absent if the picture does not jump. */
  edges?(): EdgeDrawing;
  /** Delete its textures. */
  dispose?(): void;
}

/** How to cast one more ray for some rows of pixels. */
export interface EdgeCast {
  readonly program: WebGLProgram;
  /** The inputs of a program that draws its box. */
  readonly inputs: ProgramInputs;
  readonly firstRow: number;
  readonly rows: number;
}

/** Draws more rays for those pixels of a picture that an edge runs through. */
export interface EdgeDrawing {
  /** The places of these rays, in order: pixels across and up, from the pixel's middle. */
  readonly offsets: readonly (readonly [number, number])[];
  /**
   * Find the pixels that an edge runs through. Binds the picture's framebuffer, and waits until the GPU has drawn it.
   * @param edgeCurvature - in units of 1/255, see optics/rays/edge-rays.ts
   * @param asPoints - whether the program that casts the rays draws quads of pixels as points
   */
  find(picture: DrawTarget, edgeCurvature: number, asPoints: boolean): void;
  /** Mix one more ray into these pixels of the bound framebuffer. @param number - the index of the ray's offset */
  mix(number: number, cast: EdgeCast): void;
}

/** A volume on the GPU. */
export interface FieldModule extends RayModule<'field'> {
  /** Stored sample = the value of the chunk's `sampleVolume`, times this. */
  readonly storedScale: number;
  /** The bytes that it takes on the GPU. */
  readonly bytes: number;
  /** Further modules of the rays of such a volume; absent if there are none. */
  readonly more?: readonly RayModule[];
  inputs(): ProgramInputs;
  dispose(): void;
}

/** Surfaces in a volume that end rays or cut them. The renderer does not know what kind of surfaces they are. */
export interface SliceModule<Slice = unknown> extends RayModule<'interval'> {
  slices: readonly Slice[];
}

/** Cuts that the author of a page wants, and the function that makes their module: both come from the code that reads the cuts. */
export interface RayCut<Item = unknown> {
  readonly create: (gl: Gl) => SliceModule<Item>;
  readonly items: readonly Item[];
}

/** Ends rays at the scene's shapes. */
export interface SurfacesModule extends RayModule<'interval'> {
  /** Read in which quads of the last lattice the ends of rays can't be interpolated, see optics/rays/depth-jumps.ts. Binds a framebuffer. */
  readJumps(): Pixels;
}

/** Uploads volumes of one kind of grid to the GPU. */
export interface FieldProvider {
  /** @throws {VolumeViewError} `format/too-large` if the volume does not fit the device */
  upload(gl: Gl, volume: VolumeData, device: Device): Upload<FieldModule>;
  /** Absent if such volumes have no slices. */
  createSlices?(gl: Gl): SliceModule;
  /** Loads the code that uploads a second volume on the same grid, which the shader reads together with the first; absent if there is none. */
  second?(): Promise<(gl: Gl, overlay: ShownOverlay, device: Device) => Upload<SecondField>>;
}

/** A second volume on the GPU, which lies over a first one. */
export interface SecondField {
  /** Its field and its appearance in float64. @param overlay - the overlay that is shown */
  twins(overlay: ShownOverlay): { readonly field: RayTwin; readonly look: RayTwin };
  /** The text of a field module that adds `float overlay` to the sample. */
  readonly text: RayText;
  /** The meaning of the chunk's stored value, see `StoredValues` of optics/transfer/share-map.ts. */
  readonly stored: { readonly slope: number; readonly intercept: number; readonly storedScale: number };
  /** Data values that differ by more than this are on two sides of a fold; Infinity if values do not fold. */
  readonly foldFrom: number;
  inputs(over: VolumeData): ProgramInputs;
  dispose(): void;
}

/** A volume's appearance, independent of the view. */
export interface Optics extends OpticalFactors {
  readonly transferFunction: TransferFunction;
  /** World length over which a stop's opacity holds. */
  readonly referenceLength: number;
}

/** How a volume is shown. */
export interface Appearance {
  readonly optics: Optics;
  /** Null for emission and absorption alone. */
  readonly style: RayStyle | null;
}

/** The depths of opaque shapes in a picture. */
export interface ShapeDepths {
  readonly all: DrawTarget;
  /** Depths of the shapes that are neither lines nor points; the same target as `all` if there are no lines and points. */
  readonly solid: DrawTarget;
  /** The part of the picture that the shapes may cover, in device coordinates. */
  readonly bounds: DeviceRectangle;
  /** The same for the shapes that are neither lines nor points; null if there are none. */
  readonly solidBounds: DeviceRectangle | null;
}

/** Pixels of a picture with shapes. */
export interface SurfaceLattice extends PixelLattice {
  /** The picture of the lattice before, from which pixels are interpolated; null or absent if all pixels get rays. */
  readonly half?: unknown;
  /** Whether the lattice is used only to interpolate others: lines and points then end none of its rays. */
  readonly isCoarse?: boolean;
}

/** The scene's opaque shapes, at which rays end. */
export interface Surfaces {
  readonly depths: ShapeDepths;
  readonly projection: Matrix4;
  /** The size of the picture that the shapes were drawn in, in pixels. */
  readonly picture: { readonly width: number; readonly height: number };
  readonly lattice: SurfaceLattice;
  /** World length. */
  readonly stepLength: number;
}

/** All data that a picture is drawn from. */
export interface RayFrame {
  readonly volume: VolumeData;
  readonly field: FieldModule;
  readonly optics: Optics;
  /** Data values that are 0 and 1 of the transfer function's domain. */
  readonly domain: readonly [number, number];
  readonly rays: RaySetup;
  readonly surfaces: Surfaces | null;
  /** Whether a shorter ray shows less (as with absorption, unlike a projection). */
  readonly fades: boolean;
  /** Whether rays skip empty space without sampling it. */
  readonly skipping: boolean;
  /** The maximum number of substeps of a step. */
  readonly maxSubsteps: number;
  /** The sampling that each macrocell needs, see optics/cells/cell-detail.ts; null if it is not known. */
  readonly detail: Uint8Array | null;
  /** The length of a step in voxels of the finest axis; 0 if `detail` is not used. */
  readonly voxelsPerStep: number;
  /** The contributions of all modules that have one. */
  readonly contributions: readonly Contribution[];
}
