// HTML reads `<Viewpoint/>` as an opening tag: what follows it stands in it, and is found where it was meant to be.
import { expect } from '@esm-bundle/chai';
import { authorChildren } from '../../../src/x3d/author-children.ts';
import { AuthorCopies } from '../../../src/x3d/author-copies.ts';
import { meantChildren, meantParent } from '../../../src/page/unclosed.ts';

function hostOf(html: string): HTMLElement {
  const host = document.createElement('div');
  host.innerHTML = html;
  return host;
}

const names = (elements: readonly Element[]): string[] => elements.map(({ localName }) => localName);

describe('X3D nodes that were not closed', () => {
  it('leave what follows them where it was meant to be', () => {
    const open =
      '<Viewpoint/><Background/><DirectionalLight/><VolumeData><ImageTextureAtlas/><CartoonVolumeStyle></CartoonVolumeStyle></VolumeData><Transform><Shape><Box></Box></Shape></Transform>';
    const closed = open.replace(/<(\w+)\/>/g, '<$1></$1>');
    for (const html of [open, closed])
      expect(names(authorChildren(hostOf(html)))).to.deep.equal([
        'viewpoint',
        'background',
        'directionallight',
        'transform',
      ]);
    const host = hostOf(open);
    for (const one of authorChildren(host)) expect(meantParent(one)).to.equal(host);
    expect(names(meantChildren(host.querySelector('volumedata')!))).to.deep.equal([
      'imagetextureatlas',
      'cartoonvolumestyle',
    ]);
  });

  it('keep what is their own', () => {
    const host = hostOf(
      '<ImageTexture><TextureProperties/></ImageTexture><Texture><canvas></canvas></Texture><Material><MetadataString/></Material><Shape><Appearance><Material/></Appearance><Box/></Shape>',
    );
    expect(names(meantChildren(host))).to.deep.equal(['imagetexture', 'texture', 'material', 'shape']);
    expect(names(meantChildren(host.querySelector('imagetexture')!))).to.deep.equal(['textureproperties']);
    expect(names(meantChildren(host.querySelector('shape')!))).to.deep.equal(['appearance', 'box']);
  });

  it('are copied into a scene as if they had been closed', () => {
    const inside = (html: string): string =>
      new AuthorCopies(() => {}).copy(hostOf(html).firstElementChild!)!.outerHTML;
    const group =
      '<Transform><PointLight/><Shape><Appearance><Material diffuseColor="1 0 0"/><ImageTexture/></Appearance><Box/></Shape><Viewpoint/><Group></Group></Transform>';
    const closed = group.replace(
      /<(PointLight|Material diffuseColor="1 0 0"|ImageTexture|Box|Viewpoint)\/>/g,
      (_, tag: string) => `<${tag}></${tag.split(' ')[0]}>`,
    );
    expect(inside(group)).to.equal(inside(closed)).and.to.contain('box');
  });
});
