import { english as companions } from './english-companions.ts';
import { english } from './english-tours.ts';
import { LocaleController } from './locale-controller.ts';
import type { CompanionMessages } from './messages.ts';
import type { TourMessages } from './tour-messages.ts';

/** The messages of a tour, in the language of the page. */
export class TourLocale extends LocaleController<CompanionMessages & TourMessages> {
  constructor(host: ConstructorParameters<typeof LocaleController>[0]) {
    super(host, { ...companions, ...english });
  }
}
