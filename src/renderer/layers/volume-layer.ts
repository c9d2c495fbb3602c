import { isSameStyle } from '../../optics/rays/ray-style.ts';
import type { ProjectedRays, RayStyle } from '../../optics/rays/ray-style.ts';
import { loadPart } from '../../core/load-part.ts';
import type { Contribution } from '../../optics/cells/empty-space-distance.ts';
import { domainOf } from '../../optics/transfer/emission.ts';
import { isUsual } from '../../optics/transfer/usual-columns.ts';
import type { SceneLights } from '../../optics/transfer/lights.ts';
import { setUpRays } from '../../optics/rays/rays.ts';
import type { RaySetup } from '../../optics/rays/rays.ts';
import { isCut, wholeSteps } from '../../optics/cells/substeps.ts';
import type { Substeps } from '../../optics/cells/substeps.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import { isPolar } from '../../volume/volume.ts';
import type { VolumeData } from '../../volume/volume.ts';
import type { AttachedLayers } from './attached-layers.ts';
import type { Device, Gl } from '../device/device.ts';
import type { FieldProviders } from './field-providers.ts';
import { finishUpload, quickBytes } from '../textures/fill-texture.ts';
import type { Upload } from '../textures/fill-texture.ts';
import { joinInputs } from '../device/inputs.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import { chooseModules } from '../ray/choose-modules.ts';
import { listSamplers, maxSamplers } from '../ray/compose-ray.ts';
import type { RayProgram } from '../ray/compose-ray.ts';
import type { Classifiers } from '../ray/modules/classifiers.ts';
import { boxModule } from '../ray/modules/box.ts';
import { cartesianProvider, loadCartesianChunks, prepareCartesian } from '../ray/modules/cartesian-field.ts';
import { createComposite } from '../ray/modules/composite.ts';
import { createTransferFunction } from '../ray/modules/transfer-function.ts';
import type {
  Appearance,
  FieldModule,
  FieldProvider,
  Optics,
  RayCut,
  RayFrame,
  RayModule,
  SliceModule,
  Surfaces,
  SurfacesModule,
} from '../ray/ray-module.ts';
import { plainRays } from '../ray/ray-plan.ts';
import type { RayPlan } from '../ray/ray-plan.ts';
import type { RayTwins } from '../ray/ray-twin.ts';
import type { StyleModules } from '../ray/styles/styles.ts';
import { SeenInLayer } from './seen-in-layer.ts';
import { valueUniforms } from '../ray/uniforms.ts';
import type { View } from '../device/view.ts';

export type { Substeps } from '../../optics/cells/substeps.ts';
export type { SeenVolume } from '../../optics/cells/cell-detail.ts';
export type { FieldProviders } from './field-providers.ts';
export type { View } from '../device/view.ts';

/** A volume on the GPU, which part of it is shown, and its appearance: the modules of its rays, and all inputs that they read. */
export class VolumeLayer {
  readonly #usual: readonly RayModule[];
  #volume: VolumeData | null = null;
  #field: FieldModule | null = null;
  #polar: FieldProvider | null = null;
  /** Of volumes of labels, and of several channels. */
  #rare: FieldProvider | null = null;
  #slices: SliceModule | null = null;
  #style: StyleModules | null = null;
  #shownStyle: RayStyle | null = null;
  /** The last appearance that was set: what of it has to be loaded is shown later. */
  #asked: Partial<Appearance> = {};
  /** The grid of the last volume for which code was loaded: it is set, or will be. */
  #prepared: Pick<VolumeData, 'grid'> | null = null;
  #attached: AttachedLayers | null = null;
  #classifiers: Classifiers | null = null;
  #optics: Optics | null = null;
  #given: readonly RayModule[] = [];
  readonly #seen = new SeenInLayer();
  /** How the rays of the next picture are cast, and what cuts them. */
  plan: RayPlan = plainRays;
  readonly #cutting = new Map<RayCut['create'], SliceModule>();
  /** The module that ends rays at the scene's shapes; present as soon as the scene has some. */
  surfacesModule: SurfacesModule | null = null;
  /** The lights on a lit volume; null for a light at the eye. */
  lights: () => SceneLights | null = () => null;
  /** Whether rays skip empty space without sampling it. */
  skipping = true;

