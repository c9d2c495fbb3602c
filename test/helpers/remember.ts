/** The same function, but it computes its result only once for each key: for references that both versions of WebGL are compared with. */
export function remember<K, V>(workOut: (key: K) => V): (key: K) => V {
  const answers = new Map<K, V>();
  return (key) => {
    if (!answers.has(key)) answers.set(key, workOut(key));
    return answers.get(key)!;
  };
}
