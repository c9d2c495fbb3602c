import { checkText, isFetched, quote, viewAttributes } from './view-attributes.ts';

/** What the address of the page asks for. */
export interface EmbedPlan {
  /** Attributes of the view, with their texts. */
  readonly attributes: readonly (readonly [name: string, text: string])[];
  /** The whole address of a lesson, which is shown instead of a view; null for none. */
  readonly lesson: string | null;
  /** The address of an image that is shown until the reader asks for more; null for none. */
  readonly poster: string | null;
  /** Elements below the picture. */
  readonly companions: readonly string[];
  /** The language of words and numbers, as HTML has it; null for that of the page. */
  readonly language: string | null;
  /** The only origins that the page talks with; null where the address names none. */
  readonly parents: readonly string[] | null;
  /** What of the address is not taken, in words. */
  readonly problems: readonly string[];
}

/** Companions of the view, by the names that the address has for them. */
const companionNames: Readonly<Record<string, string>> = {
  legend: 'volume-legend',
  readout: 'volume-readout',
  timeline: 'volume-timeline',
};

/** Problems that are shown: a reader needs no more to find the mistake. */
const maxProblems = 8;

/**
 * Reads the address of the page: `embed.html?src=head.nii.gz&alt=Brain&legend`. Nothing of it is HTML.
 * @param href - the whole address, which others count from
 */
export function readAddress(href: string): EmbedPlan {
  const { searchParams } = new URL(href);
  const attributes = new Map<string, string>();
  const companions: string[] = [];
  const own: Record<'lesson' | 'lang' | 'parent', string | null> = { lesson: null, lang: null, parent: null };
  const problems: string[] = [];
  const refuse = (words: string): void => {
    if (problems.length < maxProblems) problems.push(words);
  };
  const seen = new Set<string>();
  for (const [name, text] of searchParams) {
    if (seen.has(name)) refuse(`${quote(name)} is in the address twice; the first one counts`);
    else if (Object.hasOwn(companionNames, name)) companions.push(companionNames[name]);
    else if (Object.hasOwn(own, name)) own[name as keyof typeof own] = text.trim();
    else {
      const problem = checkText(name, text, href);
      if (problem === null) attributes.set(name, text);
      else refuse(problem);
    }
    seen.add(name);
  }
  let { lesson, lang: language } = own;
  if (lesson !== null && !isFetched(lesson, href)) {
    refuse('lesson got an address that this page does not fetch; expected one that begins with https:// or http://');
    lesson = null;
  }
  if (lesson !== null) {
    const others = [...attributes.keys()].filter((name) => name !== 'poster' && name !== 'alt');
    if (others.length + companions.length > 0)
      refuse('with lesson, all attributes and companions are those of the lesson; expected only poster and alt');
  }
  if (language !== null && !/^[A-Za-z]{2,8}(-[A-Za-z0-9]{1,8}){0,4}$/.test(language)) {
    refuse('lang is no language; expected one as HTML has it, like "en" or "pt-BR"');
    language = null;
  }
  const poster = attributes.get('poster') ?? null;
  return {
    attributes: lesson === null ? [...viewAttributes].flatMap((name) => listEntry(name, attributes)) : [],
    lesson: lesson === null ? null : new URL(lesson, href).href,
    poster: poster === null ? null : new URL(poster.trim(), href).href,
    companions: lesson === null ? companions : [],
    language,
    parents: own.parent === null ? null : readOrigins(own.parent, refuse),
    problems,
  };
}

const listEntry = (name: string, texts: ReadonlyMap<string, string>): [string, string][] => {
  const text = texts.get(name);
  return text === undefined ? [] : [[name, text]];
};

/** Origins with blanks between them. One that can't be read stands for none: the page then talks with fewer sites, not with more. */
export function readOrigins(text: string, refuse: (words: string) => void = () => {}): string[] {
  return text
    .split(/\s+/)
    .filter(Boolean)
    .flatMap((one) => {
      try {
        const { origin, protocol } = new URL(one);
        if (/^https?:$/.test(protocol)) return [origin];
      } catch {
        // Said below.
      }
      refuse('parent got no address of a site; expected one like https://example.org');
      return [];
    });
}
