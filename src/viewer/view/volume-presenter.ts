import type { CoarseVolume } from '../../formats/base/load-request.ts';
import { isPolar } from '../../volume/volume.ts';
import type { Volume } from '../../volume/volume.ts';
import { hasNotices } from '../model/file-notices.ts';
import type { FileNotices } from '../model/file-notices.ts';
import { CutReader } from '../cuts/cuts.ts';
import type { Cuts } from '../cuts/cuts.ts';
import type { ErrorState } from '../model/error-state.ts';
import { AppearanceReader } from '../appearance/appearance-reader.ts';
import type { AppearanceHost, VolumeNodeReader } from '../appearance/appearance-reader.ts';
import { followModel } from '../model/scan-model.ts';
import type { ScanModel } from '../model/scan-model.ts';
import type { Settings } from '../model/settings.ts';
import { socketOf } from '../model/view-socket.ts';
import type { ScansOfView } from '../model/scans-of-view.ts';
import type { SocketView } from '../model/view-socket.ts';
import type { Viewer } from './viewer.ts';
import { describeVolume } from '../model/volume-info.ts';
import type { VolumeInfo, VolumeOptics } from '../model/volume-info.ts';

/** What a presenter needs of its view. */
export interface PresenterHost {
  /** Its children may be slices. */
  readonly host: HTMLElement;
  readonly settings: Settings;
  /** Loads the source. */
  readonly loader?: { readonly scans: ScansOfView | null };
  /** Whether the picture is near enough to be visible soon, a script waits for it, or it is eager. */
  readonly awake: boolean;
  /** Send an event to the page. */
  emit(type: string, detail: unknown): void;
  /** What the element shows in addition to the picture has changed. */
  changed(): void;
  /** Add work that scripts wait for when they wait for the picture. */
  track(work: Promise<unknown>): void;
}

/** Shows volumes in the picture, each with the appearance and the cuts of the settings. It keeps them while there is no viewer. */
export class VolumePresenter implements AppearanceHost, SocketView {
  /** null while the element is in no page. */
  viewer: Viewer | null = null;
  readonly look: AppearanceReader;
  readonly #cuts: CutReader;
  #volume: Volume | null = null;
  /** What stays the same from one scan to the next. */
  #model: ScanModel | null = null;
  #info: VolumeInfo | null = null;
  /** What of attached files is not shown, by the object that shows them; see `reportFileNotices`. */
  readonly fileNotices = new Map<object, readonly FileNotices[]>();

  constructor(
    readonly user: PresenterHost,
    readonly errors: ErrorState,
  ) {
    this.look = new AppearanceReader(this, errors);
    this.#cuts = new CutReader(user.host, errors, () => user.settings);
    socketOf(user.host).view = this;
  }

  /** The last good volume; it may belong to the previous source. */
  get volume(): Volume | null {
    return this.#volume;
  }

  get info(): VolumeInfo | null {
    return this.#info;
  }

