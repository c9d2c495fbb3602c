// The sliders change attributes of X3D elements between the tags; the scene follows.
const probe = document.querySelector('#probe');
const tip = document.querySelector('#tip');
const view = document.querySelector('volume-view');
const inputs = Object.fromEntries(['x', 'y', 'z', 'size', 'opacity'].map((id) => [id, document.getElementById(id)]));
const markup = document.querySelector('#markup');

function update() {
  const { x, y, z, size, opacity } = inputs;
  for (const input of Object.values(inputs))
    input.parentElement.querySelector('output').value = `${input.value} ${input.dataset.unit}`;
  const translation = `${x.value} ${y.value} ${z.value}`;
  probe.setAttribute('translation', translation);
  tip.setAttribute('radius', size.value);
  view.opacityFactor = String(opacity.value / 100);
  markup.textContent = `<transform translation="${translation}">\n  <shape> … <sphere radius="${size.value}"></sphere></shape>\n  …\n</transform>`;
}

for (const input of Object.values(inputs)) input.addEventListener('input', update);
update();
