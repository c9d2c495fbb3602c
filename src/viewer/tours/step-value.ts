import { invalidAttribute, VolumeViewError } from '../../core/errors.ts';
import { notInSteps, stepAttributes } from './step-attributes.ts';

/** The text of one attribute of one element; null where the attribute is to be absent. */
export interface Setting<Target> {
  readonly target: Target;
  readonly name: string;
  readonly text: string | null;
}

/** The elements that a step may change. */
export interface StepTargets<Target> {
  readonly view: Target;
  /** All notes of the view. */
  readonly notes: readonly { readonly id: string; readonly target: Target }[];
  /** The first `<volume-slice>` in the view; null for none. */
  readonly slice: Target | null;
  /** The `<volume-labels>` in the view; null for none. */
  readonly labels: Target | null;
}

/** What a step sets, and the first thing in it that can't be read. */
export interface StepValue<Target> {
  readonly settings: readonly Setting<Target>[];
  readonly problem: VolumeViewError | null;
}

/** Attributes of the step itself. */
const own = new Set(['dwell', 'label', 'labels', 'notes', 'slice']);

/** Attributes that every element of HTML may have. */
const global = new Set(
  (
    'accesskey autocapitalize autofocus class contenteditable dir draggable enterkeyhint exportparts hidden id inert inputmode is itemid ' +
    'itemprop itemref itemscope itemtype lang nonce part popover role slot spellcheck style tabindex title translate'
  ).split(' '),
);

/** Attributes that belong to other code: of scripts, and of libraries, which often have a sign or a prefix. */
const foreign = /[^a-z0-9-]|^(aria|astro|data|hx|ng|on|svelte|v|x)(-|$)|^on[a-z]|^data-/;

/**
 * Read what a step sets. The texts are those of the elements' own attributes, and are copied as they are: the elements read them, and
 * report what is wrong with them.
 */
export function readStep<Target>(
  attributes: Iterable<{ readonly name: string; readonly value: string }>,
  { view, notes, slice, labels }: StepTargets<Target>,
): StepValue<Target> {
  const settings: Setting<Target>[] = [];
  let problem: VolumeViewError | null = null;
  for (const { name, value } of attributes) {
    try {
      if (stepAttributes.includes(name)) settings.push({ target: view, name, text: value });
      else if (name === 'notes') settings.push(...openNotes(value, notes));
      else if (name === 'slice') settings.push(...moveSlice(value, slice));
      else if (name === 'labels') settings.push(...showLabels(value, labels));
      else check(name);
    } catch (error) {
      problem ??= error as VolumeViewError;
    }
  }
  return { settings, problem };
}

/** @throws {VolumeViewError} `attribute/invalid` where a step can't have such an attribute */
function check(name: string): void {
  if (own.has(name) || global.has(name) || foreign.test(name)) return;
  if (name === 'poster')
    throw new VolumeViewError(
      'attribute/invalid',
      '<volume-step> got the attribute poster; expected a picture between its tags, <img slot="poster" src="…" alt="…">.',
    );
  const reason = notInSteps.includes(name)
    ? `it belongs on the <volume-view>, and is the same in all steps`
    : `expected an attribute of <volume-view>, or labels, notes, slice, label`;
  throw new VolumeViewError('attribute/invalid', `<volume-step> got the attribute ${name.slice(0, 60)}; ${reason}.`);
}

/** These notes are open, and all others closed. @param text - ids, separated by blanks; may be empty */
function openNotes<Target>(text: string, notes: StepTargets<Target>['notes']): Setting<Target>[] {
  const ids = new Set(text.split(/\s+/).filter((id) => id !== ''));
  for (const id of ids)
    if (!notes.some((note) => note.id === id))
      throw invalidAttribute('notes of <volume-step>', id, 'the id of a <volume-note> of the same view');
  return notes.map(({ id, target }) => ({ target, name: 'open', text: ids.has(id) ? '' : null }));
}

/** @param text - a type and a position, `axial 20`, as the attributes `type` and `at` of the slice; or `none`, which hides it */
function moveSlice<Target>(text: string, slice: Target | null): Setting<Target>[] {
  const [type, at = null, more] = text.trim().split(/\s+/);
  if (slice === null || type === '' || more !== undefined)
    throw invalidAttribute(
      'slice of <volume-step>',
      text,
      slice === null ? 'a <volume-slice> in the <volume-view>' : 'a type and a position, like "axial 20", or none',
    );
  if (type === 'none' && at === null) return [{ target: slice, name: 'hidden', text: '' }];
  return [
    { target: slice, name: 'hidden', text: null },
    { target: slice, name: 'type', text: type },
    { target: slice, name: 'at', text: at },
  ];
}

/** @param text - what the attribute `only` of the labels takes, `17 18`; or `all`, or `none`, which shows the volume without labels */
function showLabels<Target>(text: string, labels: Target | null): Setting<Target>[] {
  if (labels === null)
    throw invalidAttribute('labels of <volume-step>', text, 'a <volume-labels> in the <volume-view>');
  const word = text.trim().toLowerCase();
  return [
    { target: labels, name: 'hidden', text: word === 'none' ? '' : null },
    { target: labels, name: 'only', text: word === 'none' || word === 'all' ? null : text },
  ];
}
