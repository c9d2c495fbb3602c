import type { ClipTerms } from './clip-terms.ts';
import { english } from './english-clip.ts';
import { english as companions } from './english-companions.ts';
import { english as handles } from './english-handles.ts';
import type { HandleTerms } from './handle-terms.ts';
import { Language } from './language.ts';
import type { CompanionTerms } from './terms.ts';
import { Words } from './words.ts';

/** The messages of a clip's handles, in the language of the page. */
export class ClipWords extends Words<CompanionTerms & HandleTerms & ClipTerms> {
  constructor(host: ConstructorParameters<typeof Words>[0]) {
    super(host, { ...companions, ...handles, ...english });
  }

  get language(): Language {
    return new Language(this.lang(), this.terms);
  }
}
