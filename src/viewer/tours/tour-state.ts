import type { Setting } from './step-value.ts';

/**
 * The attributes that a tour changes, as they were before the tour. What a step does not name is as before the tour: so steps open in any
 * order, and each one always looks the same.
 */
export class TourState<Target> {
  readonly #before = new Map<Target, Map<string, string | null>>();

  /** @param read - the present text of an attribute; null where it is absent */
  constructor(readonly read: (target: Target, name: string) => string | null) {}

  /** Remember how the attributes are that these settings change. Those that are remembered already stay. */
  remember(settings: Iterable<Setting<Target>>): void {
    for (const { target, name } of settings) {
      const texts = this.#before.get(target) ?? new Map<string, string | null>();
      this.#before.set(target, texts);
      if (!texts.has(name)) texts.set(name, this.read(target, name));
    }
  }

  /** All attributes that the tour changes, in a step; without settings: as before the tour. */
  textsIn(settings: Iterable<Setting<Target>> = []): Setting<Target>[] {
    const texts = new Map([...this.#before].map(([target, before]) => [target, new Map(before)]));
    for (const { target, name, text } of settings) texts.get(target)?.set(name, text);
    return [...texts].flatMap(([target, inner]) => [...inner].map(([name, text]) => ({ target, name, text })));
  }
}
