// What the script of a course (lesson-writers: course.js) says in SCORM 2004, as H5P has it: answers and completion as xAPI statements, and a state.

/** A statement of xAPI 1.0.3, as far as this page writes it. */
export interface Statement {
  object: { readonly id: string; readonly objectType?: string; readonly definition?: object };
  context?: { readonly contextActivities?: object };
  result?: object;
}

/** What the next visit begins with: elements of SCORM 2004 by their names. */
export type KeptRecord = Readonly<Record<string, string>>;

/** Writes an answer into a statement about the lesson. */
export type AnswerWriter = (event: { readonly data: { statement: Statement } }) => void;

/** Gets what a learner does. */
export interface RecordListener {
  answered(write: AnswerWriter): void;
  completed(): void;
}

const keptNames = ['cmi.location', 'cmi.suspend_data', 'cmi.completion_status', 'cmi.score.scaled'];

/** What is kept of an answer, after `cmi.interactions.` and its number. */
const answerParts = ['id', 'type', 'description', 'correct_responses.0.pattern', 'learner_response', 'result'];

/** The most answers that are kept: a lesson has few questions. */
const maxAnswers = 200;

/** The name of a part of an answer. @param number - from 0 */
const nameOf = (number: number, part: string): string => `cmi.interactions.${number}.${part}`;

/** The most characters that are kept of one element, as SCORM 2004 has it. */
const longest = 64_000;

/** The runtime interface of SCORM 2004 (IEEE 1484.11.2) for one lesson in H5P. */
export class CourseRecord {
  /** Number of questions in the lesson. */
  questions = 0;
  readonly #values = new Map<string, string>();

  constructor(
    kept: KeptRecord | null | undefined,
    readonly listener: RecordListener,
  ) {
    const take = (name: string): void => {
      const text: unknown = kept?.[name];
      if (typeof text === 'string' && text.length <= longest) this.#values.set(name, text);
    };
    keptNames.forEach(take);
    for (let i = 0; i < maxAnswers && typeof kept?.[nameOf(i, 'id')] === 'string'; i++)
      answerParts.forEach((part) => take(nameOf(i, part)));
  }

  get kept(): KeptRecord {
    const simple = [...this.#values].filter(([name]) => keptNames.includes(name));
    const answers = this.#lastAnswers().flatMap((number, i) =>
      answerParts.flatMap((part) => {
        const value = this.#values.get(nameOf(number, part));
        return value === undefined ? [] : [[nameOf(i, part), value]];
      }),
    );
    return Object.fromEntries([...simple, ...answers]);
  }

  /** Forget all that the learner has done. */
  clear(): void {
    this.#values.clear();
  }

  /** For each question that has an answer, what writes the last one into a statement about the lesson. */
  get answers(): readonly AnswerWriter[] {
    return this.#lastAnswers().map((number) => (event) => this.#writeAnswer(event.data, number));
  }

  /** The numbers of the last answer to each question. */
  #lastAnswers(): number[] {
    const byId = new Map<string, number>();
    for (let i = 0; i < this.#count; i++) byId.set(this.#values.get(nameOf(i, 'id')) ?? '', i);
    return [...byId.values()].slice(0, maxAnswers);
  }

  get #count(): number {
    let count = 0;
    while (this.#values.has(nameOf(count, 'id'))) count++;
    return count;
  }

  get hasAnswers(): boolean {
    return this.#values.has('cmi.score.scaled');
  }

  /** Number of right answers; a lesson without questions has one point for whoever has seen all of it. */
  get score(): number {
    if (this.questions === 0) return Number(this.isComplete);
    const share = Number(this.#values.get('cmi.score.scaled') ?? 0);
    return Math.round(Math.min(1, Math.max(0, share || 0)) * this.questions);
  }

  get maxScore(): number {
    return Math.max(1, this.questions);
  }

  /** Whether all steps were seen, and all questions are answered. */
  get isComplete(): boolean {
    return this.#values.get('cmi.completion_status') === 'completed';
  }

  readonly Initialize = (): string => 'true';
  readonly Terminate = (): string => 'true';
  readonly Commit = (): string => 'true';

  readonly GetValue = (name: string): string => {
    if (name === 'cmi.interactions._count') return String(this.#count);
    return this.#values.get(name) ?? '';
  };

  readonly SetValue = (name: string, value: string): string => {
    const wasComplete = this.isComplete;
    this.#values.set(name, value);
    const [, number] = /^cmi\.interactions\.(\d+)\.result$/.exec(name) ?? [];
    if (number !== undefined) this.listener.answered((event) => this.#writeAnswer(event.data, Number(number)));
    if (!wasComplete && this.isComplete) this.listener.completed();
    return 'true';
  };

  /** An answer to one question, with the lesson as its parent: so H5P does not take it for the result of all. */
  #writeAnswer(data: { statement: Statement }, number: number): void {
    const { statement } = data;
    const get = (part: string): string => this.#values.get(nameOf(number, part)) ?? '';
    const { id } = statement.object;
    const [description, right, isRight] = [
      get('description'),
      get('correct_responses.0.pattern'),
      get('result') === 'correct',
    ];
    statement.object = {
      id: `${id}${id.includes('?') ? '&' : '?'}subContentId=${encodeURIComponent(get('id'))}`,
      objectType: 'Activity',
      definition: {
        type: 'http://adlnet.gov/expapi/activities/cmi.interaction',
        interactionType: get('type'),
        ...(description && { description: { und: description } }),
        ...(right && { correctResponsesPattern: [right] }),
      },
    };
    const before = statement.context?.contextActivities;
    statement.context = {
      ...statement.context,
      contextActivities: { ...before, parent: [{ id, objectType: 'Activity' }] },
    };
    statement.result = {
      response: get('learner_response'),
      success: isRight,
      completion: true,
      score: { min: 0, max: 1, raw: Number(isRight), scaled: Number(isRight) },
    };
  }
}
