import { loadPart } from '../../core/load-part.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import { domainOf } from '../../optics/transfer/emission.ts';
import { fullColor, isOver } from '../../optics/attachments/overlay.ts';
import type { ShownOverlay } from '../../optics/attachments/overlay.ts';
import { listOverlayCells, overlaidDetail, shownByOverlay } from '../../optics/cells/overlay-cells.ts';
import type { OverlayCells } from '../../optics/cells/overlay-cells.ts';
import { mapShares } from '../../optics/transfer/share-map.ts';
import { isPolar } from '../../volume/volume.ts';
import type { VolumeData } from '../../volume/volume.ts';
import type { Device, Gl } from '../device/device.ts';
import type { FieldProviders } from './field-providers.ts';
import { finishUpload, quickBytes } from '../textures/fill-texture.ts';
import { joinInputs } from '../device/inputs.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import { Kept } from '../device/kept.ts';
import { loadCartesianChunks, prepareCartesian } from '../ray/modules/cartesian-field.ts';
import { overlayAppearanceText } from '../ray/modules/overlay.ts';
import type { Optics, RayFrame, RayModule, SecondField } from '../ray/ray-module.ts';
import { uploadOverlayTable } from './overlay-table.ts';
import { uploadOverlay } from './upload-overlay.ts';
import { uploadGradually } from '../textures/upload-gradually.ts';

/** Factors stay below this, so that the shader's products don't overflow. */
const largestFactor = 1e30;

/** A second field on the GPU, and the modules that draw it. */
export class OverlayLayer {
  #shown: ShownOverlay | null = null;
  #wanted: ShownOverlay | null = null;
  #field: SecondField | null = null;
  readonly #table = new Kept<ProgramInputs>();
  readonly #cells = new Kept<OverlayCells>();
  readonly #own = new Kept<{ readonly cells: Uint8Array | null }>();

  constructor(
    readonly gl: Gl,
    readonly device: Device,
    readonly providers: FieldProviders,
  ) {}

  get shown(): ShownOverlay | null {
    return this.#shown;
  }

  /**
   * @returns resolves when the next picture will show the overlay; a later call replaces this one
   * @throws {VolumeViewError} `format/too-large` if the device has no room for it
   */
  async show(overlay: ShownOverlay | null): Promise<void> {
    this.#wanted = overlay;
    if (!isSameField(overlay, this.#shown)) {
      const field = overlay && (await this.#bring(overlay));
      if (this.#wanted !== overlay) return field?.dispose();
      if (overlay && !field) return; // The context was lost.
      this.#field?.dispose();
      this.#field = field;
    }
    this.#shown = overlay;
  }

  /** Upload a small overlay at once, and a large one piece by piece between frames. */
  async #bring(overlay: ShownOverlay): Promise<SecondField | null> {
    const { volume } = overlay;
    if (!isPolar(volume)) await prepareCartesian(volume, this.device);
    const second =
      isPolar(volume) &&
      (await loadPart(
        this.providers.polar!().then((polar) => polar.second!()),
        'shows a second moment',
      ));
    const { weighTexels } = !isPolar(volume) && volume.hasNoData ? await loadCartesianChunks() : {};
    if (this.#wanted !== overlay) return null;
    const upload = second
      ? second(this.gl, overlay, this.device)
      : uploadOverlay(this.gl, volume, { device: this.device, weighTexels });
    return volume.samples.byteLength <= quickBytes
      ? finishUpload(upload)
      : uploadGradually(this.gl, upload, () => this.#wanted !== overlay);
  }

  /** The overlay modules of a volume; none if it has no overlay. @param projects - whether rays project values: then the overlay is left out */
  modules(volume: VolumeData, projects: boolean): readonly RayModule[] {
    const overlay = this.over(volume);
    const field = this.#field;
    if (!overlay || !field || projects) return [];
    const { stored, foldFrom } = field;
    const color = overlay.blend === 'color';
    const folds = foldFrom < Infinity;
    const domain = domainOf(overlay.transferFunction);
    const { from, scale } = mapShares({ ...stored, range: overlay.volume.range }, domain);
    const shared = { sparesRays: true, order: 2 };
    const twins = field.twins(overlay);
    return [
      {
        ...field.text,
        ...shared,
        stage: 'field',
        twin: twins.field,
        inputs: (frame) =>
          joinInputs(field.inputs(frame.volume), { uniforms: { uOverlayDomain: [scale, from] }, units: [] }),
      },
      {
        ...overlayAppearanceText({ color, tableFilter: this.device.floatLinear, folds }),
        ...shared,
        stage: 'shade',
        twin: twins.look,
        inputs: (frame) =>
          joinInputs(this.#tableOf(overlay, frame), {
            uniforms: {
              uOverlayFold: Math.min(largestFactor, foldFrom / (domain[1] - domain[0])),
              ...(color
                ? {
                    uOverlayWeight: 1 / fullColor,
                    uOverlayMissing: overlay.missing ? [...overlay.missing, 1] : [0, 0, 0, 0],
                  }
                : { uOverlayScale: scaleOf(overlay, frame) }),
            },
            units: [],
          }),
      },
    ];
  }

  #tableOf(overlay: ShownOverlay, { optics: { lightFactor } }: RayFrame): ProgramInputs {
    return this.#table.get([overlay.transferFunction, overlay.blend, lightFactor], (last) =>
      uploadOverlayTable(this.gl, overlay, { lightFactor, isFiltered: this.device.floatLinear, last }),
    );
  }

  /** The overlay, if it lies over this volume; else null. */
  over(volume: VolumeData): ShownOverlay | null {
    return this.#shown && isOver(this.#shown, volume) ? this.#shown : null;
  }

  /** Macrocells in which the overlay shows something, whatever the volume has there; null if there are none. */
  ownCells(volume: VolumeData): Uint8Array | null {
    const overlay = this.over(volume);
    if (!overlay) return null;
    const cells = this.#cellsOf(volume, overlay);
    return this.#own.get([cells, overlay.transferFunction, overlay.blend], () => ({
      cells: shownByOverlay(cells, overlay),
    })).cells;
  }

  /** How the overlay changes the detail that rays could miss: see `SeenVolume`. @param lightFactor - of the picture */
  more(volume: VolumeData, seen: Omit<SeenVolume, 'cells'>, { lightFactor }: Optics): SeenVolume['more'] {
    const overlay = this.over(volume);
    return overlay ? overlaidDetail(this.#cellsOf(volume, overlay), overlay, { seen, lightFactor }) : seen.more;
  }

  #cellsOf(volume: VolumeData, overlay: ShownOverlay): OverlayCells {
    return this.#cells.get([volume, overlay.volume], () => listOverlayCells(volume, overlay.volume));
  }

  dispose(): void {
    this.#wanted = null; // A load or upload in progress stops.
    this.#field?.dispose();
    this.gl.deleteTexture(this.#table.last?.units[0].texture ?? null);
  }
}

/** Whether two overlays have the same data on the GPU. For radars the volume below matters too: its moments are stored together there. */
function isSameField(one: ShownOverlay | null, other: ShownOverlay | null): boolean {
  return one?.volume === other?.volume && (!one || !isPolar(one.volume) || one.over === other?.over);
}

function scaleOf({ opacityFactor }: ShownOverlay, { rays, optics }: RayFrame): number {
  return Math.min(largestFactor, (rays.diameter / optics.referenceLength) * optics.opacityFactor * opacityFactor);
}
