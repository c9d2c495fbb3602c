/** Number of files that are read at once: enough to hide the time until the first byte, and few enough to take little memory. */
export const usualAhead = 6;

/**
 * Reads several things, some of them ahead, and yields them in their order. A failure is yielded in its turn, and what comes
 * after it is read all the same.
 */
export async function* readAhead<T, R>(
  things: readonly T[],
  read: (thing: T, place: number) => Promise<R>,
  ahead = usualAhead,
): AsyncGenerator<PromiseSettledResult<R>> {
  const coming: Promise<PromiseSettledResult<R>>[] = [];
  for (let next = 0, given = 0; given < things.length; given++) {
    for (; next < things.length && next < given + ahead; next++) {
      coming.push(
        read(things[next], next).then(
          (value) => ({ status: 'fulfilled', value }),
          (reason: unknown) => ({ status: 'rejected', reason }),
        ),
      );
    }
    yield await coming.shift()!;
  }
}
