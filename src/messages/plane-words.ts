import { english } from './english-plane.ts';
import type { PlaneTerms } from './plane-terms.ts';
import { Words } from './words.ts';

/** The messages of the editor of values and gradients, in the language of the page. */
export class PlaneWords extends Words<PlaneTerms> {
  constructor(host: ConstructorParameters<typeof Words>[0]) {
    super(host, english);
  }
}
