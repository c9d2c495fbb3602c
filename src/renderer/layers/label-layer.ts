// Labels of a layer's volume, volumes of labels, and volumes of several channels. The first of them loads this file.
import { loadPart } from '../../core/load-part.ts';
import { brighten } from '../../optics/transfer/brighten.ts';
import type { SeenVolume } from '../../optics/cells/cell-detail.ts';
import type { Contribution } from '../../optics/cells/empty-space-distance.ts';
import { appearanceOfCells, divideAppearances, labelledDetail } from '../../optics/cells/label-detail.ts';
import type { CellAppearances } from '../../optics/cells/label-detail.ts';
import { listLabels } from '../../volume/label-cells.ts';
import type { LabelCells } from '../../volume/label-cells.ts';
import type { ShownLabels } from '../../volume/labels.ts';
import { isPolar } from '../../volume/volume.ts';
import type { VolumeData } from '../../volume/volume.ts';
import type { Device, Gl } from '../device/device.ts';
import { finishUpload, quickBytes } from '../textures/fill-texture.ts';
import type { Upload } from '../textures/fill-texture.ts';
import { joinInputs } from '../device/inputs.ts';
import type { ProgramInputs } from '../device/inputs.ts';
import { Kept } from '../device/kept.ts';
import { createLabelTable } from './label-table.ts';
import type { LabelTable } from './label-table.ts';
import { uploadBlock } from '../ray/modules/cartesian-field.ts';
import type { BlockTexture } from '../ray/modules/cartesian-field.ts';
import { groupAppearances, labelAppearances } from '../ray/modules/label-appearances.ts';
import { labelsText, labelsTwin } from '../ray/modules/labels.ts';
import type { LabelFunctions } from '../ray/modules/label-functions.ts';
import type { FieldModule, Optics, RayModule } from '../ray/ray-module.ts';
import { uploadGradually } from '../textures/upload-gradually.ts';

export { rareProvider } from '../ray/modules/rare-fields.ts';

/** A label map on the GPU, with the table of its labels, and which labels each cell contains. */
interface Brought {
  readonly block: BlockTexture;
  readonly table: LabelTable;
  /** The labels in each of the volume's macrocells. */
  readonly cells: LabelCells;
}

/** The members of a layer that its labels read. */
export interface LabelledLayer {
  readonly volume: VolumeData | null;
  readonly field: FieldModule | null;
  readonly optics: Optics | null;
  /** Whether opacity matters. */
  readonly cutsSteps: boolean;
}

/** Labels on the GPU, and the modules that draw them. */
export class LabelLayer {
  #shown: ShownLabels | null = null;
  #wanted: ShownLabels | null = null;
  #brought: Brought | null = null;
  /** The styles that are in the table now. */
  #applied: ShownLabels['styles'] | null = null;
  readonly #looks = new Kept<CellAppearances>();
  readonly #contribution = new Kept<Contribution>();
  readonly #detail = new Kept<Pick<SeenVolume, 'more' | 'functions'>>();
  #functions: LabelFunctions | null = null;

  constructor(
    readonly gl: Gl,
    readonly device: Device,
  ) {}