  /** Whether something of the files is not in the picture, or is changed in it. */
  get hasNotices(): boolean {
    return hasNotices(this.#info, this.fileNotices);
  }

  get host(): HTMLElement {
    return this.user.host;
  }

  get awake(): boolean {
    return this.user.awake;
  }

  get settings(): Settings {
    return this.user.settings;
  }

  get model(): ScanModel | null {
    return this.#model ?? this.#volume;
  }

  /** Whether the last good volume is the one in the last picture. */
  get isInPicture(): boolean {
    return this.viewer?.drawn === this.#volume;
  }

  /** Another source was requested: its volumes are independent of the earlier scans. */
  forgetModel(): void {
    this.#model = null;
  }

  /** There is no longer a volume. */
  empty(): void {
    this.#volume = null;
    this.#info = null;
    this.look.interrupt();
    this.look.notify(null);
  }

  /**
   * Show a volume in the picture; the previous one stays until the GPU has all of the new one.
   * @returns its appearance, which the caller then announces to the page together with the volume
   * @throws what drawing throws, and the signal's reason
   */
  async show(volume: Volume, signal: AbortSignal): Promise<VolumeOptics> {
    const viewer = this.viewer!;
    this.look.interrupt();
    const model = followModel(this.#model, volume);
    const read = (model === this.#model && this.look.current) || (await this.look.readFirst(model));
    signal.throwIfAborted();
    // If the coarse picture already has an equal appearance, the same object is used, so that its tables are not made again.
    const optics = !volume.ids && JSON.stringify(viewer.optics) === JSON.stringify(read) ? viewer.optics! : read;
    this.#model = model;
    await this.#cuts.prepare(volume);
    signal.throwIfAborted();
    await viewer.show(volume, optics, () => this.#readCuts(volume), signal);
    signal.throwIfAborted();
    this.#volume = volume;
    this.#info = describeVolume(volume);
    if (!this.#cuts.isReady(volume)) this.cutAgain(); // A cut was added while the volume was loading.
    return optics;
  }

  async replace(volume: Volume): Promise<void> {
    this.announce(await this.show(volume, new AbortController().signal));
  }

  /** Notify the page of the new volume. */
  announce(optics: VolumeOptics): void {
    this.user.emit('load', this.#info);
    this.look.notify(optics);
  }

  /**
   * Show a picture of a small volume until the large one is there; for a radar, precompile the drawing code. Errors in its
   * attributes are reported with the large volume.
   */
  async showCoarse({ volume, of }: CoarseVolume, signal: AbortSignal): Promise<void> {
    try {
      const optics = await this.look.read(of);
      await this.#cuts.prepare(volume);
      if (signal.aborted) return;
      if (isPolar(volume))
        (await import('./precompile.ts')).precompile(this.viewer, {
          volume,
          optics,
          cuts: this.#cuts.read(volume, of),
        });
      else await this.viewer?.show(volume, optics, () => this.#cuts.read(volume, of), signal);
    } catch {
      // The large volume follows, and fails in the same way.
    }
  }

  /** A load has ended. If it failed after its coarse picture was shown, the previous volume is shown again. */
  async endLoad(done: boolean): Promise<void> {
    const [volume, optics, viewer] = [this.#volume, this.look.current, this.viewer];
    if (!done && volume && optics && viewer?.volume?.coarse) {
      this.#model = null;
      await viewer.show(volume, optics, () => this.#readCuts(volume));
    }
    this.look.catchUp();
  }

  async apply(optics: VolumeOptics, signal: AbortSignal): Promise<void> {
    const [viewer, volume] = [this.viewer, this.#volume];
    if (viewer?.ready) await viewer.setOptics(optics);
    else if (viewer && volume) {
      await this.#cuts.prepare(volume);
      await viewer.show(volume, optics, () => this.#readCuts(volume), signal);
    }
  }

  /** There are volume nodes of X3D. @param load - loads the code that reads them, @param readAppearance - reads the appearance again */
  followNodes(load: () => Promise<VolumeNodeReader>, readAppearance: () => void): void {
    const { look: appearance } = this;
    // The loaded code then follows them itself.
    if (!appearance.nodes)
      this.track((appearance.nodes = load()).then((nodes) => nodes.follow(this, readAppearance), readAppearance));
  }

  appearanceChanged(optics: VolumeOptics | null): void {
    this.user.emit('optics-change', optics);
  }

  track(work: Promise<unknown>): void {
    this.user.track(work);
  }

  /** The region, a slice or the rings have changed. A volume that is still loading reads them when it is there. */
  cutAgain(): void {
    const shown = this.viewer?.volume;
    if (!shown) return;
    const apply = (): void => {
      const volume = this.viewer?.volume;
      if (volume && !volume.coarse) this.viewer!.setCuts(this.#readCuts(volume));
    };
    if (this.#cuts.isReady(shown)) apply();
    // Errors that `apply` reports must stay, so it runs after the end of the loading, which clears errors.
    else
      this.track(
        this.errors.run('slices', null, () => this.#cuts.prepare(shown, true)).then((isLoaded) => isLoaded && apply()),
      );
  }

  #readCuts(volume: Volume): Cuts {
    return this.#cuts.read(volume, this.#model ?? volume);
  }
}
