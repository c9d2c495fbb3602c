// three.js as its volume examples use it: the back faces of a box, a march in equal steps in its fragment shader, opacity
// corrected for the step, and an end where next to nothing shines through.
import * as THREE from 'three';

const vertexShader = `
in vec3 position;
uniform mat4 modelMatrix;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec3 cameraPosition;
out vec3 vOrigin;
out vec3 vDirection;

void main() {
  vOrigin = (inverse(modelMatrix) * vec4(cameraPosition, 1.0)).xyz;
  vDirection = position - vOrigin;
  gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
}`;

const fragmentShader = `
precision highp float;
precision highp sampler3D;
in vec3 vOrigin;
in vec3 vDirection;
uniform sampler3D volume;
uniform sampler2D colors;
uniform vec2 domain;
uniform vec3 edges;
uniform float stepLength;
uniform float referenceLength;
out vec4 color;

void main() {
  vec3 direction = normalize(vDirection);
  vec3 a = (vec3(-0.5) - vOrigin) / direction;
  vec3 b = (vec3(0.5) - vOrigin) / direction;
  vec3 near = min(a, b);
  vec3 far = max(a, b);
  float begin = max(0.0, max(near.x, max(near.y, near.z)));
  float end = min(far.x, min(far.y, far.z));
  if (begin >= end) discard;
  // The box's own units are not the world's.
  float delta = stepLength / length(direction * edges);
  vec3 point = vOrigin + begin * direction + 0.5;
  vec3 stride = direction * delta;
  color = vec4(0.0);
  for (float t = begin + 0.5 * delta; t < end; t += delta) {
    float value = texture(volume, vOrigin + t * direction + 0.5).r;
    vec4 at = texture(colors, vec2((value - domain.x) / (domain.y - domain.x), 0.5));
    at.a = 1.0 - pow(1.0 - at.a, stepLength / referenceLength);
    color.rgb += (1.0 - color.a) * at.a * at.rgb;
    color.a += (1.0 - color.a) * at.a;
    if (color.a > 0.99) break;
  }
}`;

/** @see peers/README.md for what a peer is given and gives */
export async function start(host, { dimensions, spacing, samples, domain, table, referenceLength, camera }) {
  const renderer = new THREE.WebGLRenderer({ antialias: false, alpha: false, preserveDrawingBuffer: true });
  renderer.setPixelRatio(1);
  renderer.setClearColor(0x000000, 1);
  host.append(renderer.domElement);

  const volume = new THREE.Data3DTexture(samples, ...dimensions);
  volume.format = THREE.RedFormat;
  volume.type = samples instanceof Uint8Array ? THREE.UnsignedByteType : THREE.FloatType;
  if (samples instanceof Uint8Array) volume.internalFormat = 'R8';
  volume.minFilter = volume.magFilter = THREE.LinearFilter;
  volume.unpackAlignment = 1;
  volume.needsUpdate = true;
  // Bytes come out of their texture as 0..1.
  const unit = samples instanceof Uint8Array ? 255 : 1;

  const colors = new THREE.DataTexture(table, table.length / 4, 1, THREE.RGBAFormat, THREE.FloatType);
  colors.minFilter = colors.magFilter = THREE.LinearFilter;
  colors.needsUpdate = true;

  const edges = dimensions.map((n, axis) => n * spacing[axis]);
  const material = new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    uniforms: {
      volume: { value: volume },
      colors: { value: colors },
      domain: { value: new THREE.Vector2(domain[0] / unit, domain[1] / unit) },
      edges: { value: new THREE.Vector3(...edges) },
      stepLength: { value: 1 },
      referenceLength: { value: referenceLength },
    },
    vertexShader,
    fragmentShader,
    side: THREE.BackSide,
    transparent: true,
    blending: THREE.CustomBlending,
    blendSrc: THREE.OneFactor,
    blendDst: THREE.OneMinusSrcAlphaFactor,
  });
  const box = new THREE.Mesh(new THREE.BoxGeometry(1, 1, 1), material);
  box.scale.set(...edges);
  const scene = new THREE.Scene();
  scene.add(box);
  const view = new THREE.PerspectiveCamera(
    (camera.fieldOfView * 180) / Math.PI,
    1,
    camera.distance * 0.01,
    camera.distance * 10,
  );
  view.position.set(...camera.eye);
  view.up.set(...camera.up);
  view.lookAt(...camera.target);

  const gl = renderer.getContext();
  return {
    setSize: (size) => renderer.setSize(size, size),
    draw(stepLength) {
      material.uniforms.stepLength.value = stepLength;
      renderer.render(scene, view);
    },
    gl,
    dispose() {
      renderer.dispose();
      renderer.forceContextLoss();
      renderer.domElement.remove();
    },
  };
}
