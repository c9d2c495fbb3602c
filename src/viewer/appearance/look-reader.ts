import type { ErrorBoard } from '../model/error-board.ts';
import type { TransferFunction } from '../../optics/transfer/transfer-function.ts';
import { resolveLook } from './resolve-look.ts';
import type { ScanModel } from '../model/scan-model.ts';
import { plainLook } from '../model/settings.ts';
import type { Settings } from '../model/settings.ts';
import type { VolumeOptics } from '../model/volume-info.ts';

/** Who shows the look. */
export interface LookHost {
  readonly settings: Settings;
  /** Whose children may be X3D's volume nodes. */
  readonly user: { readonly host: Element };
  /** What the present look is of; null where there is no volume. */
  readonly model: ScanModel | null;
  /** Show the volume with another look. @param signal - aborted where a newer one is on its way */
  wear(optics: VolumeOptics, signal: AbortSignal): Promise<void>;
  /** The look is another one; null where there is no volume any more. */
  lookChanged(optics: VolumeOptics | null): void;
  track(work: Promise<unknown>): void;
}

/** Reads X3D's volume nodes: read-volume-nodes.ts. */
export interface VolumeNodeReader {
  follow(host: LookHost & { readonly look: LookReader }, readLook: () => void): void;
  withVolumeNodes(host: LookHost, look: VolumeOptics, model: ScanModel): Promise<VolumeOptics>;
}

/** Finds out what volumes look like, by settings and volume; of several readings in a row the last one holds, however long each takes. */
export class LookReader {
  #current: VolumeOptics | null = null;
  /** Of the reading under way. */
  #reading: AbortController | null = null;
  #isDue = false;
  /** What reads X3D's volume nodes, once there are some. */
  declare nodes?: Promise<VolumeNodeReader>;
  /** The transfer function of a volume that is labels, where its page says none. */
  dress: { readonly transferFunction: TransferFunction } | null = null;

  constructor(readonly host: LookHost, readonly errors: ErrorBoard) {}

  /** What the volume looks like; null before there is one. */
  get current(): VolumeOptics | null {
    return this.#current;
  }

  /** Read the settings anew and apply them. */
  readAnew(): void {
    const { model } = this.host;
    this.interrupt();
    this.#isDue = false;
    if (!model) return;
    const controller = (this.#reading = new AbortController());
    const { signal } = controller;
    this.host.track(this.errors.run('optics', signal, async () => {
      const optics = await this.read(model);
      signal.throwIfAborted();
      await this.host.wear(optics, signal);
      signal.throwIfAborted();
      this.#reading = null;
      this.tell(optics);
    }));
  }

  /** Read the settings anew when the load that is under way has ended. */
  readLater(): void {
    this.interrupt();
    this.#isDue = true;
  }

  /** Another volume is about to be shown. A reading that is under way is done again afterwards. */
  interrupt(): void {
    if (!this.#reading) return;
    this.#reading.abort();
    this.#reading = null;
    this.#isDue = true;
  }

  /** Read anew what has changed during a load. */
  catchUp(): void {
    if (this.#isDue) this.readAnew();
  }

  /** @throws {VolumeViewError} `attribute/invalid` or `transfer-function/syntax` */
  async read(model: ScanModel): Promise<VolumeOptics> {
    const { look } = this.host.settings;
    if (look.error) throw look.error;
    const optics = await resolveLook(look.value, { ...model, ...this.dress });
    return (await this.nodes)?.withVolumeNodes(this.host, optics, model) ?? optics;
  }

  /** The look of a volume that is to be shown. Where it can't be read, the volume's own one, as the data are good. */
  async readFirst(model: ScanModel): Promise<VolumeOptics> {
    this.#isDue = false;
    try {
      const optics = await this.read(model);
      this.errors.clear('optics');
      return optics;
    } catch (error) {
      this.errors.report('optics', error);
      return resolveLook(plainLook, model);
    }
  }

  /** The volume wears a look, or is gone. */
  tell(optics: VolumeOptics | null): void {
    if (optics === this.#current) return;
    this.#current = optics;
    this.host.lookChanged(optics);
  }
}
