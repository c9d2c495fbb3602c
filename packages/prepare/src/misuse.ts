/** The error for wrong arguments. */
export class Misuse extends Error {}
