import { html, nothing } from 'lit';
import type { LitElement, PropertyValues } from 'lit';
import { query, state } from 'lit/decorators.js';
import type { VolumeViewError } from '../src/errors.ts';
import type { ScanTarget } from '../src/formats/choose-scan.ts';
import type { CoarseVolume, LoadProgress, LoadProgressListener } from '../src/formats/load-request.ts';
import type { Volume } from '../src/volume/volume.ts';
import { deviceLimits } from '../src/renderer/device.ts';
import { probeDevice } from '../src/renderer/probe-device.ts';
import { CameraInput } from '../src/viewer/camera-input.ts';
import { CutReader, watchSlices } from '../src/viewer/cuts.ts';
import type { Cuts } from '../src/viewer/cuts.ts';
import { ErrorBoard } from '../src/viewer/error-board.ts';
import type { Aspect } from '../src/viewer/error-board.ts';
import { loads } from '../src/viewer/load-queue.ts';
import { openSource } from '../src/viewer/open-source.ts';
import { PageWatcher } from '../src/viewer/page-watcher.ts';
import { Presence } from '../src/viewer/presence.ts';
import { followModel } from '../src/viewer/scan-model.ts';
import type { ScanModel } from '../src/viewer/scan-model.ts';
import type { ScanPlayer } from '../src/viewer/scan-player.ts';
import { readCamera, readOptics, readPlay, readQuality, readSource, readTime, sourceAttributes, toVolumeViewError } from '../src/viewer/settings.ts';
import { sharedVolumes } from '../src/viewer/shared-volumes.ts';
import { Viewer } from '../src/viewer/viewer.ts';
import type { RenderStats } from '../src/viewer/render-stats.ts';
import type { TimeChangeDetail } from '../src/viewer/scan-player.ts';
import { x3dScenes } from './x3d-scenes.ts';
import { VolumeViewAttributes } from './volume-view-attributes.ts';
import { describeVolume } from '../src/viewer/volume-info.ts';
import type { VolumeInfo, VolumeOptics } from '../src/viewer/volume-info.ts';
import type { VolumeViewListeners } from './volume-view-events.ts';
import { describeProgress, renderError, renderPoster, renderProgress } from './volume-view-parts.ts';
import { styles } from './volume-view-styles.ts';

/** Volumes of fewer bytes than this are not made smaller where the GPU's memory is full: it would not help. */
const minReduced = 2 ** 20;

/**
 * A volume in the page: a CT, an MRI or any other scan, drawn with correct opacity, turning under mouse, finger and
 * keys. X3D elements between the tags (`<shape>`, `<viewpoint>`, `<directionallight>` ...) are live parts of the scene.
 *
 * @tag volume-view
 * @slot - X3D elements that join the scene, and `<volume-slice>` elements that cut a radar scan
 * @slot poster - what stands there until the first picture, instead of the `poster` image
 * @slot progress - what is shown while a file loads, instead of the bar
 * @slot error - what is shown when something failed, instead of the message
 * @csspart picture - the picture, which takes the focus
 * @csspart poster - the poster image
 * @csspart progress - around the progress bar
 * @csspart error - around the error message
 * @cssproperty --volume-view-focus-color - colour of the frame around the picture that has the focus
 * @cssproperty --volume-view-progress-color - colour of the progress bar
 * @cssproperty --volume-view-error-background - what is behind an error message
 * @cssproperty --volume-view-error-color - its colour
 * @cssproperty --volume-view-label-color - colour of the labels of rings
 * @fires {CustomEvent<VolumeInfo>} load - a volume has been loaded; the detail describes it
 * @fires {CustomEvent<ProgressDetail>} progress - bytes came in or were decoded
 * @fires {CustomEvent<ErrorDetail>} error - something failed; the last good picture stays
 * @fires {CustomEvent<CameraChangeDetail>} camera-change - a person moved the camera; after each frame of the movement
 * @fires {CustomEvent<VolumeOptics | null>} optics-change - the volume looks otherwise; null where it is gone
 * @fires {CustomEvent<RenderStats>} render - a frame has been drawn
 * @fires {CustomEvent<TimeChangeDetail>} time-change - of several scans, another one is in the picture
 * @fires {CustomEvent<null>} scans-change - the scans, what is known of their times, whether they play or one is waited for, is otherwise
 */
