import { eventTypes, messageVersion } from './protocol.ts';
import { checkName, checkText, quote } from './view-attributes.ts';

/** What the page around the frame asks for. */
export type Request =
  | { readonly kind: 'get' }
  | { readonly kind: 'set'; readonly attributes: readonly (readonly [name: string, text: string | null])[] }
  | { readonly kind: 'step'; readonly step: number | 'next' | 'previous' }
  | { readonly kind: 'events'; readonly types: readonly string[] };

/** A message that was read. */
export interface Message {
  /** The answer has it too. */
  readonly id: number | null;
  readonly request: Request | null;
  /** What is wrong, in words; null where the request can be done. */
  readonly problem: string | null;
}

/** Attributes in one message: more than the view has. */
const maxAttributes = 100;

/**
 * Reads a message: `{ volumeView: 1, id: 7, set: { 'camera-orbit': '30deg 70deg auto' } }`.
 * @param data - anything: other scripts send messages too
 * @param base - the address of the page
 * @returns null where the message is not for us
 */
export function readMessage(data: unknown, base: string): Message | null {
  if (!isObject(data) || !Object.hasOwn(data, 'volumeView')) return null;
  const id = typeof data.id === 'number' && Number.isFinite(data.id) ? data.id : null;
  const wrong = (problem: string): Message => ({ id, request: null, problem });
  if (data.volumeView !== messageVersion)
    return wrong(`got a message of another version; expected volumeView: ${messageVersion}`);
  const kinds = ['get', 'set', 'step', 'events'].filter((name) => Object.hasOwn(data, name));
  if (kinds.length !== 1) return wrong(`got ${kinds.length} requests; expected one of get, set, step and events`);
  switch (kinds[0]) {
    case 'get':
      return { id, request: { kind: 'get' }, problem: null };
    case 'set':
      return { id, ...readSet(data.set, base) };
    case 'step':
      return { id, ...readStep(data.step) };
    default:
      return { id, ...readEvents(data.events) };
  }
}

type Read = Omit<Message, 'id'>;

const refuse = (problem: string): Read => ({ request: null, problem });

/** All attributes can be set, or none is. */
function readSet(given: unknown, base: string): Read {
  if (!isObject(given)) return refuse('set got no object; expected attributes with their texts');
  const names = Object.keys(given);
  if (names.length > maxAttributes)
    return refuse(`set got ${names.length} attributes; expected at most ${maxAttributes}`);
  const attributes: [string, string | null][] = [];
  for (const name of names) {
    const value = given[name];
    const text = typeof value === 'number' && Number.isFinite(value) ? String(value) : value;
    if (typeof text !== 'string' && typeof text !== 'boolean' && text !== null)
      return refuse(`set got no text for ${quote(name)}; expected a text, or null to remove the attribute`);
    const asText = text === true ? '' : text === false ? null : text;
    const problem = asText === null ? checkName(name) : checkText(name, asText, base);
    if (problem !== null) return refuse(problem);
    attributes.push([name, asText]);
  }
  return { request: { kind: 'set', attributes }, problem: null };
}

function readStep(step: unknown): Read {
  const isNumber = typeof step === 'number' && Number.isInteger(step) && step >= 1 && step <= 9999;
  if (!isNumber && step !== 'next' && step !== 'previous')
    return refuse('step got no step; expected a number from 1, "next" or "previous"');
  return { request: { kind: 'step', step }, problem: null };
}

function readEvents(types: unknown): Read {
  if (!Array.isArray(types) || types.length > 2 * eventTypes.length)
    return refuse('events got no list; expected names of events');
  const unknown = types.find((type) => !eventTypes.includes(type as string)) as unknown;
  if (unknown !== undefined)
    return refuse(
      `events got ${quote(typeof unknown === 'string' ? unknown : typeof unknown)}; expected ${eventTypes.join(', ')}`,
    );
  return { request: { kind: 'events', types: [...new Set(types as string[])] }, problem: null };
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
