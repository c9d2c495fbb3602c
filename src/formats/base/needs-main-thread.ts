/** Thrown in a worker that lacks what a format needs, such as a canvas. It never reaches an author. */
export class NeedsMainThread extends Error {
  constructor(options?: ErrorOptions) {
    super('this has to be done on the main thread', options);
    this.name = 'NeedsMainThread';
  }
}
