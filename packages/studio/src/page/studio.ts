// The studio at work: the lesson with its history, what of it is before the author, and what the author does.
import {
  addNote,
  addQuestion,
  addStep,
  changeNote,
  changeQuestion,
  changeView,
  isSameView,
  removeStep,
} from '../model/edit.ts';
import { change, redo, replace, startHistory, undo } from '../model/history.ts';
import type { History } from '../model/history.ts';
import { cameraAttributes, emptyLesson } from '../model/lesson.ts';
import type { Lesson, QuestionType, ViewAttributes } from '../model/lesson.ts';
import { openLesson } from '../data/export-lesson.ts';
import type { OpenedLesson } from '../data/export-lesson.ts';
import { findData, findWork, forgetWork, keepData, keepWork } from '../data/keep-work.ts';
import { asFiles, prepareData } from '../data/prepare.ts';
import type { LessonData } from '../data/prepare.ts';
import { loadSample } from '../data/samples.ts';
import type { Sample } from '../data/samples.ts';
import { english } from '../words.ts';
import { startBefore } from './before.ts';
import type { Before, Placing } from './before.ts';
import { applyView, findPicture, findSource, readCamera } from './view-element.ts';
import type { Home, View } from './view-element.ts';

/** How an edit is done. */
interface EditOptions {
  /** See `History`: edits of one mark are undone together. */
  readonly mark?: string;
  /** Whether the camera as it is now becomes a part of the lesson: so for all that is about the picture. */
  readonly withCamera?: boolean;
}

/** Milliseconds after an edit until it is kept. */
const keepAfter = 300;

export class Studio {
  readonly words = english;
  history: History<Lesson> = startHistory(emptyLesson);
  before: Before = startBefore;
  data: LessonData | null = null;
  home: Home | null = null;
  /** An element that gets the focus after the page was drawn again, by its selector. */
  focusNext: string | null = null;
  #keepTimer: ReturnType<typeof setTimeout> | undefined;
  #sample: Sample | null = null;

  /** @param draw - draws the page again */
  constructor(readonly draw: () => void) {}

  get lesson(): Lesson {
    return this.history.present;
  }

  show(changes: Partial<Before>): void {
    this.before = { ...this.before, ...changes };
    this.draw();
  }

  /** Back to the first page, to open another scan. */
  showStart(): void {
    this.show({ screen: 'start', hasSource: false, problem: null, said: '' });
  }

  /** Goes on with what the browser keeps. */
  async begin(): Promise<void> {
    try {
      const kept = await findWork();
      const id = kept?.present.data;
      if (kept && id) {
        this.history = kept;
        this.data = await findData(id);
      }
      this.show({ screen: this.data ? 'edit' : 'start' });
    } catch {
      this.show({ screen: 'start', keeping: 'not-kept' });
    }
    if (this.data) this.showLesson(true);
  }

  // The lesson.

  edit(how: (lesson: Lesson) => Lesson, { mark, withCamera = false }: EditOptions = {}): void {
    const now = withCamera ? this.#withCamera(this.lesson) : this.lesson;
    this.#take(change(this.history, how(now), mark ?? null), false);
  }

  undo(): void {
    this.#go(undo(this.history), this.words.undone);
  }

  redo(): void {
    this.#go(redo(this.history), this.words.redone);
  }

