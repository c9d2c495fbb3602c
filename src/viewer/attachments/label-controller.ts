import { VolumeViewError } from '../../core/errors.ts';
import type { LabelRow, LabelTable } from '../../formats/label-tables/label-table.ts';
import { paneLabels } from '../../panes/pane-labels.ts';
import type { PaneLabels } from '../../panes/pane-labels.ts';
import type { CartesianGrid } from '../../volume/grid.ts';
import { invertAffine } from '../../volume/matrix.ts';
import type { LabelMap, NamedLabel } from '../../volume/labels.ts';
import type { Volume } from '../../volume/volume.ts';
import { AttachmentController } from './attachment-controller.ts';
import type { AttachmentHost } from './attachment-controller.ts';
import { readOnly } from './label-children.ts';
import type { LabelChildren, OnlyLabels } from './label-children.ts';
import { labelsIn, loadLabelFile, loadLabelTable } from '../loading/label-files.ts';
import type { LabelFile } from '../loading/label-files.ts';
import { LabelFunctions } from './label-functions.ts';
import { ownLabelsAppearance } from '../appearance/own-labels-appearance.ts';
import type { LabelTarget } from './label-target.ts';
import { LastWork } from '../model/last-work.ts';
import { labelPartOf, placeLabels, refuseRadar } from './place-labels.ts';
import { describeLabels, hideChosen, styleLabels } from '../model/view-labels.ts';
import type { LabelEntry } from '../model/view-labels.ts';

/** What the controller of labels needs of its element. */
export interface LabelControllerHost extends AttachmentHost<LabelTarget> {
  /** What the author says about labels. @param ids - of the file */
  said(ids: readonly number[]): LabelChildren;
  /** Load the file, where its values need a change before they are labels. */
  load?: typeof loadLabelFile;
  readonly wanted: () => {
    readonly src: string | null;
    readonly table: string | null;
    readonly hidden: boolean;
    readonly transferFunction: string | null;
    readonly only?: string | null;
  };
  /** The labels, or their appearance, have changed. */
  changed(): void;
}

/** The labels that are shown, and their volume. */
interface Applied {
  readonly map: LabelMap;
  readonly table: LabelTable | null;
  /** Whether the volume itself is the labels. */
  readonly isOwn: boolean;
  readonly volume: Volume;
}

/** Loads labels and their table, resamples them to the volume's grid, and keeps the choices of persons and scripts. */
export class LabelController extends AttachmentController<LabelTarget, LabelControllerHost> {
  /** For each label, the choice of a person or a script: whether it is hidden. */
  readonly #chosen = new Map<number, boolean>();
  /** The same: whether hidden labels stay faintly visible, as ghosts; null where nobody has chosen. */
  #chosenGhosts: boolean | null = null;
  /** What the author shows, and nothing else. */
  #only: OnlyLabels | null = null;
  readonly #files = new LastWork<LabelFile>();
  readonly #tables = new LastWork<LabelTable>();
  readonly #placed = new LastWork<LabelMap>();
  #applied: Applied | null = null;
  #entries: readonly LabelEntry[] = [];
  #nameOf: (id: number) => string | null = () => null;
  /** The error in what the author says about labels. */
  #saidError: VolumeViewError | null = null;
  readonly #functions = new LabelFunctions();
  /** The window for which transfer functions of labels were read. */
  #window = '';
  #applies = 0;
  /** Whether the target could show ghosts when labels were styled last. */
  #showsGhosts = false;
  /** Whether the last request has failed. */
  #isLacking = false;

  /**
   * The labels, starting with "no label"; a volume that is itself labels never shows that one, so it is left out. Empty before the
   * labels are loaded.
   */
  get entries(): readonly LabelEntry[] {
    return this.#applied?.isOwn ? this.#entries.slice(1) : this.#entries;
  }

