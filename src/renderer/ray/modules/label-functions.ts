// Transfer functions of groups of labels. The first of them loads this file.
import { brighten } from '../../../optics/transfer/brighten.ts';
import { domainOf } from '../../../optics/transfer/emission.ts';
import { contributionOf } from '../../../optics/cells/empty-space-distance.ts';
import type { Contribution } from '../../../optics/cells/empty-space-distance.ts';
import type { CellAppearances } from '../../../optics/cells/label-detail.ts';
import { integrateForTable } from '../../../optics/transfer/preintegration-table.ts';
import { substepTableSize } from '../../../optics/transfer/substep-limits.ts';
import { buildSubstepTable } from '../../../optics/transfer/substep-table.ts';
import type { TransferFunction } from '../../../optics/transfer/transfer-function.ts';
import { finestSpacing } from '../../../volume/grid.ts';
import type { Gl } from '../../device/device.ts';
import { prepareUpload, uploadPlane } from '../../textures/fill-texture.ts';
import { joinInputs } from '../../device/inputs.ts';
import type { ProgramInputs } from '../../device/inputs.ts';
import { Kept } from '../../device/kept.ts';
import { textureUnit } from '../../device/texture-unit.ts';
import type { TextureUnit } from '../../device/texture-unit.ts';
import type { Optics, RayFrame, RayModule, RayTwin } from '../ray-module.ts';
import { twinOf, usualTwins } from '../ray-twin.ts';
import { keepColumns } from './column-tables.ts';
import type { ColumnTables } from './column-tables.ts';
import { fetchEach } from './columns.ts';
import { groupColumnsText, labelFunctionsText, room } from './label-functions-text.ts';
import { opticalUniforms } from './transfer-function.ts';

/** The groups that have transfer functions. */
interface Groups {
  readonly functions: readonly TransferFunction[];
  /** Which groups are in which cells. */
  readonly looks: CellAppearances;
}

/** The data that columns depend on. */
type ColumnsOf = Pick<RayFrame, 'volume' | 'field' | 'optics'>;

/**
 * Groups of labels have the appearance that their transfer functions give; all other labels have that of the volume's own function. Each
 * sample has a place in the columns of its label's function. These modules replace the usual classify module, and come after the labels.
 */
export class LabelFunctions {
  readonly #columns: ReturnType<typeof keepColumns>;
  readonly #substeps = new Kept<TextureUnit>();
  readonly #all = new Kept<Contribution>();
  readonly #own = new Kept<Contribution>();

  constructor(readonly gl: Gl) {
    this.#columns = keepColumns(gl, room);
  }

  modules({ functions, looks }: Groups, frame: ColumnsOf): readonly RayModule[] {
    const tables = ({ volume, field, optics }: ColumnsOf): ColumnTables => {
      const domain = spanAll([optics.transferFunction, ...functions]);
      return this.#columns.get({ volume, field, optics, functions, domain });
    };
    const usual = { sparesRays: true, order: 2 };
    return [
      ...fetchEach(this.gl, frame.field),
      {
        ...groupColumnsText(tables(frame).hasBins),
        ...usual,
        stage: 'field',
        inputs: (now) => tables(now).inputs,
        contributes: (optics) => this.#showsOwn(optics, looks),
        twin: null,
      },
      {
        ...labelFunctionsText,
        ...usual,
        stage: 'classify',
        inputs: (now) => this.#inputs(now, functions),
        contributes: (optics) => this.#showsAny(optics, functions),
        twin: groupsTwin(functions),
      },
    ];
  }

  /** The values that any of the functions shows: cells in which no function shows anything are empty for all of them. */
  #showsAny({ transferFunction }: Optics, functions: readonly TransferFunction[]): Contribution {
    return this.#all.get([transferFunction, ...functions], () => {
      const all = [transferFunction, ...functions].map(contributionOf);
      return (low, high) => all.some((shows) => shows(low, high));
    });
  }

  /** The same for cells without a group: they are empty if the volume's own function shows nothing there. */
  #showsOwn({ transferFunction }: Optics, { groups }: CellAppearances): Contribution {
    return this.#own.get([transferFunction, groups], () => {
      const shows = contributionOf(transferFunction);
      return (low, high, cell) => groups[cell] > 1 || shows(low, high);
    });
  }

  #inputs(frame: RayFrame, functions: readonly TransferFunction[]): ProgramInputs {
    const {
      optics: { transferFunction, lightFactor, opacityFactor, referenceLength },
      volume,
      domain: [from, to],
    } = frame;
    const voxelRatio = (finestSpacing(volume.finer?.grid ?? volume.grid) / referenceLength) * opacityFactor;
    const all = [transferFunction, ...functions];
    // The shader does not read the table if only cells cut steps.
    const unit =
      frame.maxSubsteps > 1 &&
      this.#substeps.get([...all, lightFactor, voxelRatio], (last) => {
        const tables = all.map((one) => buildSubstepTable(integrateForTable(brighten(one, lightFactor)), voxelRatio));
        return this.#upload(
          tables.map(({ texels }) => texels),
          last?.texture ?? null,
        );
      });
    const uFunctionShares = functions.flatMap((one) => {
      const [low, high] = domainOf(one);
      return [(to - from) / (high - low), (from - low) / (high - low), 0, 0];
    });
    const uniforms = {
      ...opticalUniforms(frame),
      uFunctionShares: Array.from({ length: 16 }, (_, i) => uFunctionShares[i] ?? 0),
    };
    return joinInputs({ uniforms, units: unit ? [unit] : [] });
  }

  /** Upload several tables into one texture, one below another. */
  #upload(tables: readonly Uint8Array[], previous: WebGLTexture | null): TextureUnit {
    const { gl } = this;
    const { columns, rows } = substepTableSize;
    const texels = new Uint8Array(columns * rows * room);
    tables.forEach((one, i) => texels.set(one, columns * rows * i));
    const texture = previous ?? gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    prepareUpload(gl);
    uploadPlane(gl, texels, { width: columns, height: rows * room });
    return textureUnit(gl, { type: gl.TEXTURE_2D, texture, filter: gl.NEAREST, samplerName: 'uSubstepTable' });
  }

  dispose(): void {
    this.#columns.dispose();
    this.gl.deleteTexture(this.#substeps.last?.texture ?? null);
  }
}

export const groupsTwin = (functions: readonly TransferFunction[]): RayTwin =>
  twinOf(usualTwins, ({ classifyPicture, groupClassify }, { volume, optics, rays }, { field }) => ({
    classify: groupClassify(
      [optics.transferFunction, ...functions].map((transferFunction) =>
        classifyPicture({ ...optics, transferFunction }, volume.finer?.grid ?? volume.grid, rays.diameter, field),
      ),
    ),
  }));

/** From the lowest to the highest stop of several functions. */
function spanAll(all: readonly TransferFunction[]): readonly [number, number] {
  const domains = all.map(domainOf);
  return [Math.min(...domains.map(([low]) => low)), Math.max(...domains.map(([, high]) => high))];
}
