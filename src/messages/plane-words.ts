import { english } from './english-plane.ts';
import type { PlaneTerms } from './plane-terms.ts';
import { Words } from './words.ts';

/** The words of the editor of values and gradients. */
export class PlaneWords extends Words<PlaneTerms> {
  constructor(host: ConstructorParameters<typeof Words>[0]) {
    super(host, english);
  }
}
