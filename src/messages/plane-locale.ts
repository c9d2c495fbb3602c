import { english } from './english-plane.ts';
import type { PlaneMessages } from './plane-messages.ts';
import { LocaleController } from './locale-controller.ts';

/** The messages of the editor of values and gradients, in the language of the page. */
export class PlaneLocale extends LocaleController<PlaneMessages> {
  constructor(host: ConstructorParameters<typeof LocaleController>[0]) {
    super(host, english);
  }
}
