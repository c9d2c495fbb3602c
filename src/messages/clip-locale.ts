import type { ClipMessages } from './clip-messages.ts';
import { english } from './english-clip.ts';
import { english as companions } from './english-companions.ts';
import { english as handles } from './english-handles.ts';
import type { HandleMessages } from './handle-messages.ts';
import { Language } from './language.ts';
import type { CompanionMessages } from './messages.ts';
import { LocaleController } from './locale-controller.ts';

/** The messages of a clip's handles, in the language of the page. */
export class ClipLocale extends LocaleController<CompanionMessages & HandleMessages & ClipMessages> {
  constructor(host: ConstructorParameters<typeof LocaleController>[0]) {
    super(host, { ...companions, ...handles, ...english });
  }

  get language(): Language {
    return new Language(this.lang(), this.messages);
  }
}
