// What is before the author, and is no part of the lesson: the screen, the tab, what is open, and what is said.

export type Tab = 'steps' | 'look' | 'cut' | 'notes' | 'about';

/** What waits for a click on the picture. */
export interface Placing {
  readonly kind: 'note' | 'question';
  /** null for a new note. */
  readonly id: string | null;
}

/** What is before the author, and is no part of the lesson. */
export interface Before {
  readonly screen: 'opening' | 'start' | 'edit';
  readonly tab: Tab;
  readonly step: string | null;
  readonly note: string | null;
  readonly placing: Placing | null;
  readonly dialog: 'export' | 'preview' | 'again' | null;
  /** What takes a while, in words. */
  readonly busy: string | null;
  /** What went wrong, in words. */
  readonly problem: string | null;
  /** The last thing that happened, in words. */
  readonly said: string;
  readonly keeping: 'kept' | 'keeping' | 'not-kept';
  /** Whether a scan was opened and is not yet that of the lesson. */
  readonly hasSource: boolean;
}

/** As the page begins. */
export const startBefore: Before = {
  screen: 'opening',
  tab: 'steps',
  step: null,
  note: null,
  placing: null,
  dialog: null,
  busy: null,
  problem: null,
  said: '',
  keeping: 'kept',
  hasSource: false,
};
