/**
 * States of an element that CSS may ask for, `volume-view:state(loading)`. Browsers without custom states get an attribute
 * instead: `volume-view[data-state-loading]`. Styles ask for both in `:is()`, as such a browser drops a whole rule with `:state()`:
 * `:host(:is(:state(loading), [data-state-loading]))`.
 */
export class CustomStates<State extends string> {
  readonly #host: HTMLElement;
  /** null where the browser has no custom states, or only those of the first draft, which needs names with dashes. */
  readonly #states: Set<string> | null;

  constructor(host: HTMLElement) {
    this.#host = host;
    this.#states = findStates(host);
  }

  set(state: State, on: boolean): void {
    if (!this.#states) this.#host.toggleAttribute(`data-state-${state}`, on);
    else if (on) this.#states.add(state);
    else this.#states.delete(state);
  }
}

function findStates(host: HTMLElement): Set<string> | null {
  try {
    const states = host.attachInternals().states as Set<string>;
    states.add('known');
    states.delete('known');
    return states;
  } catch {
    return null;
  }
}
