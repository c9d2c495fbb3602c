/** Maximum number of steps that can be undone; far more than anybody uses. */
const maxSteps = 200;

/** Earlier states, the present one, and those that were undone. */
export class EditHistory<State> {
  #past: State[] = [];
  #future: State[] = [];
  #first: State;
  #present: State;

  constructor(first: State) {
    this.#first = first;
    this.#present = first;
  }

  /** The first state, to which a reset returns. */
  get first(): State {
    return this.#first;
  }

  get present(): State {
    return this.#present;
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  /** Adds a step, and forgets what was undone. The same state again is not a step. */
  push(state: State): void {
    if (state === this.#present) return;
    this.#past = [...this.#past, this.#present].slice(-maxSteps);
    this.#future = [];
    this.#present = state;
  }

  /** Replaces the present state without adding a step. */
  replace(state: State): void {
    if (this.#present === this.#first) this.#first = state;
    this.#present = state;
  }

  undo(): State {
    const state = this.#past.pop();
    if (state === undefined) return this.#present;
    this.#future.push(this.#present);
    return (this.#present = state);
  }

  redo(): State {
    const state = this.#future.pop();
    if (state === undefined) return this.#present;
    this.#past.push(this.#present);
    return (this.#present = state);
  }
}
