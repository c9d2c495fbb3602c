import { english as companions } from './english-companions.ts';
import { english as handles } from './english-handles.ts';
import { english } from './english-measure.ts';
import { english as readout } from './english-readout.ts';
import type { HandleMessages } from './handle-messages.ts';
import { Language } from './language.ts';
import type { MeasureMessages } from './measure-messages.ts';
import type { ReadoutMessages } from './readout-messages.ts';
import type { CompanionMessages } from './messages.ts';
import { LocaleController } from './locale-controller.ts';

/** The messages of a measure, of its handles, and of their places. */
export type MeasureWordMessages = CompanionMessages & ReadoutMessages & HandleMessages & MeasureMessages;

/** The messages of a measure, in the language of the page. */
export class MeasureLocaleController extends LocaleController<MeasureWordMessages> {
  constructor(host: ConstructorParameters<typeof LocaleController>[0]) {
    super(host, { ...companions, ...readout, ...handles, ...english });
  }

  get language(): Language {
    return new Language(this.lang(), this.messages);
  }
}
