// The field in an element, and a shape of an author's that leaves its colour in the picture.
import { fieldUrl } from './harness.ts';
import type { Picture } from './pictures.ts';
import { attributesOf } from './reference.ts';

export const plain = `<volume-view src="${fieldUrl}" ${attributesOf()} alt="A field"></volume-view>`;

export const shape = (color: string, x = 0): string =>
  `<transform id="place" translation="${x} 0 0"><shape><appearance><material id="paint" diffusecolor="0 0 0" emissivecolor="${color}"></material></appearance><box size="8 8 60"></box></shape></transform>`;

/** Pixels of pure green: what a shape of that colour leaves where nothing is before it. */
export function countGreen({ data }: Picture): number {
  let count = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i] < 8 && data[i + 1] > 245 && data[i + 2] < 8) count++;
  return count;
}
