// vtk.js: its volume mapper in composite mode, with shading where a scene has a light.
import '@kitware/vtk.js/Rendering/Profiles/Volume';
import { newInstance as newDataArray } from '@kitware/vtk.js/Common/Core/DataArray';
import { newInstance as newImageData } from '@kitware/vtk.js/Common/DataModel/ImageData';
import { newInstance as newPiecewiseFunction } from '@kitware/vtk.js/Common/DataModel/PiecewiseFunction';
import { newInstance as newColorTransferFunction } from '@kitware/vtk.js/Rendering/Core/ColorTransferFunction';
import { newInstance as newRenderer } from '@kitware/vtk.js/Rendering/Core/Renderer';
import { newInstance as newRenderWindow } from '@kitware/vtk.js/Rendering/Core/RenderWindow';
import { newInstance as newRenderWindowInteractor } from '@kitware/vtk.js/Rendering/Core/RenderWindowInteractor';
import { newInstance as newVolume } from '@kitware/vtk.js/Rendering/Core/Volume';
import { newInstance as newVolumeMapper } from '@kitware/vtk.js/Rendering/Core/VolumeMapper';
import { newInstance as newOpenGLRenderWindow } from '@kitware/vtk.js/Rendering/OpenGL/RenderWindow';

/** @see peers/README.md for what a peer is given and gives */
export async function start(host, { dimensions, spacing, samples, domain, table, referenceLength, camera, light }) {
  const image = newImageData();
  image.setDimensions(...dimensions);
  image.setSpacing(...spacing);
  // It places the centre of the first voxel.
  image.setOrigin(...dimensions.map((n, axis) => (-(n - 1) / 2) * spacing[axis]));
  image.getPointData().setScalars(newDataArray({ numberOfComponents: 1, values: samples }));

  const opacity = newPiecewiseFunction();
  const color = newColorTransferFunction();
  const count = table.length / 4;
  for (let i = 0; i < count; i++) {
    const value = domain[0] + (i / (count - 1)) * (domain[1] - domain[0]);
    const [red, green, blue, alpha] = table.subarray(i * 4, i * 4 + 4);
    opacity.addPoint(value, alpha);
    color.addRGBPoint(value, red, green, blue);
  }

  const mapper = newVolumeMapper();
  mapper.setInputData(image);
  mapper.setAutoAdjustSampleDistances(false);
  mapper.setImageSampleDistance(1);
  mapper.setBlendModeToComposite();
  const volume = newVolume();
  volume.setMapper(mapper);
  const property = volume.getProperty();
  property.setRGBTransferFunction(0, color);
  property.setScalarOpacity(0, opacity);
  property.setScalarOpacityUnitDistance(0, referenceLength);
  property.setInterpolationTypeToLinear();
  property.setShade(light !== undefined);
  if (light) {
    property.setAmbient(light.ambient);
    property.setDiffuse(light.diffuse);
    property.setSpecular(light.specular);
    property.setSpecularPower(light.shininess);
    if (light.fadesFlat) {
      property.setUseGradientOpacity(0, true);
      property.setGradientOpacityMinimumValue(0, 0);
      property.setGradientOpacityMaximumValue(0, light.fadesFlat * (domain[1] - domain[0]));
      property.setGradientOpacityMinimumOpacity(0, 0);
      property.setGradientOpacityMaximumOpacity(0, 1);
    }
  }

  const renderer = newRenderer({ background: [0, 0, 0] });
  renderer.addVolume(volume);
  const view = renderer.getActiveCamera();
  view.setPosition(...camera.eye);
  view.setFocalPoint(...camera.target);
  view.setViewUp(...camera.up);
  view.setViewAngle((camera.fieldOfView * 180) / Math.PI);
  renderer.resetCameraClippingRange();

  const window = newRenderWindow();
  window.addRenderer(renderer);
  const openGl = newOpenGLRenderWindow();
  openGl.setContainer(host);
  window.addView(openGl);
  // Its mapper asks the interactor whether something moves.
  const interactor = newRenderWindowInteractor();
  interactor.setView(openGl);
  interactor.initialize();

  return {
    setSize: (size) => openGl.setSize(size, size),
    draw(stepLength) {
      if (mapper.getSampleDistance() !== stepLength) {
        mapper.setSampleDistance(stepLength);
        mapper.setMaximumSamplesPerRay(100_000);
        // Its table of opacities holds for the distance for which it was made.
        opacity.modified();
      }
      window.render();
    },
    get gl() {
      return openGl.getContext();
    },
    dispose() {
      interactor.delete();
      openGl.getContext().getExtension('WEBGL_lose_context')?.loseContext();
      host.replaceChildren();
    },
  };
}
