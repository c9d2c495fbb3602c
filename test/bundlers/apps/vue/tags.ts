// The types of the tags in Vue's templates. Its own checker of templates does not run here; this says what it would look up.
import type { GlobalComponents } from 'vue';
import 'volume-view/vue';

type Props<Tag extends keyof GlobalComponents> = InstanceType<GlobalComponents[Tag]>['$props'];

export const right: Props<'volume-view'> = { src: 'a.nii', class: 'wide', valueWindow: [0, 100], 'transfer-function': 'ct-bone', onCameraChange: ({ detail }) => detail.orbit };
export const wrong: Props<'volume-view'>[] = [
  { scr: 'a.nii' }, // wrong: no such attribute
  { src: 'a.nii', valueWindow: [0, 1, 2] }, // wrong: two numbers
  { src: 'a.nii', onLoad: (event: MouseEvent) => event }, // wrong: another event
];