// oxlint-disable-next-line typescript/no-unsafe-declaration-merging -- only overloads are merged in, see below
export class VolumeView extends VolumeViewAttributes {
  static override readonly styles = styles;

  @state() private _progress: LoadProgress | null = null;
  @state() private _hasPicture = false;
  @state() private _shownError: VolumeViewError | null = null;

  @query('.picture') private readonly _picture!: HTMLElement;
  @query('.scene') private readonly _sceneHost!: HTMLElement;

  #volume: Volume | null = null;
  /** What of several scans stays from one to the next. */
  #model: ScanModel | null = null;
  /** null where the source is a single volume, or not open yet. */
  #scans: ScanPlayer | null = null;
  /** Whether the volume is that of the present `src`, and not one that stays because there is none better. */
  #isCurrent = false;
  #info: VolumeInfo | null = null;
  #optics: VolumeOptics | null = null;
  #stats: RenderStats | null = null;
  #stage: Viewer | null = null;
  #input: CameraInput | null = null;
  #loading: AbortController | null = null;
  /** The last time that the optics were read, or should have been. */
  #reading = new AbortController();
  #work: Promise<void> = Promise.resolve();
  /** Bytes of samples that the GPU had memory for, as far as it is known. */
  #maxBytes = Infinity;
  /** Settles when the coarse picture of a volume on its way is as good as there. */
  #standIn: Promise<void> = Promise.resolve();
  /** What waits until the element comes near the visible part of the page, or a script asks for its picture. */
  #putOff: (() => void) | null = null;
  readonly #watcher = new PageWatcher();
  readonly #presence = new Presence(() => this.#onPresence());
  readonly #errors = new ErrorBoard({
    show: (error) => (this._shownError = error),
    told: (aspect, error) => this.#told(aspect, error),
  });
  readonly #cuts = new CutReader(this, this.#errors);

  /** The loaded volume: dimensions, spacing, unit, value range, format ...; null before it is there. */
  get volume(): VolumeInfo | null {
    return this.#info;
  }

  /** What it looks like: the transfer function's stops, the window, the factors; null before there is a volume. */
  get optics(): VolumeOptics | null {
    return this.#optics;
  }

  /** The last drawn frame; null before the first. */
  get renderStats(): RenderStats | null {
    return this.#stats;
  }

  /** When the scans of the source began, ISO 8601 in UTC, one for each; null for one of which it is not known, or not yet. */
  get times(): readonly (string | null)[] {
    if (this.#scans) return this.#scans.times;
    return this.#volume && this.#isCurrent ? [this.#volume.radar?.time ?? null] : [];
  }

  /** The scan in the picture, a single volume being the first of one; null before there is a picture. */
  get scan(): TimeChangeDetail | null {
    if (this.#scans) return this.#scans.shown;
    const [time] = this.times;
    return time === undefined ? null : { index: 0, time, count: 1 };
  }

  /** Whether one of several scans has been asked for and is not in the picture yet. */
  get waiting(): boolean {
    return this.#scans?.waiting ?? false;
  }

  /** Show the next scan. Returns whether there is one; after the last there is none. */
  next(): boolean {
    return this.#scans?.step(1) ?? false;
  }

  /** Show the previous scan. Returns whether there is one. */
  previous(): boolean {
    return this.#scans?.step(-1) ?? false;
  }

  /**
   * Resolves when the picture for the present attributes has been drawn and is final; rejects with the error that the
   * element shows where there will be none. To ask for it loads and draws what is far from the visible part of the page.
   */
  get renderComplete(): Promise<void> {
    return this.#presence.ask(() => this.#settle());
  }

  /** Draw one frame now with the present settings; resolves when the GPU has finished it. */
  async redraw(): Promise<RenderStats> {
    return this.#presence.ask(async () => {
      await this.#settleWork();
      return this.#requireStage().redraw();
    });
  }

  /**
   * The picture as a file.
   * @param options - `type`: 'image/png' (default), 'image/webp' or 'image/jpeg'; `width` and `height` in pixels, by
   *   default the picture's own
   */
  async toBlob(options: { type?: string; width?: number; height?: number } = {}): Promise<Blob> {
    const { type = 'image/png', width, height } = options;
    return this.#presence.ask(async () => {
      await this.#settle();
      return this.#requireStage().toBlob(type, { width, height });
    });
  }

  override connectedCallback(): void {
    super.connectedCallback();
    if (this.hasUpdated) this.#enter();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    // Being moved within the page takes an element out and puts it back at once: only a real goodbye takes it down.
    queueMicrotask(() => {
      if (!this.isConnected) this.#leave();
    });
  }

  protected override updated(changed: PropertyValues<this>): void {
    if (!this.#stage && this.isConnected) return this.#enter(); // The first time: it reads all attributes.
    const any = (...names: (keyof VolumeView)[]) => names.some((name) => changed.has(name));
    if (any('loading')) this.#onPresence();
    if (any('src', ...sourceAttributes)) this.#load();
    else {
      if (any('time')) this.#seek();
      if (any('transferFunction', 'window', 'referenceLength', 'opacityFactor', 'lightFactor')) this.#queueOptics();
    }
    if (any('play', 'playSpeed')) this.#readPlay();
    if (any('cameraOrbit', 'cameraTarget', 'fieldOfView')) this.#readCamera();
    if (any('steps', 'maxError', 'targetFps')) this.#readSteps();
    if (any('region', 'rings')) this.#cutAnew();
    if (any('cameraControls')) this.#setUpInput();
  }

  protected override render(): unknown {
    const controls = this.#controlsOn();
    const decorative = this.alt === '' && !controls;
    const label = (this.alt ?? this.#info?.title) || 'Volume picture';
    return html`
      <div
        class="picture"
        part="picture"
        role=${decorative ? 'presentation' : 'img'}
        aria-label=${decorative ? nothing : label}
        aria-describedby=${controls ? 'keys' : nothing}
        tabindex=${controls ? '0' : nothing}
      >
        <div class="scene"></div>
      </div>
      ${this._hasPicture ? nothing : renderPoster(this.poster)}
      ${this._progress && !this._shownError ? renderProgress(this._progress) : nothing}
      ${this._shownError ? renderError(this._shownError) : nothing}
      <div class="status" role="status">${this.#status()}</div>
      <div class="status" id="keys" hidden>Arrow keys turn it, plus and minus zoom, 0 goes back to the first view.</div>
    `;
  }

  #status(): string {
    if (this._shownError) return '';
    if (this._progress) return describeProgress(this._progress);
    return this._hasPicture ? 'Loaded' : '';
  }

  #controlsOn(): boolean {
    return this.cameraControls?.trim().toLowerCase() !== 'off';
  }

  /** The element has come into a page. */
  #enter(): void {
    if (this.#stage) return;
    this.#stage = new Viewer({ host: this, container: this._sceneHost, presence: this.#presence, scenes: x3dScenes }, {
      rendered: (stats) => this.#onRendered(stats),
      cameraMoved: () => this.#onCameraMoved(),
      failed: (error) => this.#errors.report('scene', toVolumeViewError(error)),
    });
    this.#readCamera();
    this.#readSteps();
    this.#setUpInput();
    this.#observe();
    if (this.#scans && this.#isCurrent) this.#seek();
    else if (this.#volume && (this.#isCurrent || !this.src)) this.#queueOptics(this.#volume);
    else this.#load();
  }

  /** The element has left its page: nothing of it may go on or hold the GPU. */
  #leave(): void {
    this.#loading?.abort();
    this.#loading = null;
    this.#putOff = null;
    this.#scans?.stop();
    this.#input?.dispose();
    this.#input = null;
    this.#stage?.dispose();
    this.#stage = null;
    this.#watcher.disconnect();
    sharedVolumes.release(this);
    this._progress = null;
    this._hasPicture = false;
  }

  /** Without a source there is no picture, as with an image; the poster is back. */
  #empty(): void {
    this.#volume = null;
    this.#model = null;
    this.#info = null;
    this.#stats = null;
    this.#tellOptics(null);
    if (!this.#stage) return;
    this.#leave();
    this.#enter();
  }

  #observe(): void {
    this.#watcher.watchSize(this, () => this.#stage?.invalidate());
    this.#watcher.add(watchSlices(this, () => this.#cutAnew()));
    this.#presence.watch(this, this.#watcher);
  }

  /** Whether it may load. */
  get #awake(): boolean {
    return this.#presence.awake || this.loading?.toLowerCase() === 'eager';
  }

  /** It came nearer or went away: what was put off is done now, or what is under way is put off. */
  #onPresence(): void {
    if (this.#awake) {
      const act = this.#putOff;
      this.#putOff = null;
      act?.();
    } else if (this.#loading) {
      this.#loading.abort();
      this.#loading = null;
      this.#scans?.stop();
      this._progress = null;
      this.#putOff = () => (this.#isCurrent ? this.#seek() : this.#load());
    }
    this.#stage?.followPresence();
  }

  #setUpInput(): void {
    this.#input?.dispose();
    this.#input = null;
    if (!this.#stage || !this.#controlsOn()) return;
    const stage = this.#stage;
    this.#input = new CameraInput(this._picture, stage.rig, {
      changed: () => stage.invalidate(),
      reset: () => stage.resetCamera(),
    });
  }

  #readCamera(): void {
    this.#errors.attempt('camera', () => {
      const attributes = readCamera(this.cameraOrbit, this.cameraTarget, this.fieldOfView);
      this.#stage?.setCamera(attributes);
    });
  }

  #readSteps(): void {
    this.#errors.attempt('steps', () => this.#stage?.setQuality(readQuality(this.steps, this.maxError, this.targetFps)));
  }

  /** The region, a slice or the rings are others. A volume that is on its way reads them when it is there. */
  #cutAnew(): void {
    const apply = (): void => {
      const volume = this.#stage?.volume;
      if (volume && !volume.coarse) this.#stage!.setCuts(this.#readCuts(volume));
    };
    if (this.#cuts.ready) apply();
    else this.#work = Promise.all([this.#work, this.#errors.run('slices', null, () => this.#cuts.prepare().then(apply))]).then(() => {});
  }

  #readCuts(volume: Volume): Cuts {
    return this.#cuts.read(volume, this.#model ?? volume);
  }

  /** Load the present source; whatever was loading is given up. */
  #load(): void {
    this.#loading?.abort();
    this.#loading = null;
    this.#putOff = null;
    this._progress = null;
    this.#isCurrent = false;
    this.#model = null;
    this.#scans?.stop();
    this.#scans = null;
    this.#errors.clear('source');
    if (this.src === null && this.#volume) this.#empty();
    const { src } = this;
    if (!this.#stage || !src) return;
    if (!this.#awake) {
      this.#putOff = () => this.#load();
      return;
    }
    x3dScenes.warmUp(); // It comes while the data do; what fails is told when it is needed.
    this.#begin((wanted, signal, onProgress) => {
      this._progress = { loaded: 0, total: 0, phase: 'fetch' };
      return openSource(src, {
        load: (request, options) => loads.run(() => this.#presence.inSight, options.signal, () =>
          sharedVolumes.get(this, { ...request, ...readSource(this), limits: deviceLimits(probeDevice(), this.#maxBytes) }, options)),
        opened: (player) => {
          this.#scans = player;
          this.#readPlay();
        },
        go: (index) => (this.time = String(index)),
        shown: (scan) => this.#emit('time-change', scan),
        changed: () => this.#emit('scans-change', null),
        giveUp: () => (this.play = false),
      }, { wanted, signal, onProgress, onCoarse: (coarse) => void (this.#standIn = this.#showCoarse(coarse, signal)) });
    });
  }

  /** Another one of several scans is wanted. A source that is still being opened looks at its end. */
  #seek(): void {
    const scans = this.#scans;
    if (!scans || !this.#stage) return;
    if (!this.#awake) this.#putOff = () => this.#seek();
    else this.#begin((wanted, signal, onProgress) => scans.load(wanted, signal, onProgress));
  }

  /** Load a volume and show it; whatever was loading is given up, and the old picture stays meanwhile. */
  #begin(load: (wanted: ScanTarget, signal: AbortSignal, onProgress: LoadProgressListener) => Promise<Volume>): void {
    this.#loading?.abort();
    this._progress = null;
    const controller = new AbortController();
    const { signal } = controller;
    const { time } = this;
    const reading = this.#reading;
    this.#loading = controller;
    let wanted: ScanTarget = { index: 0 };
    this.#errors.attempt('time', () => (wanted = readTime(time)));
    const loaded = this.#errors.run('source', signal, async () => {
      const volume = await load(wanted, signal, (progress) => this.#onProgress(progress, signal));
      signal.throwIfAborted();
      await this.#show(volume, signal).catch((error: unknown) => this.#loadSmaller(volume, error));
    });
    this.#work = loaded.then(async (done) => {
      if (signal.aborted) return;
      if (!done) await this.#showLastGood();
      if (reading !== this.#reading) this.#queueOptics();
      this.#scans?.settled(done);
      if (time !== this.time) this.#seek();
    });
  }

  #readPlay(): void {
    this.#errors.attempt('play', () => this.#scans?.play(readPlay(this.play, this.playSpeed)));
    this.#emit('scans-change', null);
  }

  /** Read the optics anew and apply them, after whatever is under way. */
  #queueOptics(volume: Volume | null = this.#volume): void {
    this.#reading.abort(); // Of several in a row the last one holds, however long each takes to read.
    const { signal } = (this.#reading = new AbortController());
    if (!volume || this.#loading) return; // A load under way sees at its end that there was a new reading.
    const stage = this.#stage;
    const read = this.#errors.run('optics', signal, async () => {
      const optics = await readOptics(this, this.#model ?? volume);
      if (signal.aborted || stage !== this.#stage || volume !== this.#volume) return;
      if (stage?.ready) stage.setOptics(optics);
      else {
        await this.#cuts.prepare();
        await stage?.show(volume, optics, () => this.#readCuts(volume));
      }
      if (!signal.aborted) this.#tellOptics(optics);
    });
    this.#work = read.then(() => {});
  }

  async #show(volume: Volume, signal: AbortSignal): Promise<void> {
    const stage = this.#stage!;
    await this.#standIn; // Or it might come later than what it stands in for.
    signal.throwIfAborted();
    this.#reading.abort();
    const model = followModel(this.#model, volume);
    const optics = (model === this.#model && this.#optics) || (await this.#readFirstOptics(model));
    signal.throwIfAborted();
    this.#model = model;
    await this.#cuts.prepare();
    signal.throwIfAborted();
    await stage.show(volume, optics, () => this.#readCuts(volume), signal);
    signal.throwIfAborted();
    this.#loading = null;
    this.#volume = volume;
    this.#isCurrent = true;
    this.#info = describeVolume(volume);
    this._progress = null;
    this.requestUpdate();
    this.#emit('load', this.#info);
    if (optics !== this.#optics) this.#tellOptics(optics);
  }

  /** A picture of a small volume until the large one is there. What is wrong with its attributes is told then. */
  async #showCoarse({ volume, of }: CoarseVolume, signal: AbortSignal): Promise<void> {
    try {
      const optics = await readOptics(this, of);
      await this.#cuts.prepare();
      if (!signal.aborted) await this.#stage?.show(volume, optics, () => this.#cuts.read(volume, of), signal);
    } catch {
      // The large one follows, and fails in the same way.
    }
  }

  /** What a coarse picture announced did not come: what was there before is back. */
  async #showLastGood(): Promise<void> {
    const [volume, optics] = [this.#volume, this.#optics];
    if (!volume || !optics || !this.#stage?.volume?.coarse) return;
    this.#model = null;
    await this.#stage.show(volume, optics, () => this.#readCuts(volume));
  }

  /** Load a volume anew that the GPU has no memory for, this time reduced to a quarter. */
  #loadSmaller({ grid, samples }: Volume, error: unknown): void {
    const isTooLarge = toVolumeViewError(error).code === 'format/too-large';
    if (!isTooLarge || grid.kind === 'polar' || samples.byteLength < minReduced) throw error;
    this.#maxBytes = samples.byteLength / 4;
    this.#load();
  }

  async #readFirstOptics(volume: ScanModel): Promise<VolumeOptics> {
    try {
      const optics = await readOptics(this, volume);
      this.#errors.clear('optics');
      return optics;
    } catch (error) {
      // The data are good: show them with what they suggest themselves, and say what is wrong.
      this.#errors.report('optics', toVolumeViewError(error));
      return readOptics({ transferFunction: null, window: null, referenceLength: null, opacityFactor: null, lightFactor: null }, volume);
    }
  }

  #tellOptics(optics: VolumeOptics | null): void {
    this.#optics = optics;
    this.#emit('optics-change', optics);
  }

  #told(aspect: Aspect, { code, message, cause }: VolumeViewError): void {
    if (aspect === 'source') {
      this.#loading = null;
      this._progress = null;
    }
    this.#emit('error', { code, message, cause });
  }

  #onProgress(progress: LoadProgress, signal: AbortSignal): void {
    if (signal.aborted) return;
    // While scans play, nobody wants a bar to come and go with each of them.
    if (!this.#scans || !this.play) this._progress = progress;
    this.#emit('progress', progress);
  }

  #onRendered(stats: RenderStats): void {
    this.#stats = stats;
    this._hasPicture = true;
    this.#errors.clear('scene');
    this.#emit('render', stats);
    if (this.#stage?.drawn === this.#volume) this.#scans?.drawn();
  }

  #onCameraMoved(): void {
    const rig = this.#stage?.rig;
    if (rig) this.#emit('camera-change', { orbit: rig.orbit, target: rig.camera.target });
  }

  #emit(type: string, detail: unknown): void {
    // Built apart from being sent, or the manifest's analyzer takes "type" for an event's name.
    const event = new CustomEvent(type, { detail });
    this.dispatchEvent(event);
  }

  #requireStage(): Viewer {
    const error = this._shownError;
    if (!this.#stage?.ready) throw error ?? new Error('no volume is loaded yet; wait for the load event');
    return this.#stage;
  }

  /** Wait until nothing is being loaded or read. */
  async #settleWork(): Promise<void> {
    let seen: Promise<void> | null = null;
    while (seen !== this.#work || this.isUpdatePending) {
      seen = this.#work;
      await this.updateComplete;
      await seen;
    }
  }

  async #settle(): Promise<void> {
    await this.#settleWork();
    await this.#stage?.settled();
    if (this._shownError) throw this._shownError;
  }
}

// Listeners get the right event types. Declaring the overloads by merging leaves the class's code alone.
// oxlint-disable-next-line typescript/no-unsafe-declaration-merging
export interface VolumeView {
  addEventListener: VolumeViewListeners['addEventListener'] & LitElement['addEventListener'];
  removeEventListener: VolumeViewListeners['removeEventListener'] & LitElement['removeEventListener'];
}

declare global {
  interface HTMLElementTagNameMap {
    'volume-view': VolumeView;
  }
}
