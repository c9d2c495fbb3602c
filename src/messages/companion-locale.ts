import { english } from './english-companions.ts';
import { Language } from './language.ts';
import type { CompanionMessages } from './messages.ts';
import { LocaleController } from './locale-controller.ts';

/** The messages of a companion, in the language of the page. */
export class CompanionLocale extends LocaleController<CompanionMessages> {
  constructor(host: ConstructorParameters<typeof LocaleController>[0]) {
    super(host, english);
  }

  get language(): Language {
    return new Language(this.lang(), this.messages);
  }
}
