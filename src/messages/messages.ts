import type { ErrorCode } from '../core/errors.ts';
import type { AuthoringMessages } from './authoring-messages.ts';
import type { BlankMessages } from './blank-messages.ts';
import type { ClipMessages } from './clip-messages.ts';
import type { CompareMessages } from './compare-messages.ts';
import type { CurveMessages } from './curve-messages.ts';
import type { DropMessages } from './drop-messages.ts';
import type { HandleMessages } from './handle-messages.ts';
import type { LabelMessages } from './label-messages.ts';
import type { MeasureMessages } from './measure-messages.ts';
import type { NoteMessages } from './note-messages.ts';
import type { NoticeMessages } from './notice-messages.ts';
import type { PlaneMessages } from './plane-messages.ts';
import type { QuestionMessages } from './question-messages.ts';
import type { ReadoutMessages } from './readout-messages.ts';
import type { TourMessages } from './tour-messages.ts';

/** Names of hues, and of colours without a hue. */
export type ColorName =
  | 'red'
  | 'orange'
  | 'yellow'
  | 'green'
  | 'turquoise'
  | 'blue'
  | 'violet'
  | 'pink'
  | 'brown'
  | 'white'
  | 'grey'
  | 'black';

/** The topic of an error: the first word of its code, or the whole code where it has a message of its own. */
type ErrorTopic = ErrorCode extends infer Code ? (Code extends `${infer Topic}/${string}` ? Topic : Code) : never;

/**
 * All messages of the elements, for readers and for screen readers. Numbers and times are passed as text, already formatted for the
 * language. The English messages are built in; a translation may leave out any message.
 */
export type Messages = ViewMessages &
  CompanionMessages &
  ControlMessages &
  SliceMessages &
  ReadoutMessages &
  HandleMessages &
  ClipMessages &
  LabelMessages &
  MeasureMessages &
  NoteMessages &
  AuthoringMessages &
  NoticeMessages &
  PlaneMessages &
  QuestionMessages &
  TourMessages &
  CompareMessages &
  CurveMessages &
  DropMessages &
  BlankMessages;

/** The messages of <volume-view>. */
export interface ViewMessages {
  /** Name of a picture where the page gives none. */
  readonly volumePicture: string;
  /** Help: how keys move the picture. */
  readonly cameraKeys: string;
  readonly loading: string;
  readonly loadingPercent: (percent: string) => string;
  readonly decoding: string;
  readonly loaded: string;
  /**
   * The error messages for the reader of a page; what its author can do follows in English. A message for the code is used before the
   * message for its topic.
   */
  readonly errors: Readonly<Record<ErrorTopic | 'labels', string> & Partial<Record<ErrorCode, string>>>;
  /** The button below an error that may be temporary. */
  readonly tryAgain: string;
  /** The mark of the north at the rings around a radar. */
  readonly north: string;
  readonly kilometres: (distance: string) => string;
  /** In the corner of a radar's picture: the factor by which its heights are exaggerated. */
  readonly heightsTimes: (factor: string) => string;
}

/** Standard views, named by the side of the viewer: of a box or a patient, or of the weather over a map. */
export type StandardViewName =
  | 'front'
  | 'back'
  | 'left'
  | 'right'
  | 'top'
  | 'bottom'
  | 'south'
  | 'north'
  | 'west'
  | 'east'
  | 'above';

/** The messages of the controls of <volume-view>. */
export interface ControlMessages {
  /** Name of all the controls together. */
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
  /** The picture starts or stops to rotate by itself. */
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
  /** Above a text that the browser did not allow to be copied. */
  readonly copyByHand: string;
  /** The address of the page with the present view. */
  readonly copyLink: string;
  readonly copiedLink: string;
  readonly copyLinkByHand: string;
  readonly linkFailed: string;
  /** The code of an iframe that shows the view in another page. */
  readonly copyEmbed: string;
  readonly copiedEmbed: string;
  readonly copyEmbedByHand: string;
  /** The page for iframes was not found at its address. */
  readonly embedMissing: (address: string) => string;
  readonly embedFailed: string;
  readonly help: string;
  readonly close: string;
  /** The first hint, for people with a mouse, and for people with a touch screen. */
  readonly mouseHint: string;
  readonly touchHint: string;
  readonly saveFailed: string;
  /** Help: actions, and how to do them. */
  readonly helpLines: readonly (readonly [what: string, how: string])[];
}

/** What a window of a file is for. */
export type WindowName =
  | 'abdomen'
  | 'bone'
  | 'brain'
  | 'chest'
  | 'head'
  | 'liver'
  | 'lung'
  | 'mediastinum'
  | 'neck'
  | 'pelvis'
  | 'soft tissue'
  | 'spine'
  | 'vessels'
  | 'normal'
  | 'harder'
  | 'softer';

/** The messages of panes with slices. */
export interface SliceMessages {
  readonly slice: Readonly<Record<'axial' | 'coronal' | 'sagittal' | 'oblique', string>>;
  /** A slice and its position. */
  readonly sliceAt: (slice: string, place: string) => string;
  readonly millimetres: (length: string) => string;
  readonly micrometres: (length: string) => string;
  readonly nanometres: (length: string) => string;
  /** The value that is shown of a thick slice. */
  readonly slab: Readonly<Record<'average' | 'max' | 'min', (thickness: string) => string>>;
  /** Width and level of the window, as radiologists write them. */
  readonly window: (width: string, level: string) => string;
  /** The same in words, for readers who do not know these letters: the values at which black ends and white begins. */
  readonly windowWords: (window: {
    readonly width: string;
    readonly level: string;
    readonly black: string;
    readonly white: string;
  }) => string;
  /** The choice among the windows of the file. */
  readonly windowChoice: string;
  readonly windowNames: Readonly<Record<WindowName, string>>;
  /** A window without a name that is known. */
  readonly windowNumber: (number: string) => string;
  /** A window that is none of the file's. */
  readonly otherWindow: string;
  /** Help for the keys. */
  readonly sliceKeys: string;
  /** The crosshair is outside the volume. */
  readonly noValue: string;
  readonly loading: string;
}

/** The messages of the companions of <volume-view>. */
export interface CompanionMessages {
  /** The hint of a companion; the id is null where the page names none. */
  readonly noView: (id: string | null) => string;
  readonly noVolume: string;

  /** Two numbers, or a number and a value with its unit. */
  readonly range: (low: string, high: string) => string;
  readonly colors: Readonly<Record<ColorName, string>>;
  readonly lightColor: (color: string) => string;
  readonly darkColor: (color: string) => string;
  /** A legend without a name of its own. */
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
  /** There is only one scan; its time is null where it is unknown. */
  readonly oneScan: (time: string | null) => string;

  readonly transferFunction: string;
  readonly stopOf: (number: string, count: string) => string;
  readonly stopState: (value: string, opacity: string, color: string) => string;
  /** Help: how keys change a stop. */
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
