import { english as companions } from './english-companions.ts';
import { english } from './english-readout.ts';
import { Language } from './language.ts';
import type { ReadoutMessages } from './readout-messages.ts';
import type { CompanionMessages } from './messages.ts';
import { LocaleController } from './locale-controller.ts';

/** The messages of a readout, in the language of the page. */
export class ReadoutLocale extends LocaleController<CompanionMessages & ReadoutMessages> {
  constructor(host: ConstructorParameters<typeof LocaleController>[0]) {
    super(host, { ...companions, ...english });
  }

  get language(): Language {
    return new Language(this.lang(), this.messages);
  }
}