  #go(history: History<Lesson> | null, said: string): void {
    if (!history) return;
    const [from, to] = [this.lesson.view, history.present.view];
    this.#take(
      history,
      cameraAttributes.some((name) => from[name] !== to[name]),
    );
    this.show({ said, placing: null });
  }

  #take(history: History<Lesson>, goes: boolean): void {
    this.history = history;
    const { steps, notes } = this.lesson;
    this.before = {
      ...this.before,
      step: steps.some(({ id }) => id === this.before.step) ? this.before.step : null,
      note: notes.some(({ id }) => id === this.before.note) ? this.before.note : null,
    };
    this.showLesson(goes);
    this.#keepSoon();
  }

  #withCamera(lesson: Lesson): Lesson {
    const view = findPicture();
    return view?.volume ? changeView(lesson, readCamera(view, this.home)) : lesson;
  }

  /** The view that the author sees, as a step would keep it. */
  get seen(): ViewAttributes {
    return this.#withCamera(this.lesson).view;
  }

  /** @param goes - see `applyView` */
  showLesson(goes: boolean): void {
    this.draw();
    const view = findPicture();
    if (!view) return;
    void this.#showData(view);
    applyView(view, this.lesson.view, goes);
  }

  /** The files that the picture has. */
  #shown: LessonData | null = null;

  async #showData(view: View): Promise<void> {
    const { data: id } = this.lesson;
    if (id !== (this.data?.id ?? null) && id !== null) this.data = await findData(id).catch(() => null);
    if (!this.data || (this.#shown === this.data && view.files)) return;
    this.#shown = this.data;
    this.home = null;
    view.files = asFiles(this.data);
    this.draw(); // Small pictures are of other data now.
  }

  addStep(): void {
    this.edit((lesson) => addStep(lesson, this.before.step, this.#openNotes()), { withCamera: true });
    const found = this.lesson.steps.findIndex(({ id }) => id === this.before.step);
    const added =
      this.lesson.steps[found < 0 || found + 1 >= this.lesson.steps.length ? this.lesson.steps.length - 1 : found + 1];
    this.focusNext = `#${added.id}-title`;
    this.show({ step: added.id, tab: 'steps', said: '' });
  }

  #openNotes(): readonly string[] {
    return this.lesson.steps.find(({ id }) => id === this.before.step)?.notes ?? [];
  }

  /** Says whether the picture is still that of the step; a camera moves many times a second. */
  cameraMoved(): void {
    if (this.before.step !== null && !this.#isMoving) {
      this.#isMoving = true;
      setTimeout(() => {
        this.#isMoving = false;
        this.draw();
      }, 200);
    }
  }

  #isMoving = false;

  /** Selects a step, and shows its view. That is no edit. */
  openStep(id: string | null): void {
    const step = this.lesson.steps.find((one) => one.id === id);
    this.before = { ...this.before, step: step?.id ?? null, note: null };
    if (!step) return this.draw();
    if (!isSameView(this.lesson.view, step.view))
      this.history = replace(this.history, { ...this.lesson, view: step.view });
    this.showLesson(true);
    this.#keepSoon();
  }

  removeStep(id: string): void {
    const at = this.lesson.steps.findIndex((step) => step.id === id);
    this.edit((lesson) => removeStep(lesson, id));
    const next = this.lesson.steps[Math.min(at, this.lesson.steps.length - 1)];
    this.focusNext = next ? `#${next.id}-open` : '#add-step';
    this.openStep(next?.id ?? null);
  }

  addQuestion(stepId: string, type: QuestionType): void {
    this.edit((lesson) => addQuestion(lesson, stepId, type));
    const added = this.lesson.steps.find(({ id }) => id === stepId)?.questions.at(-1);
    if (added) this.focusNext = `#${added.id}-title`;
    this.draw();
  }

  // Places.

  /** A place of the picture was shown, by a click or by keys. */
  async place(clientX: number, clientY: number): Promise<void> {
    const { placing } = this.before;
    const view = findPicture();
    if (!placing || !view) return;
    const found = await view.positionFromPoint(clientX, clientY);
    if (!found) return this.show({ said: this.words.placeNothing, problem: this.words.placeNothing });
    const position = found.position.map((x) => Number(x.toPrecision(5))).join(' ');
    const { id } = placing;
    if (placing.kind === 'question' && id !== null)
      this.edit((lesson) => changeQuestion(lesson, id, { position }), { withCamera: true });
    else if (id !== null) this.edit((lesson) => changeNote(lesson, id, { position }), { withCamera: true });
    else {
      this.edit((lesson) => addNote(lesson, position), { withCamera: true });
      const added = this.lesson.notes.at(-1)!;
      this.before = { ...this.before, note: added.id };
    }
    this.focusNext = placing.kind === 'question' ? `#${id}-position` : `#${this.before.note}-label`;
    this.show({ placing: null, problem: null, said: this.words.placed });
  }

  beginPlacing(placing: Placing): void {
    this.focusNext = '#place-middle';
    this.show({ placing, problem: null });
  }

  endPlacing(): void {
    this.show({ placing: null, problem: null });
  }

  // Data.

  openSample(sample: Sample): Promise<void> {
    return this.#whileBusy(this.words.preparing, async () => {
      const data = await prepareData({ files: await loadSample(sample.name), series: null, scan: 0 });
      this.#sample = sample;
      await this.#useData(data);
    });
  }

  /** The scan in the picture of the first page becomes that of the lesson. */
  takeSource(): Promise<void> {
    const view = findSource();
    const files = view?.files;
    if (!view || !files) return Promise.resolve();
    return this.#whileBusy(this.words.preparing, async () => {
      const chosen = [...files].filter((one): one is File => one instanceof File);
      const data = await prepareData({ files: chosen, series: view.series, scan: view.scan?.index ?? 0 });
      this.#sample = null;
      await this.#useData(data);
    });
  }

  async #useData(data: LessonData): Promise<void> {
    await this.#keepData(data);
    this.data = data;
    const sample = this.#sample;
    const words = sample && { alt: this.words.samples[sample.name], credits: sample.credits, licence: sample.licence };
    this.before = { ...this.before, screen: 'edit', hasSource: false, problem: null, said: '' };
    // Another scan has other places and values: only the looks of ours are its own.
    this.edit((lesson) => ({ ...lesson, ...words, data: data.id, ...(lesson.data === null ? { view: {} } : {}) }));
    if (this.history.past.length === 1 && this.history.past[0].data === null) this.history = startHistory(this.lesson);
    this.focusNext = '#add-step';
    this.showLesson(true);
  }

  async #keepData(data: LessonData): Promise<void> {
    try {
      await keepData(data);
    } catch {
      this.before = { ...this.before, keeping: 'not-kept' };
    }
  }

  /** Opens a lesson that was exported. */
  openLesson(file: File): Promise<void> {
    return this.#whileBusy(this.words.keeping, async () => {
      const opened = await openLesson(file);
      if (!opened) throw new Error(this.words.notLesson);
      await this.#useLesson(opened);
    });
  }

  async #useLesson({ lesson, data, left }: OpenedLesson): Promise<void> {
    if (data) {
      await this.#keepData(data);
      this.data = data;
    }
    this.history = startHistory({ ...lesson, data: data?.id ?? null });
    this.#keepSoon();
    const { lessonOpened, lessonWithoutData, lessonLeft } = this.words;
    const said = [
      data ? lessonOpened : lessonWithoutData,
      ...(left.length > 0 ? [lessonLeft(left.join(', '))] : []),
    ].join(' ');
    this.show({
      screen: data ? 'edit' : 'start',
      tab: 'steps',
      step: lesson.steps[0]?.id ?? null,
      ...(data && left.length === 0 ? { said, problem: null } : { said: '', problem: said }),
    });
    this.showLesson(true);
  }

  /** A ZIP archive or a page that was dropped: a lesson, or else a scan. */
  async openDropped(file: File): Promise<void> {
    const lesson = await openLesson(file).catch(() => null);
    if (lesson) return this.#whileBusy(this.words.keeping, () => this.#useLesson(lesson));
    const view = findSource();
    if (!view) return;
    view.series = null;
    view.files = [file];
  }

  async startAgain(): Promise<void> {
    clearTimeout(this.#keepTimer);
    await forgetWork().catch(() => undefined);
    this.history = startHistory(emptyLesson);
    this.data = this.#shown = this.#sample = null;
    this.show({
      screen: 'start',
      dialog: null,
      tab: 'steps',
      step: null,
      note: null,
      hasSource: false,
      problem: null,
      keeping: 'kept',
    });
  }

  /** What fails is said in words, and changes nothing. */
  async #whileBusy(words: string, act: () => Promise<void>): Promise<void> {
    this.show({ busy: words, problem: null });
    try {
      await act();
      this.show({ busy: null });
    } catch (error) {
      const reason = error instanceof Error ? error.message : '';
      const { partFailed, prepareFailed, notLesson } = this.words;
      const problem = reason.startsWith('parts/') ? partFailed : reason === notLesson ? reason : prepareFailed(reason);
      this.show({ busy: null, problem });
    }
  }

  // What the browser keeps.

  #keepSoon(): void {
    clearTimeout(this.#keepTimer);
    if (this.before.keeping === 'not-kept') return;
    this.show({ keeping: 'keeping' });
    this.#keepTimer = setTimeout(() => void this.#keep(), keepAfter);
  }

  async #keep(): Promise<void> {
    const kept = await keepWork(this.history).then(
      () => 'kept' as const,
      () => 'not-kept' as const,
    );
    this.show({ keeping: kept });
  }
}
