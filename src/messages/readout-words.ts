import { english as companions } from './english-companions.ts';
import { english } from './english-readout.ts';
import { Language } from './language.ts';
import type { ReadoutTerms } from './readout-terms.ts';
import type { CompanionTerms } from './terms.ts';
import { Words } from './words.ts';

/** The messages of a readout, in the language of the page. */
export class ReadoutWords extends Words<CompanionTerms & ReadoutTerms> {
  constructor(host: ConstructorParameters<typeof Words>[0]) {
    super(host, { ...companions, ...english });
  }

  get language(): Language {
    return new Language(this.lang(), this.terms);
  }
}
