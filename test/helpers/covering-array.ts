/** What is chosen of each factor. */
export type Row<T> = Readonly<Record<string, T>>;

/** All rows of one level of each factor that are legal. */
export function listRows<T>(factors: Readonly<Record<string, readonly T[]>>, isLegal: (row: Row<T>) => boolean): Row<T>[] {
  let rows: Row<T>[] = [{}];
  for (const [factor, levels] of Object.entries(factors)) rows = rows.flatMap((row) => levels.map((level) => ({ ...row, [factor]: level })));
  return rows.filter(isLegal);
}

/** Pairs of levels of two factors that a row has; each as a text that names it. */
export function listPairs<T>(row: Row<T>, name: (level: T) => string): string[] {
  const levels = Object.entries(row).map(([factor, level]) => `${factor}: ${name(level)}`);
  return levels.flatMap((a, i) => levels.slice(i + 1).map((b) => `${a}, ${b}`));
}

/**
 * A covering array of strength two: as few rows as is easily found, so that each pair of levels that any row has is in one
 * of them. The next row is always the one that has most of the pairs that are left.
 * Source: the greedy construction, Cohen, Dalal, Fredman, Patton, *The AETG system*, 1997, over all rows
 */
export function coverPairs<T>(rows: readonly Row<T>[], name: (level: T) => string): Row<T>[] {
  const pairs = rows.map((row) => listPairs(row, name));
  const left = new Set(pairs.flat());
  const chosen: Row<T>[] = [];
  while (left.size > 0) {
    const news = pairs.map((some) => some.filter((pair) => left.has(pair)).length);
    const best = news.indexOf(Math.max(...news));
    chosen.push(rows[best]);
    for (const pair of pairs[best]) left.delete(pair);
  }
  return chosen;
}
