import type { ProjectedRays, RayStyle } from '../../optics/rays/ray-style.ts';
import { loadPart } from '../../core/load-part.ts';
import type { Contribution } from '../../optics/cells/empty-space-distance.ts';
import { domainOf } from '../../optics/transfer/emission.ts';
import { isUsual } from '../../optics/transfer/usual-columns.ts';
import type { SceneLights } from '../../optics/transfer/lights.ts';
import { setUpRays } from '../../optics/rays/rays.ts';
import type { RaySetup } from '../../optics/rays/rays.ts';
import { allSubsteps, isCut } from '../../optics/cells/substeps.ts';
import type { Substeps } from '../../optics/cells/substeps.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import type { GridFrame } from '../../volume/grid.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import type { BesideLayer } from './beside-layer.ts';
import type { Device, Gl } from '../device/device.ts';
import type { FieldProviders } from './field-providers.ts';
import { finishUpload, quickBytes } from '../textures/fill-texture.ts';
import type { Upload } from '../textures/fill-texture.ts';
import { joinInputs } from '../device/inputs.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import { askTwoByteFilter } from '../probes/probe-device.ts';
import { chooseModules } from '../ray/choose-modules.ts';
import { listSamplers, maxSamplers } from '../ray/compose-ray.ts';
import type { RayProgram } from '../ray/compose-ray.ts';
import type { Classifiers } from '../ray/modules/classifiers.ts';
import { boxModule } from '../ray/modules/box.ts';
import { cartesianProvider, loadCartesianChunks, prepareCartesian } from '../ray/modules/cartesian-field.ts';
import { createComposite } from '../ray/modules/composite.ts';
import { createTransferFunction } from '../ray/modules/transfer-function.ts';
import type { FieldModule, FieldProvider, Optics, RayCut, RayFrame, RayModule, SliceModule, Surfaces, SurfacesModule } from '../ray/ray-module.ts';
import type { RayTwins } from '../ray/ray-twin.ts';
import type { StyleModules } from '../ray/styles/styles.ts';
import { SeenInLayer } from './seen-in-layer.ts';
import { valueUniforms } from '../ray/uniforms.ts';
import type { View } from '../device/view.ts';

export type { Substeps } from '../../optics/cells/substeps.ts';
export type { SeenVolume } from '../../optics/cells/cell-detail.ts';
export type { FieldProviders } from './field-providers.ts';
export type { View } from '../device/view.ts';

/** A volume on the GPU, what of it is shown, and what it looks like: the modules of its rays, and all that they read. */
export class VolumeLayer {
  readonly #usual: readonly RayModule[];
  #volume: Volume | null = null;
  #field: FieldModule | null = null;
  #polar: FieldProvider | null = null;
  #discrete: FieldProvider | null = null;
  #slices: SliceModule | null = null;
  #style: StyleModules | null = null;
  #styleCalls = 0;
  #beside: BesideLayer | null = null;
  #classifiers: Classifiers | null = null;
  #optics: Optics | null = null;
  #opticsCalls = 0;
  #given: readonly RayModule[] = [];
  readonly #seen = new SeenInLayer();
  /** Surfaces in the volume that end rays; one whose grid knows none has none. */
  slices: readonly unknown[] = [];
  /** What else cuts rays. */
  cuts: readonly RayCut[] = [];
  readonly #cutting = new Map<RayCut['create'], SliceModule>();
  /** Ends rays at other shapes; present as soon as there are some. */
  surfacesModule: SurfacesModule | null = null;
  /** One part of the volume that is shown alone, see volume/region.ts; null for all of it. */
  region: GridFrame | null = null;
  /** What shines on a lit volume; null for a light at the eye. */
  lights: () => SceneLights | null = () => null;
  /** Whether rays cross empty space without looking. */
  skipping = true;
  /** How steps are cut. */
  substeps: Substeps = allSubsteps;

  constructor(readonly gl: Gl, readonly device: Device, readonly providers: FieldProviders = {}) {
    if (!device.webgl2) loadCartesianChunks().catch(() => {}); // The first volume waits for it, and tells.
    this.#usual = [boxModule, createTransferFunction(gl), createComposite(gl, device)];
  }

  get volume(): Volume | null {
    return this.#volume;
  }

  /** Present with the volume. */
  get field(): FieldModule | null {
    return this.#field;
  }

  get optics(): Optics | null {
    return this.#optics;
  }