  constructor(
    readonly gl: Gl,
    readonly device: Device,
    readonly providers: FieldProviders = {},
  ) {
    if (!device.webgl2) loadCartesianChunks().catch(() => {}); // The first volume waits for the same part, and reports the failure.
    this.#usual = [boxModule, createTransferFunction(gl), createComposite(gl, device)];
  }

  /** With the values that are there now of its finer voxels: another object when these have changed, so that what is made of them is made again. */
  get volume(): VolumeData | null {
    return this.#volume?.finer?.current(this.#volume) ?? this.#volume;
  }

  /** Null until there is a volume. */
  get field(): FieldModule | null {
    return this.#field;
  }

  get optics(): Optics | null {
    return this.#optics;
  }

  /**
   * Set how the volume is shown; what is not given stays. Some transfer functions and all styles need a part of the package, which the first of them loads.
   * All of a call is shown by the same picture.
   * @returns resolves when the next picture will show it; a later call shows what it gives in addition. It resolves at once if nothing has to be loaded
   * @throws {VolumeViewError} `format/unsupported` if that part of the package is missing
   */
  async setAppearance(given: Partial<Appearance>): Promise<void> {
    const asked = (this.#asked = { ...this.#asked, ...given });
    const { optics, style = null } = asked;
    const made = isSameStyle(style, this.#shownStyle) ? this.#style : await this.#makeStyle(style);
    if (optics && !this.#classifiers && !this.#isUsual(optics)) await this.#loadClassifiers();
    const isNew = made !== this.#style;
    if (asked !== this.#asked) {
      if (isNew) made?.dispose();
      return;
    }
    this.#optics = optics ?? null;
    if (!isNew) return;
    this.#style?.dispose();
    [this.#style, this.#shownStyle] = [made, style];
  }

  async #makeStyle(style: RayStyle | null): Promise<StyleModules | null> {
    if (!style) return null;
    const made = await loadPart(
      import('../ray/styles/styles.ts').then(({ createStyle }) => createStyle(style, this)),
      'reads styles',
    );
    await this.#prepareStyle(made);
    return made;
  }

  async #prepareStyle(style: StyleModules): Promise<void> {
    const prepared = this.#prepared;
    if (!prepared) return;
    await style.prepare?.(prepared);
    if (prepared !== this.#prepared) await this.#prepareStyle(style); // Another volume was prepared meanwhile.
  }

  /**
   * Set what is attached to the volume: labels, or a second field. The first of them loads the code that shows them.
   * @returns resolves when the next picture will show it; a later call replaces this one
   * @throws {VolumeViewError} `format/unsupported` if that part of the package is missing, `format/too-large`
   */
  async setAttached(set: (attached: AttachedLayers) => Promise<void>): Promise<void> {
    const { AttachedLayers } = await loadPart(import('./attached-layers.ts'), 'shows labels');
    await set((this.#attached ??= new AttachedLayers(this.gl, this.device, this.providers)));
  }

  /** Modules from outside: one replaces the layer's module of a stage that has one module, and is added to a stage that has several. */
  setModules(modules: readonly RayModule[]): void {
    this.#given = modules;
  }

  /**
   * Load the code that only some volumes and some optics need, before they are set.
   * @throws {VolumeViewError} `format/unsupported` if that part of the package is missing
   */
  async prepare(volume: VolumeData, optics?: Optics): Promise<void> {
    this.#prepared = { grid: volume.grid };
    await this.#style?.prepare?.(volume);
    if (optics && !this.#isUsual(optics)) await this.#loadClassifiers();
    if (!isPolar(volume)) await prepareCartesian(volume, this.device);
    if (volume.isDiscrete || volume.channels)
      this.#rare = (await loadPart(import('./label-layer.ts'), 'shows labels')).rareProvider;
    const { polar } = this.providers;
    if (isPolar(volume) && !this.#polar && polar) this.#polar = await loadPart(polar(), 'shows radars');
  }

  /** Upload a volume to the GPU at once; it replaces the previous volume. */
  set(volume: VolumeData): void {
    this.#replace(volume, finishUpload(this.#upload(volume)));
  }

  /**
   * The same as `set`, but a large volume is uploaded piece by piece between frames.
   * @param givenUp - returns true if the volume is no longer wanted
   * @returns true if the volume is in place; false if it was given up or the context was lost
   * @throws {VolumeViewError} `format/unsupported` if that part of the package is missing
   */
  async bring(volume: VolumeData, givenUp: () => boolean): Promise<boolean> {
    const upload = this.#upload(volume);
    // The context may have been lost long before, while the volume was loading: the gradual upload finds that out too.
    const slow =
      (volume.samples.byteLength > quickBytes || this.gl.isContextLost()) &&
      (await loadPart(import('../textures/upload-gradually.ts'), 'reads volumes'));
    const field = slow ? await slow.uploadGradually(this.gl, upload, givenUp) : finishUpload(upload);
    if (field) this.#replace(volume, field);
    return field !== null;
  }

  #upload(volume: VolumeData): Upload<FieldModule> {
    return this.#providerOf(volume).upload(this.gl, volume, this.device);
  }

  #providerOf(volume: VolumeData): FieldProvider {
    const provider =
      (volume.finer as FieldProvider | undefined) ??
      (isPolar(volume) ? this.#polar : volume.isDiscrete || volume.channels ? this.#rare : cartesianProvider);
    if (!provider) throw new TypeError('await prepare()');
    return provider;
  }

  #replace(volume: VolumeData, field: FieldModule): void {
    this.#field?.dispose();
    this.#field = field;
    this.#volume = volume;
  }

  /**
   * The modules of a ray; there has to be a volume.
   * @param surfaces - whether shapes end rays
   * @param looks - whether rays search for values at which the volume suddenly becomes opaque: they do where steps are cut, as at rest
   */
  modules(surfaces: boolean, looks = isCut(this.plan.substeps)): readonly RayModule[] {
    const ends = [
      ...(surfaces ? [this.surfacesModule!] : []),
      ...this.plan.cuts.map((cut) => this.#moduleOf(cut)),
      ...this.#slicesOf(this.#volume!),
    ];
    const own = [
      this.#field!,
      ...(this.#field!.more ?? []),
      ...this.#usual.slice(0, 1),
      ...ends,
      ...this.#usual.slice(1),
      ...this.#classifying(looks),
    ];
    const attached = chooseModules([...own, ...(this.#attached?.modules(this) ?? [])]);
    const all = this.#attached?.fit(attached) ?? attached;
    return chooseModules([...all, ...(this.#style?.modules(all) ?? []), ...this.#given]);
  }

  /**
   * The same rays, to be cast in float64; null without a volume or optics. The result stays valid after the layer is disposed.
   * @param surfaces and @param looks - as for `modules`
   */
  twins(surfaces: boolean, looks?: boolean): RayTwins | null {
    if (!this.#volume || !this.#optics) return null;
    const modules = this.modules(surfaces, looks).map(({ name, stage, members, twin }) => ({
      name,
      stage,
      members,
      twin,
    }));
    return { volume: this.#volume, optics: this.#optics, region: this.plan.region, modules };
  }

  async #loadClassifiers(): Promise<void> {
    const { Classifiers } = await loadPart(import('../ray/modules/classifiers.ts'), 'shows functions');
    this.#classifiers ??= new Classifiers(this.gl, this.device);
  }

  #isUsual({ transferFunction }: Optics): boolean {
    return this.device.floatLinear && isUsual(transferFunction);
  }

  /** Modules that replace the usual table if it can't hold the transfer function. */
  #classifying(looks: boolean): readonly RayModule[] {
    const optics = this.#optics;
    return !optics || this.#isUsual(optics)
      ? []
      : this.#classifiers!.modulesFor(this.volume!, this.#field!, optics, looks);
  }

  #slicesOf(volume: VolumeData): SliceModule[] {
    const { slices } = this.plan;
    if (slices.length === 0) return [];
    const { createSlices } = this.#providerOf(volume);
    if (!createSlices) return [];
    this.#slices ??= createSlices(this.gl);
    this.#slices.slices = slices;
    return [this.#slices];
  }

  #moduleOf({ create, items }: RayCut): SliceModule {
    const module = this.#cutting.get(create) ?? create(this.gl);
    this.#cutting.set(create, module);
    module.slices = items;
    return module;
  }

  /** The program that casts the layer's rays; there has to be a volume. @param surfaces - whether shapes end rays */
  program(surfaces: boolean): RayProgram {
    const modules = this.modules(surfaces);
    const { webgl2, quadPoints } = this.device;
    const adaptive =
      quadPoints &&
      modules.every(({ sparesRays }) => sparesRays) &&
      listSamplers({ adaptive: true, modules }).length <= maxSamplers(webgl2);
    const { max, long } = modules.some(({ walk }) => walk) ? wholeSteps : this.plan.substeps;
    return { webgl2, adaptive, substeps: max > 1, long, modules };
  }

  /** The minimum sampling of each macrocell; null if only the samples at a step's ends decide how it is cut. @param substeps - how steps are cut */
  detail(substeps = this.plan.substeps): Uint8Array | null {
    return this.#seen.detail(substeps, () => this.whatIsSeen());
  }

  /** Whether substeps can change the result of a ray. */
  get cutsSteps(): boolean {
    return !this.#style?.projects;
  }

  /** Whether rays at rest go from one plane of voxels to the next, so that the samples at a step's ends never cut it. */
  get walksVoxels(): boolean {
    return !!this.#volume && this.modules(false, true).some(({ walk }) => walk);
  }

  /** How rays project values; null where rays show emission and absorption. @param substeps - how steps are cut */
  projection(substeps: Substeps): ProjectedRays | null {
    if (this.cutsSteps) return null;
    const isExact = this.with({ substeps }, () => this.modules(false)).some(({ walk }) => walk);
    return { isExact, hasValuesBetween: !this.#volume?.isDiscrete };
  }

  /** Do something with rays that differ from the plan, which then holds again. */
  with<T>(rays: Partial<RayPlan>, work: () => T): T {
    const { plan } = this;
    this.plan = { ...plan, ...rays };
    try {
      return work();
    } finally {
      this.plan = plan;
    }
  }

  /** Which macrocells show something, and what they show; null without a volume or optics. */
  whatIsSeen(): SeenVolume | null {
    const { volume, optics } = this;
    if (!volume || !optics) return null;
    // A projection may show any value.
    const contributions = this.cutsSteps ? this.#contributions(this.modules(false)) : [];
    return this.#seen.find(this.#opened, optics, contributions, {
      shown: [this.#attached?.shown, this.#style],
      more: (seen) => {
        const { found } = this.modules(false, true).find(({ stage }) => stage === 'gather')!;
        const own = this.#attached?.more(volume, seen, optics);
        const more = found ? { ...own, found } : own;
        return this.#style?.seen ? this.#style.seen(more, { volume, ...optics }) : more;
      },
    });
  }

  #contributions(modules: readonly RayModule[]): readonly Contribution[] {
    const own = this.#style?.contributions?.(modules, this.optics!);
    const all =
      own ??
      modules
        .map((module) => module.contributes?.(this.optics!))
        .filter((one): one is Contribution => one !== undefined);
    return this.#attached?.widen(this.volume!, all) ?? all;
  }

  /** The volume as the code that skips empty space reads it. */
  get #opened(): VolumeData {
    const volume = this.volume!;
    return this.#attached?.open(volume) ?? volume;
  }

  /** The rays of a view; null without a volume, or if the grid is singular. */
  raysOf({ view, projection }: View): RaySetup | null {
    return this.#volume && setUpRays(this.#volume.grid, view, projection, this.plan.region);
  }

  /**
   * All inputs of the program except the rays themselves; there have to be a volume and optics.
   * @param surfaces - null if no shapes end rays
   */
  inputs(rays: RaySetup, surfaces: Surfaces | null): ProgramInputs {
    const modules = this.modules(surfaces !== null);
    const optics = this.#optics!;
    const { substeps, change } = this.plan;
    const detail = this.detail() ?? this.#seen.lastDetail; // To use a detail that is already known does no harm.
    const frame: RayFrame = {
      volume: this.#opened,
      field: this.#field!,
      optics,
      domain: domainOf(optics.transferFunction),
      rays,
      surfaces,
      fades: this.cutsSteps,
      skipping: this.skipping,
      maxSubsteps: substeps.max,
      detail,
      voxelsPerStep: substeps.voxelsPerStep,
      contributions: this.#contributions(modules),
    };
    const all = joinInputs(
      { uniforms: valueUniforms(frame), units: [] },
      ...modules.map((module) => module.inputs(frame)),
    );
    return change ? change(all) : all;
  }

  dispose(): void {
    this.#field?.dispose();
    this.#field = null;
    for (const module of [
      ...this.#usual,
      this.#slices,
      ...this.#cutting.values(),
      this.#style,
      this.#classifiers,
      this.#attached,
    ])
      module?.dispose?.();
  }
}
