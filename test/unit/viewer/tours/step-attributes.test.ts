import { expect } from '@esm-bundle/chai';
import { VolumeViewAttributes } from '../../../../components/volume-view/volume-view-attributes.ts';
import { notInSteps, stepAttributes } from '../../../../src/viewer/tours/step-attributes.ts';

describe('the attributes of steps', () => {
  it('and those that are not for steps are together all attributes of the view', () => {
    const all = [...VolumeViewAttributes.elementProperties.values()].map(({ attribute }) => attribute);
    expect(all).to.include.members(['src', 'camera-orbit', 'transfer-function']);
    expect([...stepAttributes, ...notInSteps]).to.have.members(all);
  });
});
