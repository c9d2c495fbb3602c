// What the types are to refuse: test/bundlers/run.mjs counts the errors, one for each line that says so.
import 'volume-view/react';

export const wrong = [
  <volume-view scr="/volume.nii.gz" />, // wrong: no such attribute
  <volume-view src="/volume.nii.gz" valueWindow={[0, 1, 2]} />, // wrong: two numbers
  <volume-view src="/volume.nii.gz" onload={(event: MouseEvent) => event} />, // wrong: another event
  <volume-viewer src="/volume.nii.gz" />, // wrong: no such tag
];

export const right = [
  <volume-view key="a" src={null} className="wide" valueWindow="0 100" transferFunction={[]} transfer-function="ct-bone" steps="auto" ref={(view) => void view?.whenRendered()} />,
  <volume-legend key="b" for="a" />,
  <volume-transfer-function key="c" htmlFor="a" onchange={({ detail }) => detail.transferFunction.length} />,
];
