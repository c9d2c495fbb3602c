import type { ErrorState } from '../model/error-state.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { showsMore, withDefaultLook } from './default-look.ts';
import { resolveAppearance } from './resolve-appearance.ts';
import type { ScanModel } from '../model/scan-model.ts';
import { plainAppearance } from '../model/plain-appearance.ts';
import type { AppearanceSettings, Settings } from '../model/settings.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** What the reader needs of its view. */
export interface AppearanceHost {
  readonly settings: Settings;
  /** The element whose children may be X3D's volume nodes. */
  readonly user: { readonly host: Element };
  /** The volume of the present appearance; null where there is no volume. */
  readonly model: ScanModel | null;
  /** Show the volume with another appearance. @param signal - aborted where a newer one is being read */
  apply(optics: VolumeOptics, signal: AbortSignal): Promise<void>;
  /** The appearance has changed; null where there is no longer a volume. */
  appearanceChanged(optics: VolumeOptics | null): void;
  track(work: Promise<unknown>): void;
}

/** Reads X3D's volume nodes: read-volume-nodes.ts. */
export interface VolumeNodeReader {
  follow(host: AppearanceHost & { readonly look: AppearanceReader }, readAppearance: () => void): void;
  withVolumeNodes(host: AppearanceHost, appearance: VolumeOptics, model: ScanModel): Promise<VolumeOptics>;
}

/**
 * Reads the appearance of volumes from settings and volume; of several readings one after another the last one counts, however
 * long each takes.
 */
export class AppearanceReader {
  #current: VolumeOptics | null = null;
  /** Stops the reading in progress. */
  #reading: AbortController | null = null;
  #isDue = false;
  /** Whether the view itself chose light, because nothing else decides how the volume looks. */
  #isLit = false;
  /** The code that reads X3D's volume nodes, once there are some. */
  declare nodes?: Promise<VolumeNodeReader>;
  /** The transfer function of a volume that is itself labels, where its page gives none. */
  replacement: { readonly transferFunction: TransferFunction } | null = null;

  constructor(
    readonly host: AppearanceHost,
    readonly errors: ErrorState,
  ) {}

  /** The appearance of the volume; null before there is one. */
  get current(): VolumeOptics | null {
    return this.#current;
  }

  /** Read the settings again and apply them. */
  readAgain(): void {
    const { model } = this.host;
    this.interrupt();
    this.#isDue = false;
    if (!model) return;
    const controller = (this.#reading = new AbortController());
    const { signal } = controller;
    this.host.track(
      this.errors.run('optics', signal, async () => {
        const optics = await this.read(model);
        signal.throwIfAborted();
        await this.host.apply(optics, signal);
        signal.throwIfAborted();
        this.#reading = null;
        this.notify(optics);
      }),
    );
  }

  /** Read the settings again when the present load has ended. */
  readLater(): void {
    this.interrupt();
    this.#isDue = true;
  }

  /** Another picture has joined or left the view. If it decides how the volume looks, read again. */
  attachmentsChanged(): void {
    const { model, settings } = this.host;
    if (!model || settings.look.error || !this.#current) return;
    if ((this.#complete(settings.look.value, model) !== settings.look.value) !== this.#isLit) this.readAgain();
  }

  /** Another volume will be shown. A reading in progress is repeated afterwards. */
  interrupt(): void {
    if (!this.#reading) return;
    this.#reading.abort();
    this.#reading = null;
    this.#isDue = true;
  }

  /** Read again what has changed during a load. */
  catchUp(): void {
    if (this.#isDue) this.readAgain();
  }

  /** @throws {VolumeViewError} `attribute/invalid` or `transfer-function/syntax` */
  async read(model: ScanModel): Promise<VolumeOptics> {
    const { look: appearance } = this.host.settings;
    if (appearance.error) throw appearance.error;
    const said = this.#complete(appearance.value, model);
    this.#isLit = said !== appearance.value;
    const optics = await resolveAppearance(said, { ...model, ...this.replacement });
    return (await this.nodes)?.withVolumeNodes(this.host, optics, model) ?? optics;
  }

  /** The appearance of a volume that will be shown. Where the settings can't be read, it is the volume's own, because the data are good. */
  async readFirst(model: ScanModel): Promise<VolumeOptics> {
    this.#isDue = false;
    try {
      const optics = await this.read(model);
      this.errors.clear('optics');
      return optics;
    } catch (error) {
      this.errors.report('optics', error);
      return resolveAppearance(plainAppearance, model);
    }
  }

  /** Volume nodes of X3D say themselves how the volume looks. */
  #complete(said: AppearanceSettings, model: ScanModel): AppearanceSettings {
    return this.nodes || showsMore(this.host.user.host) ? said : withDefaultLook(said, model);
  }

  /** The volume has this appearance now, or null where it is gone. */
  notify(optics: VolumeOptics | null): void {
    if (optics === this.#current) return;
    this.#current = optics;
    this.host.appearanceChanged(optics);
  }
}
