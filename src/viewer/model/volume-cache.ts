import type { Volume } from '../../volume/volume.ts';

/** The maximum number of volumes that are kept. */
const maxVolumes = 5;

/** The maximum number of bytes of samples that are kept; the newest volume is kept whatever its size. */
const maxBytes = 512 * 2 ** 20;

/** Decoded volumes by number; the least recently used ones make room for new ones. */
export class VolumeCache {
  /** In the order of use, the latest last. */
  readonly #volumes = new Map<number, Volume>();

  /** Whether there is room for `count` volumes of this size. */
  static holds(volume: Volume, count: number): boolean {
    return count <= maxVolumes && count * volume.samples.byteLength <= maxBytes;
  }

  has(index: number): boolean {
    return this.#volumes.has(index);
  }

  /** The volume of this number, which does not count as a use of it. */
  peek(index: number): Volume | null {
    return this.#volumes.get(index) ?? null;
  }

  get(index: number): Volume | null {
    const volume = this.#volumes.get(index);
    if (!volume) return null;
    this.#use(index, volume);
    return volume;
  }

  set(index: number, volume: Volume): void {
    this.#use(index, volume);
    for (const oldest of this.#volumes.keys()) {
      if (this.#volumes.size === 1 || (this.#volumes.size <= maxVolumes && this.#bytes <= maxBytes)) return;
      this.#volumes.delete(oldest);
    }
  }

  get #bytes(): number {
    return [...this.#volumes.values()].reduce((sum, { samples }) => sum + samples.byteLength, 0);
  }

  #use(index: number, volume: Volume): void {
    this.#volumes.delete(index);
    this.#volumes.set(index, volume);
  }
}