  /**
   * @returns resolves when the next picture will show the labels; a later call replaces this one
   * @throws {VolumeViewError} `format/too-large` if the device has no room for them
   */
  async show(labels: ShownLabels | null): Promise<void> {
    this.#wanted = labels;
    if (labels?.functions && !this.#functions) {
      const part = await loadPart(import('../ray/modules/label-functions.ts'), 'shows transfer functions of labels');
      this.#functions ??= new part.LabelFunctions(this.gl);
      if (this.#wanted !== labels) return;
    }
    if (labels?.map !== this.#shown?.map) {
      const brought = labels && (await this.#bring(labels));
      if (this.#wanted !== labels) return disposeOf(brought);
      if (labels && !brought) return; // The context was lost.
      disposeOf(this.#brought);
      this.#brought = brought;
      this.#applied = null;
    }
    this.#shown = labels;
  }

  /** Upload a small map at once, and a large one piece by piece between frames. */
  async #bring(labels: ShownLabels): Promise<Brought | null> {
    const upload = this.#upload(labels);
    return labels.map.numbers.byteLength <= quickBytes
      ? finishUpload(upload)
      : uploadGradually(this.gl, upload, () => this.#wanted !== labels);
  }

  /** The label numbers are uploaded in the same way as a volume's samples. */
  *#upload({ map }: ShownLabels): Upload<Brought> {
    const cells = yield* listLabels(map);
    const table = yield* createLabelTable(this.gl, map, this.device);
    let block: BlockTexture | null = null;
    try {
      block = yield* uploadBlock(
        this.gl,
        { samples: map.numbers, grid: map, hasNoData: false },
        { device: this.device, filterInShader: true },
      );
      return { cells, table, block };
    } finally {
      if (!block) table.dispose();
    }
  }

  /** The label modules of a layer; none if its volume has no labels. */
  modules({ volume, field: voxels, optics, cutsSteps }: LabelledLayer): readonly RayModule[] {
    const labels = this.#labelsOf(volume!);
    if (!labels) return [];
    const functions = cutsSteps && optics ? labels.functions : undefined;
    const text = labelsText({
      texture3d: this.device.webgl2,
      twoBytes: labels.map.numbers instanceof Uint16Array,
      hides: !cutsSteps,
      groups: functions !== undefined,
    });
    const looks = this.#appearancesOf(labels, volume!);
    const contribution = this.#contribution.get([looks], () => {
      const { max } = looks;
      return (_low, _high, cell) => max[cell] > 0;
    });
    const field: RayModule<'field'> = {
      ...text,
      stage: 'field',
      sparesRays: true,
      order: 1,
      contributes: () => contribution,
      inputs: () => this.#inputs(labels),
      twin: labelsTwin(labels, !cutsSteps),
    };
    if (!cutsSteps) return [field];
    const frame = { volume: volume!, field: voxels!, optics: optics! };
    return [
      field,
      ...(functions ? this.#functions!.modules({ functions, looks }, frame) : []),
      functions ? groupAppearances : labelAppearances,
    ];
  }

  /** How labels change the detail that rays could miss: see `SeenVolume`. */
  more(
    volume: VolumeData,
    seen: Omit<SeenVolume, 'cells' | 'more'>,
    lightFactor: number,
  ): Pick<SeenVolume, 'more' | 'functions'> | undefined {
    const labels = this.#labelsOf(volume);
    if (!labels) return undefined;
    const { functions: own = [] } = labels;
    const looks = this.#appearancesOf(labels, volume);
    return this.#detail.get([looks, volume, seen.transferFunction, seen.opticalScale, lightFactor, ...own], () => {
      const functions = own.map((one) => brighten(one, lightFactor));
      return { functions, more: labelledDetail(looks, { ...seen, functions }) };
    });
  }

  /** A radar's grid has no voxels to label. */
  #labelsOf(volume: VolumeData): ShownLabels | null {
    const labels = this.#shown;
    return labels && !isPolar(volume) && labels.map.dimensions.every((n, axis) => n === volume.grid.dimensions[axis])
      ? labels
      : null;
  }

  /** In the macrocells of a volume. */
  #appearancesOf({ styles, map }: ShownLabels, { macrocells }: VolumeData): CellAppearances {
    const { cells } = this.#brought!;
    return this.#looks.get([cells, styles, macrocells.size], () =>
      divideAppearances(appearanceOfCells(cells, styles), { dimensions: map.dimensions, size: cells.size }, macrocells),
    );
  }

  #inputs({ styles }: ShownLabels): ProgramInputs {
    const { block, table } = this.#brought!;
    const {
      uniforms: { uMosaic },
      units: [unit],
    } = block.inputs();
    if (this.#applied !== styles) table.apply(styles);
    this.#applied = styles;
    return joinInputs(table.inputs, {
      uniforms: uMosaic ? { uLabelMosaic: uMosaic } : {},
      units: [{ ...unit, samplerName: 'uLabels' }],
    });
  }

  dispose(): void {
    this.#wanted = null; // A load or upload in progress stops.
    disposeOf(this.#brought);
    this.#functions?.dispose();
  }
}

function disposeOf(brought: Brought | null): void {
  brought?.block.dispose();
  brought?.table.dispose();
}
