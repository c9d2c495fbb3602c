/** Returns the same function, but it keeps its last answer: along a ray, the back of one piece is the front of the next. */
export function keepLast<K extends object, V>(workOut: (key: K) => V): (key: K) => V {
  let last: { readonly key: K; readonly answer: V } | null = null;
  return (key) => {
    if (last?.key !== key) last = { key, answer: workOut(key) };
    return last.answer;
  };
}
