import type { VolumeView } from '../../components/volume-view/volume-view.ts';

/**
 * Drag an element's camera as a mouse of 60 movements a second does.
 * @param seconds - from the press to the release
 * @param pixels - to the right in all; 1 / 1.2 of the element's height is half a turn, see src/viewer/camera/camera-input.ts
 */
export async function dragCamera(element: VolumeView, seconds: number, pixels: number): Promise<void> {
  const picture = element.shadowRoot!.querySelector<HTMLElement>('.picture')!;
  const began = performance.now();
  const point = (type: string): void => {
    const clientX = ((performance.now() - began) / 1000 / seconds) * pixels;
    picture.dispatchEvent(
      new PointerEvent(type, { pointerId: 1, isPrimary: true, bubbles: true, clientX, clientY: 100 }),
    );
  };
  // A made event has no pointer to capture.
  picture.setPointerCapture = () => {};
  point('pointerdown');
  await new Promise<void>((resolve) => {
    const timer = setInterval(() => {
      point('pointermove');
      if (performance.now() - began < seconds * 1000) return;
      clearInterval(timer);
      resolve();
    }, 1000 / 60);
  });
  point('pointerup');
}
