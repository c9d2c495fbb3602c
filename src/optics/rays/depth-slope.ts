/**
 * How much a depth buffer's values change from one pixel to the next. Along a plane that is the difference to either side; beside an edge, that
 * to the side on which there is none; at a line of one pixel it is about 0.
 * Source: van Albada, van Leer and Roberts, *A Comparative Study of Computational Methods in Cosmic Gas Dynamics*, 1982.
 * Twin: shaders/chunks/depth/scene-depth.glsl
 */
export function depthSlope(before: number, here: number, after: number): number {
  const [a, b] = [here - before, after - here];
  return (a * b * (a + b)) / Math.max(a ** 2 + b ** 2, 1e-30);
}
