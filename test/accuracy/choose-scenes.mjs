/**
 * The scenes of a run: those with one of the words of SCENES in their names, SCENES=mri,wires; of a short run a few of them.
 * @param {readonly string[]} all - names
 * @param {number | false} every - of a short run one scene of so many
 */
export function chooseScenes(all, every) {
  const words = process.env.SCENES?.toLowerCase().split(',') ?? [''];
  return all.filter(
    (name, i) => words.some((word) => name.toLowerCase().includes(word)) && (every === false || i % every === 0),
  );
}
