// What the element gets for each style, and what is to be seen then: the markup that is shown is what is between the tags.
const brain = {
  src: 'data/mni152-t1.nii.gz',
  'transfer-function': '0% #d8a48f 0, 33% #d8a48f 0, 40% #e2b9a6 60%, 100% #f4e4d8 90%',
  'camera-orbit': '65deg 75deg 82%',
};
const torso = {
  src: 'data/ct-phantom.json',
  'transfer-function': 'ct-soft-tissue',
  'camera-orbit': '25deg 80deg 100%',
};
const lamp = `<NavigationInfo headlight="false">
</NavigationInfo>
<DirectionalLight direction="-0.3 -0.9 -0.5">
</DirectionalLight>`;

const looks = {
  none: { attributes: brain, words: 'Without a style: colours are those of the values.', markup: '' },
  edges: {
    attributes: brain,
    words: 'What turns away from you by more than 1.15 radians is drawn in the edge’s colour.',
    markup: `<EdgeEnhancementVolumeStyle
  gradientThreshold="1.15"
  edgeColor="0.1 0.05 0.05">
</EdgeEnhancementVolumeStyle>`,
  },
  cartoon: {
    attributes: brain,
    words: 'Four colours, from what faces you to what you see from the side.',
    markup: `<CartoonVolumeStyle colorSteps="4"
  parallelColor="1 0.87 0.7"
  orthogonalColor="0.35 0.1 0.2">
</CartoonVolumeStyle>`,
  },
  tones: {
    attributes: brain,
    words: 'Warm where it faces the lamp, cool where it turns away: technical illustrators keep black for lines.',
    markup: `<ToneMappedVolumeStyle
  coolColor="0.12 0.2 0.55"
  warmColor="1 0.82 0.55">
</ToneMappedVolumeStyle>
${lamp}`,
  },
  shaded: {
    attributes: brain,
    words: 'Light and shade, with a material that shines.',
    markup: `<ShadedVolumeStyle lighting="true">
  <Material ambientIntensity="0.25"
    diffuseColor="1 0.95 0.9"
    specularColor="0.25 0.25 0.25"
    shininess="0.3"></Material>
</ShadedVolumeStyle>
${lamp}`,
  },
  composed: {
    attributes: brain,
    words: 'One after the other: tones, then edges on them.',
    markup: `<ComposedVolumeStyle>
  <ToneMappedVolumeStyle
    coolColor="0.2 0.3 0.6"
    warmColor="1 0.9 0.75">
  </ToneMappedVolumeStyle>
  <EdgeEnhancementVolumeStyle
    gradientThreshold="1.25"
    edgeColor="0.05 0.05 0.15">
  </EdgeEnhancementVolumeStyle>
</ComposedVolumeStyle>
${lamp}`,
  },
  blended: {
    attributes: brain,
    words: 'The sum of two pictures of one volume: two thirds are light, a third is a cartoon.',
    markup: `<ShadedVolumeStyle lighting="true">
</ShadedVolumeStyle>
<BlendedVolumeStyle
  weightConstant1="0.67"
  weightConstant2="0.33">
  <CartoonVolumeStyle colorSteps="3"
    parallelColor="0.4 0.9 1"
    orthogonalColor="0 0.1 0.4">
  </CartoonVolumeStyle>
</BlendedVolumeStyle>`,
  },
  fog: { attributes: torso, words: 'Without a style: what is in front veils what is behind.', markup: '' },
  silhouettes: {
    attributes: torso,
    words: 'Only what is seen from the side stays: outlines, through which you look.',
    markup: `<SilhouetteEnhancementVolumeStyle
  silhouetteSharpness="2"
  silhouetteRetainedOpacity="0.02"
  silhouetteBoundaryOpacity="1">
</SilhouetteEnhancementVolumeStyle>`,
  },
  boundaries: {
    attributes: torso,
    words: 'Only where values change stays: the walls of things, not what is in them.',
    markup: `<BoundaryEnhancementVolumeStyle
  retainedOpacity="0"
  boundaryOpacity="4" opacityFactor="1">
</BoundaryEnhancementVolumeStyle>`,
  },
  projection: {
    attributes: { ...torso, 'transfer-function': 'gray', 'value-window': '0 700' },
    words: 'The densest of each ray, as projection="max" has it.',
    markup: '<ProjectionVolumeStyle type="MAX">\n</ProjectionVolumeStyle>',
  },
};

const view = document.querySelector('#styled');

function show({ attributes, words, markup }) {
  for (const name of ['src', 'transfer-function', 'camera-orbit', 'value-window']) {
    if (attributes[name] === undefined) view.removeAttribute(name);
    else if (view.getAttribute(name) !== attributes[name]) view.setAttribute(name, attributes[name]);
  }
  view.innerHTML = markup;
  document.querySelector('#words').textContent = words;
  document.querySelector('#markup').textContent = markup || 'nothing between the tags';
}

document.querySelector('main').addEventListener('change', ({ target }) => {
  if (target.name === 'style') show(looks[target.value]);
});
show(looks[document.querySelector('input[name="style"]:checked').value]);
