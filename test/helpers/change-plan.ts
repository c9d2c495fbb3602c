import type { ScenePlan, VolumeScene } from '../../src/x3d/scene.ts';

/** Change some members of a scene's plan: tests draw one scene in many ways. */
export function changePlan(scene: VolumeScene, change: Partial<ScenePlan>): void {
  scene.apply({ ...scene.plan, ...change });
}

/** Draw a picture with another step length, in world units. */
export function drawAt(scene: VolumeScene, stepLength: number, time?: number): void {
  changePlan(scene, { stepLength });
  scene.draw(time);
}
