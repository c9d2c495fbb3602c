// What is attached to a layer's volume: labels, and a second field. The first of them loads this file.
import { loadPart } from '../../core/load-part.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import type { Contribution } from '../../optics/cells/empty-space-distance.ts';
import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import type { ShownLabels } from '../../volume/labels.ts';
import type { VolumeData } from '../../volume/volume.ts';
import type { Device, Gl } from '../device/device.ts';
import type { FieldProviders } from './field-providers.ts';
import { Kept } from '../device/kept.ts';
import type { LabelLayer, LabelledLayer } from './label-layer.ts';
import type { OverlayLayer } from './overlay-layer.ts';
import { listSamplers, maxSamplers } from '../ray/compose-ray.ts';
import type { Optics, RayModule } from '../ray/ray-module.ts';

/** The labels and the second field of a layer, if it has them. */
export class AttachedLayers {
  #labels: LabelLayer | null = null;
  #overlay: OverlayLayer | null = null;
  #hasNotified = false;
  readonly #widened = new Kept<readonly Contribution[]>();
  readonly #opened = new Kept<VolumeData>();

  constructor(
    readonly gl: Gl,
    readonly device: Device,
    readonly providers: FieldProviders,
  ) {}

  async setLabels(labels: ShownLabels | null): Promise<void> {
    const { LabelLayer } = await loadPart(import('./label-layer.ts'), 'shows labels');
    await (this.#labels ??= new LabelLayer(this.gl, this.device)).show(labels);
  }

  async setOverlay(overlay: ShownOverlay | null): Promise<void> {
    const { OverlayLayer } = await loadPart(import('./overlay-layer.ts'), 'shows layers');
    await (this.#overlay ??= new OverlayLayer(this.gl, this.device, this.providers)).show(overlay);
  }

  /** The modules for the rays of a layer. The second field comes after the labels, so it acts on the colours that labels give. */
  modules(layer: LabelledLayer): readonly RayModule[] {
    return [
      ...(this.#labels?.modules(layer) ?? []),
      ...(this.#overlay?.modules(layer.volume!, !layer.cutsSteps) ?? []),
    ];
  }

  /** All modules of a ray; without those of the second field if WebGL 1 has no samplers left for them. */
  fit(modules: readonly RayModule[]): readonly RayModule[] {
    if (listSamplers({ adaptive: false, modules }).length <= maxSamplers(this.device.webgl2)) return modules;
    const others = modules.filter(({ name }) => !/^(overlay|channel)/.test(name));
    if (others.length < modules.length && !this.#hasNotified) {
      this.#hasNotified = true;
      console.warn(
        'WebGL 1 has no room here for a layer in addition to all else that is shown: the layer is left out. Show it without labels, or without shapes.',
      );
    }
    return others;
  }

  /** The detail that rays could miss, for the labels and the second field: see `SeenVolume`. */
  more(
    volume: VolumeData,
    seen: Omit<SeenVolume, 'cells' | 'more'>,
    optics: Optics,
  ): Pick<SeenVolume, 'more' | 'functions'> | undefined {
    const labelled = this.#labels?.more(volume, seen, optics.lightFactor);
    return this.#overlay
      ? { ...labelled, more: this.#overlay.more(volume, { ...seen, ...labelled }, optics) }
      : labelled;
  }

  /** Which values may show in a volume with a second field: all values in the cells where the second field shows something. */
  widen(volume: VolumeData, contributions: readonly Contribution[]): readonly Contribution[] {
    const own = this.#overlay?.ownCells(volume);
    if (!own) return contributions;
    return this.#widened.get([own, ...contributions], () =>
      contributions.map(
        (shows): Contribution =>
          (low, high, cell) =>
            own[cell] > 0 || shows(low, high, cell),
      ),
    );
  }

  /** The volume, but with values in cells that have none where the second field shows something: the skipping of empty space needs them. */
  open(volume: VolumeData): VolumeData {
    const own = this.#overlay?.ownCells(volume);
    if (!own) return volume;
    return this.#opened.get([volume, own], () => {
      const {
        macrocells,
        macrocells: { low, high },
      } = volume;
      const lacks = (cell: number): boolean => own[cell] > 0 && !(low[cell] <= high[cell]);
      return low.some((_: number, cell: number) => lacks(cell))
        ? {
            ...volume,
            macrocells: {
              ...macrocells,
              low: low.map((x: number, cell: number) => (lacks(cell) ? 0 : x)),
              high: high.map((x: number, cell: number) => (lacks(cell) ? 0 : x)),
            },
          }
        : volume;
    });
  }

  /** The second field that is shown. */
  get shown(): ShownOverlay | null {
    return this.#overlay?.shown ?? null;
  }

  dispose(): void {
    this.#labels?.dispose();
    this.#overlay?.dispose();
  }
}