  /**
   * What the volume looks like. Some transfer functions need a part of the package that is loaded with the first of them.
   * @returns resolves when the next picture shows it; a later call takes its place. Where nothing is loaded it does at once
   * @throws {VolumeViewError} `format/unsupported` where that part of the package is not there
   */
  async setOptics(optics: Optics): Promise<void> {
    const call = ++this.#opticsCalls;
    if (!this.#classifiers && !this.#isUsual(optics)) await this.#loadClassifiers();
    if (call === this.#opticsCalls) this.#optics = optics;
  }

  /**
   * Show a value of each ray, see optics/rays/projection.ts, or light, see optics/rays/lit.ts; null for emission and absorption.
   * @returns resolves when the next picture shows it; a later call takes its place
   * @throws {VolumeViewError} `format/unsupported` where that part of the package is not there
   */
  async setStyle(style: RayStyle | null): Promise<void> {
    const call = ++this.#styleCalls;
    const made = style && (await loadPart(import('../ray/styles/styles.ts').then(({ createStyle }) => createStyle(style, this)), 'draws projections and light'));
    if (call !== this.#styleCalls) return made?.dispose();
    this.#style?.dispose();
    this.#style = made;
  }

  /**
   * Set what there is beside the volume: labels, or a second field. What shows them is loaded with the first of them.
   * @returns resolves when the next picture shows it; a later call takes its place
   * @throws {VolumeViewError} `format/unsupported` where that part of the package is not there, `format/too-large`
   */
  async setBeside(set: (beside: BesideLayer) => Promise<void>): Promise<void> {
    const { BesideLayer } = await loadPart(import('./beside-layer.ts'), 'shows labels and layers');
    await set((this.#beside ??= new BesideLayer(this.gl, this.device, this.providers)));
  }

  /** Modules of others: they stand in for those of a stage that has one, and join those of a stage that has several. */
  setModules(modules: readonly RayModule[]): void {
    this.#given = modules;
  }

  /**
   * Load what only some volumes and some optics need, before they are set.
   * @throws {VolumeViewError} `format/unsupported` where that part of the package is not there
   */
  async prepare(volume: Volume, optics?: Optics): Promise<void> {
    if (optics && !this.#isUsual(optics)) await this.#loadClassifiers();
    if (volume.samples instanceof Uint16Array) await askTwoByteFilter(this.device);
    if (!isPolar(volume)) await prepareCartesian(volume, this.device);
    if (volume.isDiscrete) this.#discrete = (await loadPart(import('./label-layer.ts'), 'shows labels')).discreteProvider;
    const { polar } = this.providers;
    if (isPolar(volume) && !this.#polar && polar) this.#polar = await loadPart(polar(), 'shows radar volumes');
  }

  /** Put a volume on the GPU in place of the one before, at once. */
  set(volume: Volume): void {
    this.#replace(volume, finishUpload(this.#upload(volume)));
  }

  /**
   * The same, bit by bit between frames where the volume is large.
   * @param givenUp - whether it is still wanted
   * @returns whether it is in place; not where it was given up or the context was lost
   * @throws {VolumeViewError} `format/unsupported` where that part of the package is not there
   */
  async bring(volume: Volume, givenUp: () => boolean): Promise<boolean> {
    const upload = this.#upload(volume);
    // It may have been lost long before, while the volume was on its way: that too is found out between frames.
    const slow = (volume.samples.byteLength > quickBytes || this.gl.isContextLost()) && (await loadPart(import('../textures/upload-gradually.ts'), 'uploads large volumes'));
    const field = slow ? await slow.uploadGradually(this.gl, upload, givenUp) : finishUpload(upload);
    if (field) this.#replace(volume, field);
    return field !== null;
  }

  #upload(volume: Volume): Upload<FieldModule> {
    return this.#providerOf(volume).upload(this.gl, volume, this.device);
  }

  #providerOf(volume: Volume): FieldProvider {
    const provider = isPolar(volume) ? this.#polar : volume.isDiscrete ? this.#discrete : cartesianProvider;
    if (!provider) throw new TypeError('prepare() was not awaited');
    return provider;
  }

  #replace(volume: Volume, field: FieldModule): void {
    this.#field?.dispose();
    this.#field = field;
    this.#volume = volume;
  }

  /** The modules of a ray; there has to be a volume. @param surfaces - whether shapes end rays @param looks - whether rays look for what is opaque at once: where steps are cut, as at rest */
  modules(surfaces: boolean, looks = isCut(this.substeps)): readonly RayModule[] {
    const ends = [...(surfaces ? [this.surfacesModule!] : []), ...this.cuts.map((cut) => this.#moduleOf(cut)), ...this.#slicesOf(this.#volume!)];
    const own = [this.#field!, ...this.#usual.slice(0, 1), ...ends, ...this.#usual.slice(1), ...this.#classifying(looks)];
    const beside = chooseModules([...own, ...(this.#beside?.modules(this) ?? [])]);
    const all = this.#beside?.fit(beside) ?? beside;
    return chooseModules([...all, ...(this.#style?.modules(all) ?? []), ...this.#given]);
  }

  /** The same rays as they are cast in float64; null without a volume or optics. It tells of these also when the layer is gone. @param surfaces and @param looks - as `modules` */
  twins(surfaces: boolean, looks?: boolean): RayTwins | null {
    if (!this.#volume || !this.#optics) return null;
    const modules = this.modules(surfaces, looks).map(({ name, stage, members, twin }) => ({ name, stage, members, twin }));
    return { volume: this.#volume, optics: this.#optics, modules };
  }

  async #loadClassifiers(): Promise<void> {
    const { Classifiers } = await loadPart(import('../ray/modules/classifiers.ts'), 'shows any transfer function');
    this.#classifiers ??= new Classifiers(this.gl, this.device);
  }

  #isUsual({ transferFunction }: Optics): boolean {
    return this.device.floatLinear && isUsual(transferFunction);
  }

  /** Stand in for the usual table where that does not hold the transfer function. */
  #classifying(looks: boolean): readonly RayModule[] {
    const optics = this.#optics;
    return !optics || this.#isUsual(optics) ? [] : this.#classifiers!.modulesFor(this.#volume!, this.#field!, optics, looks);
  }

  #slicesOf(volume: Volume): SliceModule[] {
    if (this.slices.length === 0) return [];
    const { createSlices } = this.#providerOf(volume);
    if (!createSlices) return [];
    this.#slices ??= createSlices(this.gl);
    this.#slices.slices = this.slices;
    return [this.#slices];
  }

  #moduleOf({ create, items }: RayCut): SliceModule {
    const module = this.#cutting.get(create) ?? create(this.gl);
    this.#cutting.set(create, module);
    module.slices = items;
    return module;
  }

  /** What casts its rays; there has to be a volume. @param surfaces - whether shapes end rays */
  program(surfaces: boolean): RayProgram {
    const modules = this.modules(surfaces);
    const { webgl2, quadPoints } = this.device;
    const adaptive = quadPoints && modules.every(({ sparesRays }) => sparesRays) && listSamplers({ adaptive: true, modules }).length <= maxSamplers(webgl2);
    return { webgl2, adaptive, substeps: this.substeps.most > 1 && !modules.some(({ walk }) => walk), modules };
  }

  /** How finely each macrocell is sampled at the least; null where steps are cut by what is at their ends alone. */
  detail(): Uint8Array | null {
    return this.#seen.detail(this.substeps, () => this.whatIsSeen());
  }

  /** Whether substeps make any difference to what rays come to. */
  get cutsSteps(): boolean {
    return !this.#style?.projects;
  }

  /** Whether rays at rest are walked from one plane of voxels to the next, so that steps are never cut by what is at their ends. */
  get walksVoxels(): boolean {
    return this.#volume !== null && this.modules(false, true).some(({ walk }) => walk);
  }

  /** How rays show values of their own, as far as steps are now cut; null where they show what shines and absorbs. */
  get projection(): ProjectedRays | null {
    if (this.cutsSteps) return null;
    return { isExact: this.modules(false).some(({ walk }) => walk), hasValuesBetween: !this.#volume?.isDiscrete };
  }

  /** In which macrocells something can be seen, and what; null without a volume or optics. */
  whatIsSeen(): SeenVolume | null {
    const volume = this.#volume;
    if (!volume || !this.optics) return null;
    // A projection may show any value.
    const contributions = this.cutsSteps ? this.#contributions(this.modules(false)) : [];
    const optics = this.optics;
    return this.#seen.find(this.#opened, optics, contributions, {
      shown: [this.#beside?.shown, this.#style],
      more: (seen) => {
        const looks = this.modules(false, true).some(({ name }) => name === 'jumps');
        const own = this.#beside?.more(volume, seen, optics);
        const more = looks ? { ...own, found: this.#classifiers!.jumpsOf(volume, optics) } : own;
        return this.#style?.seen ? this.#style.seen(more, { volume, ...optics }) : more;
      },
    });
  }

  #contributions(modules: readonly RayModule[]): readonly Contribution[] {
    const own = this.#style?.contributions?.(modules, this.optics!);
    const all = own ?? modules.map((module) => module.contributes?.(this.optics!)).filter((one): one is Contribution => one !== undefined);
    return this.#beside?.widen(this.#volume!, all) ?? all;
  }

  /** The volume as what skips empty space sees it. */
  get #opened(): Volume {
    return this.#beside?.open(this.#volume!) ?? this.#volume!;
  }

  /** The rays of a view, or null without a volume, and where the grid is singular. */
  raysOf({ view, projection }: View): RaySetup | null {
    return this.#volume && setUpRays(this.#volume.grid, view, projection, this.region);
  }

  /**
   * What the program reads but for the rays themselves; there have to be a volume and optics.
   * @param surfaces - null where no shapes end rays
   */
  inputs(rays: RaySetup, surfaces: Surfaces | null): ProgramInputs {
    const modules = this.modules(surfaces !== null);
    const optics = this.#optics!;
    const detail = this.detail() ?? this.#seen.lastDetail; // What is known already does no harm.
    const frame: RayFrame = {
      volume: this.#opened,
      field: this.#field!,
      optics,
      domain: domainOf(optics.transferFunction),
      rays,
      surfaces,
      fades: this.cutsSteps,
      skipping: this.skipping,
      maxSubsteps: this.substeps.most,
      detail,
      voxelsPerStep: this.substeps.voxelsPerStep,
      contributions: this.#contributions(modules),
    };
    return joinInputs({ uniforms: valueUniforms(frame), units: [] }, ...modules.map((module) => module.inputs(frame)));
  }

  dispose(): void {
    this.#field?.dispose();
    this.#field = null;
    for (const module of [...this.#usual, this.#slices, ...this.#cutting.values(), this.#style, this.#classifiers, this.#beside]) module?.dispose?.();
  }
}
