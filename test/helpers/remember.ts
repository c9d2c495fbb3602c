/** The same function, which works its answer out once for each of what it is asked: for what both WebGLs are held against. */
export function remember<K, V>(workOut: (key: K) => V): (key: K) => V {
  const answers = new Map<K, V>();
  return (key) => {
    if (!answers.has(key)) answers.set(key, workOut(key));
    return answers.get(key)!;
  };
}
