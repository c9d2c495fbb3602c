import { english } from './english-companions.ts';
import { Language } from './language.ts';
import type { CompanionTerms } from './terms.ts';
import { Words } from './words.ts';

/** The messages of a companion, in the language of the page. */
export class CompanionWords extends Words<CompanionTerms> {
  constructor(host: ConstructorParameters<typeof Words>[0]) {
    super(host, english);
  }

  get language(): Language {
    return new Language(this.lang(), this.terms);
  }
}
