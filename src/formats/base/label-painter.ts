/** So many pairs of labels of which one hides the other are said one by one. */
const maxListed = 8;

/** Writes labels into one grid, and counts what they hide of each other: where several want a voxel, the last one has it. */
export class LabelPainter<Numbers extends Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>> {
  readonly #voxels = new Map<number, number>();
  /** Number of hidden voxels, by the id below and the id above. */
  readonly #hidden = new Map<number, Map<number, number>>();

  /** @param samples - of the grid, 0 where there is no label yet */
  constructor(readonly samples: Numbers) {}

  /** @param id - not 0 */
  paint(voxel: number, id: number): void {
    const below = this.samples[voxel];
    if (below === id) return;
    if (below > 0) {
      const above = this.#hidden.get(below) ?? new Map<number, number>();
      this.#hidden.set(below, above.set(id, (above.get(id) ?? 0) + 1));
    }
    this.#voxels.set(id, (this.#voxels.get(id) ?? 0) + 1);
    this.samples[voxel] = id;
  }

  /** What is hidden, in words. @param called - how messages name a label, and @param kind - what they call it before */
  describeHidden(called: (id: number) => string, kind = ''): string[] {
    const all = Array.from(this.#hidden, ([below, above]) =>
      Array.from(
        above,
        ([id, count]) =>
          `${count.toLocaleString('en')} of the ${this.#voxels.get(below)!.toLocaleString('en')} voxels of ${kind}${called(below)} are hidden by ${called(id)}, which overlaps it`,
      ),
    ).flat();
    const more = all.length - maxListed;
    return more > 0
      ? [...all.slice(0, maxListed), `the same of ${more.toLocaleString('en')} other pairs of them`]
      : all;
  }
}
