// The script of the H5P library: shows a lesson in H5P, keeps where the learner stopped, and reports answers and score as xAPI statements.
// H5P has its contract for content types at h5p.org ("Content type API", "xAPI").
import { buildNode } from './build-node.ts';
import { CourseRecord } from './course-record.ts';
import type { KeptRecord, Statement } from './course-record.ts';
import { locateFiles } from './h5p-files.ts';
import { runScript, trust } from './page-parts.ts';
import { parseLesson } from './parse-lesson.ts';

/** The library's name in H5P, with its version, as in library.json. */
const library = 'H5P.VolumeViewLesson-1.0';

interface XApiEvent {
  readonly data: { statement: Statement };
  setScoredResult(score: number, max: number, content: object, completion?: boolean, success?: boolean): void;
}

interface Dispatcher {
  trigger(event: string | XApiEvent): void;
  createXAPIEventTemplate(verb: string): XApiEvent;
}

interface H5pCore {
  readonly EventDispatcher: new () => Dispatcher;
  getLibraryPath(library: string): string;
  getPath(path: string, contentId: number | string): string;
  VolumeViewLesson?: unknown;
}

/** Of content/content.json. */
interface Content {
  /** HTML of the lesson, in entities: H5P takes it for a text without tags, and changes nothing of it. */
  readonly html?: unknown;
  /** The names that the lesson has for its files, and their paths. */
  readonly files?: unknown;
}

const core = (globalThis as unknown as { H5P: H5pCore }).H5P;

/** What of a `<volume-question>` is needed here. */
interface Question extends HTMLElement {
  readonly done: boolean;
  readonly result: { readonly response: string; readonly chosen: readonly number[] } | null;
  readonly updateComplete: Promise<unknown>;
  tries: number | null;
  restore(answer: { response: string; chosen: readonly number[]; correct: boolean; tries: number }): void;
}

class VolumeViewLesson extends core.EventDispatcher {
  readonly #record: CourseRecord;
  #place: HTMLElement | null = null;
  /** Ends when the lesson is there. */
  #shown: Promise<void> = Promise.resolve();

  constructor(
    readonly content: Content | null,
    readonly contentId: number | string,
    extras: { readonly previousState?: KeptRecord } = {},
  ) {
    super();
    this.#record = new CourseRecord(extras.previousState, {
      answered: (write) => this.#report('answered', write),
      completed: () => this.#reportCompleted(),
    });
  }

  /** Called by H5P. @param container - as jQuery has it */
  attach(container: ArrayLike<HTMLElement>): void {
    const place = container[0];
    place.classList.add('volume-view-lesson');
    this.#place = place;
    this.#begin(place);
    new ResizeObserver(() => this.trigger('resize')).observe(place);
  }

  #begin(place: HTMLElement): void {
    this.#shown = this.#show(place).catch((error: unknown) =>
      this.#say(place, error instanceof Error ? error.message : 'unknown'),
    );
  }

  async #show(place: HTMLElement): Promise<void> {
    const { nodes, problems } = parseLesson(decode(this.content?.html));
    if (problems.length > 0) throw new Error(problems.map(({ message }) => message).join('; '));
    const folder = new URL(`${core.getLibraryPath(library)}/`, document.baseURI);
    const addresses = await locateFiles(
      this.content?.files,
      (path) => new URL(core.getPath(path, this.contentId), document.baseURI).href,
    );
    // What a learner has answered is kept by H5P for each learner; the browser would show it to the next one.
    place.append(...nodes.map((node) => buildNode(node, (path) => addresses.get(path) ?? '', ['remember'])));
    this.#record.questions = place.querySelectorAll('volume-question').length;
    // The script of a course finds what a course gives a page at this place, and reports to it.
    Object.assign(globalThis, { API_1484_11: this.#record });
    await runScript(new URL('course.js', folder).href, { scorm: '2004' });
    if (!customElements.get('volume-view')) await runScript(new URL('volume-view.iife.js', folder).href);
  }

  #say(place: HTMLElement, message: string): void {
    const text = document.createElement('p');
    text.setAttribute('role', 'alert');
    text.textContent = `This lesson is not shown: ${message}`;
    place.append(text);
  }

  #report(verb: string, write: (event: XApiEvent) => void): void {
    const event = this.createXAPIEventTemplate(verb);
    write(event);
    this.trigger(event);
  }

  #reportCompleted(): void {
    this.#report('completed', (event) =>
      event.setScoredResult(this.getScore(), this.getMaxScore(), this, true, this.getScore() === this.getMaxScore()),
    );
  }

  // What H5P asks of content with a score.

  getScore(): number {
    return this.#record.score;
  }

  getMaxScore(): number {
    return this.#record.maxScore;
  }

  getAnswerGiven(): boolean {
    return this.#record.hasAnswers;
  }

  /** Begin again, without answers. The script of the course begins again too: that of before knows none of the new elements. */
  async resetTask(): Promise<void> {
    await this.#shown;
    this.#record.clear();
    this.#place?.replaceChildren();
    if (this.#place) this.#begin(this.#place);
    this.trigger('resize');
  }

  /** Show the right answers, also where a learner has tries left. */
  async showSolutions(): Promise<void> {
    await this.#shown;
    for (const question of this.#place?.querySelectorAll<Question>('volume-question') ?? []) {
      if (question.done) continue;
      const { response = '', chosen = [] } = question.result ?? {};
      question.tries = 1;
      await question.updateComplete;
      question.restore({ response, chosen, correct: false, tries: 1 });
    }
    this.trigger('resize');
  }

  /** What H5P asks of content with a score: the result of all, and the last answer to each question. */
  getXAPIData(): { readonly statement: Statement; readonly children: readonly { readonly statement: Statement }[] } {
    const all = this.createXAPIEventTemplate('answered');
    const { statement } = all.data;
    const { definition } = statement.object;
    const type = 'http://adlnet.gov/expapi/activities/cmi.interaction';
    statement.object = {
      ...statement.object,
      definition: { ...definition, type, interactionType: 'compound', correctResponsesPattern: [] },
    };
    const [score, max] = [this.getScore(), this.getMaxScore()];
    all.setScoredResult(score, max, this, this.#record.isComplete, score === max);
    const children = this.#record.answers.map((write) => {
      const one = this.createXAPIEventTemplate('answered');
      write(one);
      return { statement: one.data.statement };
    });
    return { statement, children };
  }

  /** What H5P keeps for the learner's next visit. */
  getCurrentState(): KeptRecord {
    return this.#record.kept;
  }
}

/** The HTML that entities in a text stand for. */
function decode(text: unknown): string {
  if (typeof text !== 'string') return '';
  if (text.includes('<')) return text; // A host that has read the entities itself.
  return new DOMParser().parseFromString(trust(text, 'createHTML'), 'text/html').body.textContent;
}

// H5P writes into the prototype of what it constructs; that of a class is not for writing.
core.VolumeViewLesson = function (...given: ConstructorParameters<typeof VolumeViewLesson>): VolumeViewLesson {
  return new VolumeViewLesson(...given);
};
