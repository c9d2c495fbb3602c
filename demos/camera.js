// Buttons set `camera-orbit`; when a person turns the picture, the line says where the camera is.
const orbiting = document.querySelector('#orbiting');
const place = document.querySelector('#place');

for (const button of document.querySelectorAll('[data-orbit]')) {
  button.addEventListener('click', () => {
    orbiting.cameraOrbit = button.dataset.orbit;
    place.textContent = `camera-orbit="${button.dataset.orbit}"`;
  });
}

orbiting.addEventListener('camera-change', ({ detail: { orbit } }) => {
  const degrees = (radians) => Math.round((radians * 180) / Math.PI);
  place.textContent = `camera-orbit="${degrees(orbit.theta)}deg ${degrees(orbit.phi)}deg ${Math.round(orbit.radius)}"`;
});

// The author's own viewpoint: changing its attributes moves the camera.
const viewpoint = document.querySelector('viewpoint');
const markup = document.querySelector('#viewpoint-markup');

function show() {
  const attributes = ['position', 'orientation', 'fieldofview'].map(
    (name) => `${name}="${viewpoint.getAttribute(name)}"`,
  );
  markup.textContent = `<viewpoint ${attributes.join('\n           ')}></viewpoint>`;
}

for (const button of document.querySelectorAll('[data-position]')) {
  button.addEventListener('click', () => {
    viewpoint.setAttribute('orientation', button.dataset.orientation);
    viewpoint.setAttribute('position', button.dataset.position);
    show();
  });
}
show();
