/**
 * How much a depth buffer's values change from one pixel to the next. Along a plane, this is the difference to either neighbour. Next to an
 * edge, it is the difference to the side without the edge. At a line of one pixel, it is about 0.
 * Source: van Albada, van Leer and Roberts, *A Comparative Study of Computational Methods in Cosmic Gas Dynamics*, 1982.
 * Twin: shaders/chunks/depth/scene-depth.glsl
 */
export function depthSlope(before: number, here: number, after: number): number {
  const [a, b] = [here - before, after - here];
  return (a * b * (a + b)) / Math.max(a ** 2 + b ** 2, 1e-30);
}
