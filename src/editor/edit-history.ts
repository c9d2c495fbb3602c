/** Steps that undo goes back by; far more than anybody does. */
const maxSteps = 200;

/** States that were, the present one, and those that were undone. */
export class EditHistory<State> {
  #past: State[] = [];
  #future: State[] = [];
  #first: State;
  #present: State;

  constructor(first: State) {
    this.#first = first;
    this.#present = first;
  }

  /** Where it began, and what a reset goes back to. */
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

  /** A step forward; what was undone is forgotten. The same state again is no step. */
  push(state: State): void {
    if (state === this.#present) return;
    this.#past = [...this.#past, this.#present].slice(-maxSteps);
    this.#future = [];
    this.#present = state;
  }

  /** The present state was another one, without a step having been made. */
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
