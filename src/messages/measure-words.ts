import { english as companions } from './english-companions.ts';
import { english as handles } from './english-handles.ts';
import { english } from './english-measure.ts';
import { english as readout } from './english-readout.ts';
import type { HandleTerms } from './handle-terms.ts';
import { Language } from './language.ts';
import type { MeasureTerms } from './measure-terms.ts';
import type { ReadoutTerms } from './readout-terms.ts';
import type { CompanionTerms } from './terms.ts';
import { Words } from './words.ts';

/** The messages of a measure, of its handles, and of their places. */
export type MeasureWordTerms = CompanionTerms & ReadoutTerms & HandleTerms & MeasureTerms;

/** The messages of a measure, in the language of the page. */
export class MeasureWords extends Words<MeasureWordTerms> {
  constructor(host: ConstructorParameters<typeof Words>[0]) {
    super(host, { ...companions, ...readout, ...handles, ...english });
  }

  get language(): Language {
    return new Language(this.lang(), this.terms);
  }
}
