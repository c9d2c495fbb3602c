// Picks where a layer shows what the volume has no data of.
import { expect } from '@esm-bundle/chai';
import { orbitCamera, projectionMatrix, viewMatrix } from '../../../../src/optics/rays/camera.ts';
import type { RayStyle } from '../../../../src/optics/rays/ray-style.ts';
import { makeOverlay } from '../../../../src/viewer/attachments/make-overlay.ts';
import { pick } from '../../../../src/viewer/picking/pick.ts';
import type { VolumePick } from '../../../../src/viewer/model/volume-pick.ts';
import type { Viewer } from '../../../../src/viewer/view/viewer.ts';
import { styleOf } from '../../../../src/viewer/model/volume-info.ts';
import type { VolumeOptics } from '../../../../src/viewer/model/volume-info.ts';
import { overlayOf } from '../../../helpers/overlays.ts';
import { plainOptics } from '../../../helpers/picture.ts';
import { createQuietLayer } from '../../../helpers/quiet-layer.ts';
import { syntheticVolume } from '../../../helpers/synthetic.ts';
import { fakeOf } from '../../../helpers/fake.ts';

/** Data in its left half alone, of which little shows. */
const volume = {
  ...syntheticVolume({ dimensions: [10, 10, 10], kind: 'float32', field: (x) => (x > 0.5 ? NaN : 0.2) }),
  hasNoData: true,
};
const layer = syntheticVolume({ dimensions: [10, 10, 10], kind: 'float32', field: () => 1 });

async function pickAt(
  across: number,
  { styles, blend = 'mix' }: Pick<RayStyle, 'styles'> & { blend?: 'mix' | 'color' },
): Promise<VolumePick | null> {
  const optics = {
    ...plainOptics,
    projection: null,
    surfaces: null,
    shading: 'unlit',
    ...(styles && { styles }),
  } as unknown as VolumeOptics;
  const overlay = makeOverlay(overlayOf(volume, layer, { blend }), 'PET');
  const quiet = createQuietLayer();
  quiet.set(volume);
  await Promise.all([
    quiet.setAppearance({ optics, style: styleOf(optics) }),
    quiet.setAttached((attached) => attached.setOverlay(overlay.shown)),
  ]);
  const view = {
    view: viewMatrix(orbitCamera({ theta: 0, phi: Math.PI / 2, radius: 30 }, [0, 0, 0], 0.6)),
    projection: projectionMatrix(0.6, 1, 1, 2),
  };
  const viewer = fakeOf<Viewer>('Viewer', {
    volume,
    optics,
    drawn: volume,
    rig: undefined,
    place: {
      host: fakeOf<Pick<HTMLElement, 'clientWidth' | 'clientHeight'>>('host', {
        clientWidth: 100,
        clientHeight: 100,
      }) as HTMLElement,
    },
    shown: { grid: volume.grid, cuts: { region: null, slices: [], cuts: [] }, labels: null, overlay },
    scene: { getView: () => view },
    controller: { twins: (looks: boolean) => quiet.twins(false, looks) },
  });
  return pick(viewer, [across, 50]);
}

describe('a pick where a layer shows, and the volume has no data', () => {
  for (const [name, styles] of [
    ['as it is', undefined],
    ['in a style', [{ weight: 1, styles: [{ kind: 'silhouette', retained: 0.5, boundary: 1, sharpness: 2 }] }]],
  ] as const) {
    it(`has the layer's value, and says that there is none of the volume: ${name}`, async () => {
      const both = [await pickAt(40, { styles }), await pickAt(60, { styles })];
      const [there, attached] = both[0]?.voxel ? both : [both[1], both[0]];
      expect(there!.value).to.be.closeTo(0.2, 1e-6);
      expect(attached!.value).to.deep.equal(NaN);
      expect([attached!.voxel, attached!.layers]).to.deep.equal([null, [{ name: 'PET', value: 1, unit: '' }]]);
      expect(attached!.opacity, 'as opaque as it is drawn').to.be.within(0.5, 1);
      expect(attached!.world[2]).to.be.within(-5, 5);
    });
  }

  it('has no value where the layer only colours', async () => {
    const both = [await pickAt(40, { blend: 'color' }), await pickAt(60, { blend: 'color' })];
    expect(both.filter((one) => one === null)).to.have.length(1);
  });
});
