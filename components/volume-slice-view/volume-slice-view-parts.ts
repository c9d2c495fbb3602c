// The parts drawn on a slice: letters, place, window, value, scale bar, crosshair.
import { html, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import type { LoadProgress } from '../../src/formats/base/load-request.ts';
import type { Vector3 } from '../../src/volume/matrix.ts';
import { invertAffine, scale, transformPoint } from '../../src/volume/matrix.ts';
import { windowOfFile } from '../../src/panes/gray-levels.ts';
import { joinPaneLabels } from '../../src/panes/join-pane-labels.ts';
import { paneChannels } from '../../src/panes/pane-channels.ts';
import type { PaneLabels } from '../../src/panes/pane-labels.ts';
import { nearestSampler } from '../../src/panes/sample-at.ts';
import type { SlicePane } from '../../src/panes/slice-pane.ts';
import { roundLength } from '../../src/panes/pane-frame.ts';
import { sideLetters, toPlane } from '../../src/panes/slice-plane.ts';
import { nameInFile } from '../../src/volume/labels.ts';
import type { ValueWindow, Volume } from '../../src/volume/volume.ts';
import { isInMillimetres, isPatient } from '../../src/volume/world-axes.ts';
import { socketOf } from '../../src/viewer/model/view-socket.ts';
import type { Language } from '../../src/messages/language.ts';
import type { SliceMessages } from '../../src/messages/messages.ts';
import { extentOf, nameLengths, unitOfPlaces } from '../../src/messages/length-unit.ts';

/** Detail of `cursor-change`. */
export interface SliceCursorDetail {
  /** Position of the crosshair, world units: for medical files mm to the patient's right, front and head. */
  readonly cursor: Vector3;
  /** The value of the voxel at that place; null where there is none. */
  readonly value: number | null;
  /** The name in `<volume-labels>` of the part at that place; null where there is none. */
  readonly label: string | null;
}

/** The language and messages in which a slice is described. */
export interface SliceLocale {
  readonly language: Language;
  readonly messages: SliceMessages;
}

/** Maximum length of the bar, as a share of the width of the pane. */
const longestBar = 0.3;

/** A length in the world of a volume, with its unit where the format has one. */
function writeLength(length: number, volume: Volume, { language, messages }: SliceLocale): string {
  return isInMillimetres(volume) ? language.length(length, extentOf(volume.grid), messages) : language.number(length);
}

/** The position of the slice: `S 23.5 mm`, or a number where the file does not say whose axes they are. */
export function describePlace(pane: SlicePane, { language, messages }: SliceLocale): string {
  const { normal } = pane.plane;
  const { d } = toPlane(pane.plane, pane.place);
  const volume = pane.sliced?.volume;
  const hasUnit = volume !== undefined && isInMillimetres(volume);
  const unit = unitOfPlaces(hasUnit ? extentOf(volume.grid) : Infinity);
  // A tenth of a voxel: a hundredth of a millimetre is a whole cell.
  const finest = unit.perMillimetre * Math.min(...(volume?.grid.spacing ?? [1]));
  const decimals = Math.min(6, Math.max(2, Math.ceil(1 - Math.log10(finest))));
  const place = Number((unit.perMillimetre * d).toFixed(decimals));
  const isSided = volume !== undefined && isPatient(volume);
  const number = language.number(isSided ? Math.abs(place) : place);
  const written = hasUnit ? nameLengths(number, unit, messages) : number;
  return isSided ? `${sideLetters(place < 0 ? scale(normal, -1) : normal)} ${written}` : written;
}

/** The name of the label at the crosshair, and the value there, with its unit. */
export function describeValue(pane: SlicePane, { language, messages }: SliceLocale): string {
  const value = pane.sliced?.valueAt(pane.place) ?? null;
  if (value === null) return messages.noValue;
  const { unit, isDiscrete, channels, grid } = pane.sliced!.volume;
  if (channels) {
    const [x, y, z] = transformPoint(invertAffine(grid.indexToWorld)!, pane.place);
    return channels.list
      .map(({ number, name, samples, slope, intercept }) => {
        const own = slope * nearestSampler({ samples, dimensions: grid.dimensions })(x, y, z) + intercept;
        return `${name || language.number(number)} ${Number.isNaN(own) ? messages.noValue : language.value(own, unit)}`;
      })
      .join(' · ');
  }
  const name = pane.labels?.nameAt(pane.place) ?? (isDiscrete ? nameInFile(pane.sliced!.volume, value) : null);
  if (isDiscrete && name !== null) return name; // The value is only the number of the label.
  return `${name === null ? '' : `${name} · `}${language.value(value, unit)}`;
}

/** The window as text: the meaning of `W 400  L 40`. */
export function describeWindow(pane: SlicePane, locale: SliceLocale): string {
  const { language, messages } = locale;
  const [low, high] = pane.window;
  const { unit } = pane.sliced!.volume;
  const [width, level] = writeWindow(pane, locale);
  const [black, white] = [low, high].map((value) => language.value(Number(value.toPrecision(3)), unit));
  return messages.windowWords({ width, level, black, white });
}

/** Width and level of the window: those that the file says, where it is one of the file's. */
function writeWindow({ sliced, window: [low, high] }: SlicePane, { language }: SliceLocale): readonly [string, string] {
  const { width, level } = windowOfFile([low, high], sliced!.volume) ?? { width: high - low, level: (low + high) / 2 };
  return [language.number(width, 3), language.number(level, 3)];
}

/** A choice among the windows of the file, where it has several. */
export function renderWindows(pane: SlicePane, { language, messages }: SliceLocale): unknown {
  const { volume } = pane.sliced!;
  const { windows = [] } = volume;
  if (windows.length < 2 || pane.look!.colors) return nothing;
  const chosen = windowOfFile(pane.window, volume);
  const nameOf = ({ name }: ValueWindow, i: number): string =>
    (messages.windowNames as Readonly<Record<string, string>>)[name] ?? messages.windowNumber(language.number(i + 1));
  const choose = ({ target }: Event): void => {
    const window = windows[(target as HTMLSelectElement).selectedIndex - (chosen ? 0 : 1)];
    if (window) pane.showWindow([window.from, window.to]);
  };
  return html`<select part="windows" aria-label=${messages.windowChoice} title=${messages.windowChoice} @change=${choose}>
    ${chosen ? nothing : html`<option selected>${messages.otherWindow}</option>`}
    ${windows.map((window, i) => html`<option .selected=${live(window === chosen)}>${nameOf(window, i)}</option>`)}
  </select>`;
}

export function renderTexts(pane: SlicePane, locale: SliceLocale): unknown {
  const { messages } = locale;
  const appearance = pane.look!;
  const length = (value: number): string => writeLength(value, pane.sliced!.volume, locale);
  return html`
    <div class="text top left" part="place">${describePlace(pane, locale)}${appearance.thickness > 0 ? html`<br />${messages.slab[appearance.projection](length(appearance.thickness))}` : nothing}</div>
    ${appearance.colors || pane.sliced!.volume.channels ? nothing : html`<div class="text top right" part="window" title=${describeWindow(pane, locale)}>${messages.window(...writeWindow(pane, locale))}</div>`}
    <div class="text bottom left" part="scale">${renderBar(pane, length)}</div>
    <div class="text bottom right" part="value"><span class="told">${describeValue(pane, locale)}</span></div>
  `;
}

function renderBar(pane: SlicePane, write: (length: number) => string): unknown {
  const {
    frame,
    size: { width },
  } = pane;
  if (!frame || !(width > 0)) return nothing;
  const length = roundLength(frame.scale * width * longestBar);
  return html`${write(length)}<div class="bar" .style=${`inline-size: ${length / frame.scale}px`}></div>`;
}

/** The letters of the patient's sides at the four edges. */
export function renderSides({ plane: { right, up } }: SlicePane): unknown {
  const sides = [
    ['l', scale(right, -1)],
    ['r', right],
    ['t', up],
    ['b', scale(up, -1)],
  ] as const;
  return sides.map(([edge, direction]) => html`<div class="side ${edge}" part="side">${sideLetters(direction)}</div>`);
}

export function renderCrosshair({ point }: SlicePane): unknown {
  if (!point) return nothing;
  return html`<div class="line across" part="crosshair" .style=${`top: ${point[1] - 0.5}px`}></div><div class="line up" part="crosshair" .style=${`left: ${point[0] - 0.5}px`}></div>`;
}

/** The colours over the greys of a volume of a view, or of the pane's own volume: its channels, its layer, and its labels. @param opacity - of labels */
export function labelsOf(view: HTMLElement | null, volume: Volume | null, opacity: number): PaneLabels | null {
  const socket = view && socketOf(view);
  return joinPaneLabels([
    volume && paneChannels(volume),
    socket?.last('overlay')?.inPane(volume) ?? null,
    ...(socket?.parts.map((part) => part.inPane?.(volume, opacity) ?? null) ?? []),
  ]);
}

/** Share of a file that has loaded, 0..1; undefined where it is unknown. */
export function shareOf({ loaded, total, phase }: LoadProgress): number | undefined {
  return phase === 'fetch' && total > 0 ? Math.min(1, loaded / total) : undefined;
}