  /** The labels as a pane of the volume shows them; null where it has none. @param opacity - over its grey values, 0..1 */
  inPane(volume: Volume | null, opacity: number): PaneLabels | null {
    const applied = this.#applied;
    const worldToIndex =
      applied && applied.volume === volume && invertAffine((volume.grid as CartesianGrid).indexToWorld);
    if (!worldToIndex) return null;
    // A volume that is itself labels already has their colours.
    return paneLabels(
      { map: applied.map, styles: styleLabels(this.#entries) },
      { worldToIndex, nameOf: this.#nameOf, opacity: applied.isOwn ? 0 : opacity },
    );
  }

  protected override unread(target: LabelTarget): void {
    this.#isLacking = true;
    // The labels of another volume do not fit this one.
    if (this.#applied?.volume !== target.volume) this.#apply(null).catch(() => {});
  }

  protected override forget(target: LabelTarget): void {
    this.#files.forget();
    this.#tables.forget();
    this.#placed.forget();
    this.#applied = null;
    this.#applies++;
    this.#entries = [];
    target.replaceTransferFunction(null);
    target.track(target.show(null).catch(() => {}));
    this.host.changed();
  }

  /** The settings of labels, or the choices of a person, have changed. @param isChoice - whether nothing but the choices has changed */
  restyle(isChoice = false): void {
    const target = this.host.target();
    if (this.#applied && target)
      target.track(this.#apply(this.#applied, isChoice).catch((error: unknown) => this.fail(error)));
  }

  /** The volume's appearance has changed: presets of labels span its window. */
  rewindow(): void {
    const target = this.host.target();
    if (
      (this.#window && this.#window !== String(target?.window)) ||
      (this.#hasGhosts && this.#showsGhosts !== target?.showsGhosts)
    )
      this.restyle();
  }

  /** Choose which labels are hidden: these, and no others. @param ghosts - whether they stay faintly visible; unchanged where absent */
  choose(hidden: Iterable<number>, ghosts = this.#hasGhosts): void {
    this.#chosenGhosts = ghosts;
    const all = new Set(hidden);
    for (const { id } of this.#entries) this.#chosen.set(id, false);
    for (const id of all) this.#chosen.set(id, true);
    this.restyle(true);
  }

  /** Use the author's setting for a label again. */
  forgetChoice(id: number): void {
    this.#chosen.delete(id);
  }

  /** Use the author's settings again. */
  forgetChoices(): void {
    this.#chosen.clear();
    this.#chosenGhosts = null;
  }

  get #hasGhosts(): boolean {
    return this.#chosenGhosts ?? this.#only?.ghost ?? false;
  }

  get #choices(): { readonly chosen: ReadonlyMap<number, boolean>; readonly ghosts: boolean } {
    return { chosen: this.#chosen, ghosts: this.#hasGhosts && this.#showsGhosts };
  }

  protected override async read(target: LabelTarget, signal: AbortSignal): Promise<void> {
    const { src, table, hidden } = this.host.wanted();
    if (hidden) {
      target.cleared();
      target.reportFiles([]);
      return this.#apply(null);
    }
    // Of a pyramid only what the volume shows is read: the target reports the volume when it is there. Other files with these letters wait, too.
    const isPyramid = !this.host.load && /zarr|ozx/.test(src ?? '');
    if (isPyramid && !target.volume) return;
    const part = isPyramid ? labelPartOf(target.volume!) : undefined;
    // Both load at the same time; if one fails, an error of the other is not reported.
    const [file, names] = await Promise.all([
      src
        ? this.#files.get(`${src} ${JSON.stringify(part)}`, signal, (stop) =>
            (this.host.load ?? loadLabelFile)(src, stop, target.fetch, part),
          )
        : null,
      table ? this.#tables.get(table, signal, (stop) => loadTable(table, stop, target.fetch)) : null,
    ]);
    signal.throwIfAborted();
    const { volume } = target;
    if (!volume) return; // The target reports the volume when it is there.
    refuseRadar(volume);
    if (!src && !table && !volume.named)
      throw new VolumeViewError(
        'attribute/invalid',
        '<volume-labels> got neither src nor table; expected src="labels.nii.gz" with the labels, or table="names.tsv" with the names of those that the volume has.',
      );
    const from = file ?? {
      ...labelsIn(volume, target.file),
      format: volume.format,
      anatomical: volume.anatomical,
      named: volume.named,
    };
    if (!file && !volume.isDiscrete) return target.takeAsLabels(volume); // The target reports this volume too when it is there.
    const url = src ?? target.file;
    const map = await this.#placed.get(`${url} ${JSON.stringify([volume.grid, part])}`, signal, (stop) =>
      placeLabels(from, volume, url, stop),
    );
    signal.throwIfAborted();
    this.#isLacking = false;
    target.reportFiles([
      [src ?? '', file?.left ?? []],
      [table ?? '', names?.problems ?? []],
    ]);
    await this.#apply({ map, table: withNamed(names, from.named), isOwn: !file, volume });
  }

  /** Describe the labels. */
  #describe(applied: Applied | null): void {
    const { overrides, error } = this.host.said(applied?.map.ids ?? []);
    const wanted = this.host.wanted();
    const only = readOnly(wanted.only ?? null, applied?.map.ids ?? []);
    this.#only = only.value;
    const transferFunction = wanted.transferFunction?.trim() || null;
    const said = { overrides, transferFunction, ...(this.#only && { only: this.#only.ids }), ...this.#choices };
    this.#entries = applied ? describeLabels(applied.map.ids, { table: applied.table, ...said }) : [];
    const names = new Map(this.#entries.map(({ id, name }) => [id, name]));
    this.#nameOf = (id) => names.get(id) || null;
    this.#saidError = error ?? only.error;
  }

  async #apply(applied: Applied | null, isChoice = false): Promise<void> {
    const target = this.host.target();
    this.#applied = applied;
    const call = ++this.#applies;
    this.#showsGhosts = target?.showsGhosts === true;
    if (isChoice) this.#entries = hideChosen(this.#entries, this.#choices);
    else this.#describe(applied);
    target?.replaceTransferFunction(applied?.isOwn ? ownLabelsAppearance(this.#entries) : null);
    this.host.changed();
    const reading = target?.window && applied ? this.#functions.read(this.#entries, target.window) : null;
    this.#window = reading ? String(target!.window) : '';
    const groups = reading && (await reading);
    if (call !== this.#applies) return;
    const shown =
      applied && !applied.isOwn
        ? {
            map: applied.map,
            styles: styleLabels(this.#entries, groups?.numbers),
            ...(groups?.functions.length && { functions: groups.functions }),
          }
        : null;
    await target?.show(applied && { shown, nameOf: this.#nameOf });
    const wrong = this.#saidError ?? groups?.error ?? (groups && applied?.isOwn ? ownHaveNone() : null);
    if (wrong) this.fail(wrong);
    else if (applied && !this.#isLacking) target?.cleared();
  }
}

/** A table, completed by labels that only the file names. */
function withNamed(table: LabelTable | null, named: readonly NamedLabel[] = []): LabelTable | null {
  if (named.length === 0) return table;
  const rows = named.map((label): [number, LabelRow] => [label.id, { ...label, opacity: 1, hidden: false }]);
  return { format: 'file', problems: [], ...table, rows: new Map([...rows, ...(table?.rows ?? [])]) };
}

/** In such a volume each label is a single value. */
function ownHaveNone(): VolumeViewError {
  return new VolumeViewError(
    'attribute/invalid',
    'transfer-function of <volume-labels> or of a <volume-label> is for labels that lie over a volume, and here the volume is the labels; expected none. Use color and opacity.',
  );
}

/** Load a table; its unusable parts are reported to the author of the page. */
async function loadTable(url: string, signal: AbortSignal, fetch: LabelTarget['fetch']): Promise<LabelTable> {
  const table = await loadLabelTable(url, signal, fetch);
  if (table.problems.length > 0)
    console.warn(
      `<volume-labels>: of the ${table.format} table ${url} some could not be used.\n${table.problems.join('\n')}`,
    );
  return table;
}
