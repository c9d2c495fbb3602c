import type { ErrorCode } from '../core/errors.ts';
import type { BlankTerms } from './blank-terms.ts';
import type { ClipTerms } from './clip-terms.ts';
import type { HandleTerms } from './handle-terms.ts';
import type { LabelTerms } from './label-terms.ts';
import type { MeasureTerms } from './measure-terms.ts';
import type { NoticeTerms } from './notice-terms.ts';
import type { PlaneTerms } from './plane-terms.ts';
import type { ReadoutTerms } from './readout-terms.ts';

/** Names of hues and of what has none. */
export type ColorName =
  | 'red' | 'orange' | 'yellow' | 'green' | 'turquoise' | 'blue' | 'violet' | 'pink' | 'brown' | 'white' | 'grey' | 'black';

/** What an error is about: the first word of its code, or the whole code where that has words of its own. */
type ErrorTopic = ErrorCode extends infer Code ? (Code extends `${infer Topic}/${string}` ? Topic : Code) : never;

/**
 * All words that a person reads in the elements, or hears. Numbers and times come as text, already written as the
 * language writes them. English ones are built in; a translation may leave out any.
 */
export type Terms = ViewTerms & CompanionTerms & ControlTerms & SliceTerms & ReadoutTerms & HandleTerms & ClipTerms & LabelTerms & MeasureTerms & NoticeTerms & PlaneTerms & BlankTerms;

/** The words of <volume-view>. */
export interface ViewTerms {
  /** Name of a picture that the page gives none. */
  readonly volumePicture: string;
  /** What the keys do to the picture. */
  readonly cameraKeys: string;
  readonly loading: string;
  readonly loadingPercent: (percent: string) => string;
  readonly decoding: string;
  readonly loaded: string;
  /** What went wrong, for the reader of a page; what its author can do follows in English. The code itself goes before its topic. */
  readonly errors: Readonly<Record<ErrorTopic | 'labels', string> & Partial<Record<ErrorCode, string>>>;
  /** On a button below an error that may pass. */
  readonly tryAgain: string;
  /** Where the rings around a radar are marked. */
  readonly north: string;
  readonly kilometres: (distance: string) => string;
  /** In the corner of a radar's picture: by how much its heights are stretched. */
  readonly heightsTimes: (factor: string) => string;
}

/** Sides that a volume is seen from: of a box or a patient, or of the weather over a map. */
export type StandardViewName = 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom' | 'south' | 'north' | 'west' | 'east' | 'above';

/** The words of its controls. */
export interface ControlTerms {
  /** Name of all of them together. */
  readonly controls: string;
  readonly playScans: string;
  readonly pauseScans: string;
  /** Opens the list of standard views. */
  readonly views: string;
  readonly view: Readonly<Record<StandardViewName, string>>;
  /** Letters of the sides, as radiologists and maps write them. */
  readonly letter: Readonly<Record<StandardViewName, string>>;
  /** Name of the marker with these letters. */
  readonly orientation: string;
  readonly zoomIn: string;
  readonly zoomOut: string;
  /** The picture goes around by itself, or does no longer. */
  readonly startRotation: string;
  readonly stopRotation: string;
  readonly resetView: string;
  readonly fullscreen: string;
  readonly leaveFullscreen: string;
  /** Opens the list of further actions. */
  readonly more: string;
  readonly savePicture: string;
  readonly copyView: string;
  readonly copied: string;
  /** Above a text that the browser did not let us copy. */
  readonly copyByHand: string;
  /** The code of a frame that shows the view in another page. */
  readonly copyEmbed: string;
  readonly copiedEmbed: string;
  readonly copyEmbedByHand: string;
  /** The page for frames is not where it was looked for. */
  readonly embedMissing: (address: string) => string;
  readonly embedFailed: string;
  readonly help: string;
  readonly close: string;
  /** What is said at first, to those with a mouse and those with fingers. */
  readonly mouseHint: string;
  readonly touchHint: string;
  readonly saveFailed: string;
  /** What can be done, and how. */
  readonly helpLines: readonly (readonly [what: string, how: string])[];
}

/** The words of panes with slices. */
export interface SliceTerms {
  readonly slice: Readonly<Record<'axial' | 'coronal' | 'sagittal' | 'oblique', string>>;
  /** A slice and where it is. */
  readonly sliceAt: (slice: string, place: string) => string;
  readonly millimetres: (length: string) => string;
  /** What is shown of a slice that is not thin. */
  readonly slab: Readonly<Record<'average' | 'max' | 'min', (thickness: string) => string>>;
  /** Width and level of the window, as radiologists write them. */
  readonly window: (width: string, level: string) => string;
  /** The same in words, for those who do not know these letters: at which values black ends and white begins. */
  readonly windowWords: (window: { readonly width: string; readonly level: string; readonly black: string; readonly white: string }) => string;
  /** What the keys do. */
  readonly sliceKeys: string;
  /** The crosshair is outside of the volume. */
  readonly noValue: string;
  readonly loading: string;
}

/** The words of its companions. */
export interface CompanionTerms {
  /** A companion's hint; the id is null where the page names none. */
  readonly noView: (id: string | null) => string;
  readonly noVolume: string;

  /** Two numbers, or a number and a value with its unit. */
  readonly range: (low: string, high: string) => string;
  readonly colors: Readonly<Record<ColorName, string>>;
  readonly lightColor: (color: string) => string;
  readonly darkColor: (color: string) => string;
  /** A legend that has no name of its own. */
  readonly legend: string;
  /** A scale in words: its name, its range, and its colours from the lowest value. */
  readonly scale: (label: string, range: string, colors: readonly string[]) => string;
  /** A colour, and the value at which it begins. */
  readonly colorFrom: (color: string, value: string) => string;

  readonly time: string;
  readonly scan: string;
  readonly previousScan: string;
  readonly nextScan: string;
  readonly play: string;
  readonly pause: string;
  /** Short for Coordinated Universal Time. */
  readonly utc: string;
  readonly scanOf: (number: string, count: string) => string;
  readonly noScan: string;
  /** There is nothing to choose from; the time is null where nobody knows it. */
  readonly oneScan: (time: string | null) => string;

  readonly transferFunction: string;
  readonly stopOf: (number: string, count: string) => string;
  readonly stopState: (value: string, opacity: string, color: string) => string;
  /** What the keys do to a stop. */
  readonly stopKeys: string;
  /** The unit is empty where there is none. */
  readonly valueIn: (unit: string) => string;
  readonly opacityPercent: string;
  readonly color: string;
  readonly colorOfStop: string;
  readonly colorOfBand: (range: string) => string;
  readonly opacityOfBand: (range: string) => string;
  readonly opacity: string;
  readonly light: string;
  readonly add: string;
  readonly addTip: string;
  readonly remove: string;
  readonly removeTip: string;
  readonly undo: string;
  readonly undoTip: string;
  readonly redo: string;
  readonly redoTip: string;
  readonly reset: string;
  readonly resetTip: string;
  readonly copy: string;
  readonly copyTip: string;
  readonly copied: string;
  readonly copyRefused: string;
  readonly copyByHand: string;
}
