import type { CurveMessages } from './curve-messages.ts';
import { english as companions } from './english-companions.ts';
import { english } from './english-curve.ts';
import { Language } from './language.ts';
import { LocaleController } from './locale-controller.ts';
import type { CompanionMessages } from './messages.ts';

/** The messages of a curve, in the language of the page. */
export class CurveLocale extends LocaleController<CompanionMessages & CurveMessages> {
  constructor(host: ConstructorParameters<typeof LocaleController>[0]) {
    super(host, { ...companions, ...english });
  }

  get language(): Language {
    return new Language(this.lang(), this.messages);
  }
}
