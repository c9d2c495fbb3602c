// What is at the crosshair: the first pane tells of all of them.
const place = document.querySelector('#place');
const sides = [
  ['right', 'left'],
  ['front', 'back'],
  ['head', 'feet'],
];

document.querySelector('volume-slice-view').addEventListener('cursor-change', ({ detail: { cursor, value } }) => {
  const words = cursor.map((mm, axis) => `${Math.abs(mm).toFixed(1)} mm to the ${sides[axis][mm < 0 ? 1 : 0]}`);
  place.textContent = `${words.join(', ')}: ${value === null ? 'outside' : `${Math.round(value)} HU`}`;
});
