<?php
/**
 * What the attributes mean, for the side panel of the editor.
 *
 * Written by `npm run docs` of the project of the element; edit the element, not this file.
 *
 * @package VolumeView
 * @license MIT
 */

defined( 'ABSPATH' ) || exit;

/**
 * What the attributes mean, for the side panel of the editor.
 *
 * @return array<string, string> By the names of attributes.
 */
function volume_view_descriptions() {
	return array(
		'src'                   => __( 'URL of the data: a NIfTI, NRRD or MetaImage file or one of more formats, a mosaic image, a radar scan (ODIM_H5, CfRadial, NEXRAD Level II), a JSON manifest, a ZIP archive that holds one volume, or the folder of an OME-Zarr (`brain.ome.zarr`). Several URLs, separated by blanks, are scans in the order of time, and so are the volumes of one file that holds several; a blank within a URL is written `%20`.', 'volume-view' ),
		'stack'                 => __( 'The files of `src` are one volume: images, one for each slice, or a header and its data files. Without it they are scans in time.', 'volume-view' ),
		'mosaic'                => __( 'Tiles per row and column of a mosaic image, `COLUMNSxROWS`, row by row from the top left.', 'volume-view' ),
		'slices'                => __( 'Number of tiles of the mosaic that contain slices; by default all of them.', 'volume-view' ),
		'spacing'               => __( 'World units per voxel; for a mosaic, per pixel and slice: `x y z`. By default as in the file, or 1 1 1. A negative number reverses its axis, for instance for slices that run from head to feet.', 'volume-view' ),
		'coordinates'           => __( 'The grid of the data in a mosaic: `cartesian`, or `spherical` for the sweeps of a radar, one in each tile.', 'volume-view' ),
		'elevations'            => __( 'Elevations of the mosaic of a radar, degrees, one for each tile: `0.5 1.2 2.4`.', 'volume-view' ),
		'range'                 => __( 'For the mosaic of a radar: distance to the middle of the first gate, and from gate to gate, in metres.', 'volume-view' ),
		'azimuth'               => __( 'For the mosaic of a radar: middle of the first radial and step to the next, degrees clockwise from north; by default a full circle.', 'volume-view' ),
		'series'                => __( 'Which volume is shown where the files hold several, as a folder of DICOM may: a number from 1, in the order of `volume.series`. By default the largest file, and of series of DICOM the one with the most voxels.', 'volume-view' ),
		'max-bytes'             => __( 'The bytes that the shown level of an OME-Zarr may have at most, `50e6` for 50 MB; by default what the device holds. A coarser level is read where one does not fit, and `volume.reduced` says so. It turns off bricks, see `max-gpu-bytes`.', 'volume-view' ),
		'max-gpu-bytes'         => __( 'Shows an OME-Zarr that is larger than so many bytes in bricks of finer levels, which take at most these bytes of the GPU\'s memory: `256e6` for 256 MB. All elements of a page share what the largest of these numbers says. By default bricks come where the device does not hold the finest level, in 256 MiB, or 128 on small devices.', 'volume-view' ),
		'clean'                 => __( 'Hides isolated parts, such as a head rest or specks. It looks at all voxels above a value. A part is hidden if no voxel faces connect it to the largest part or to a part of at least a tenth of its size. By default the value is where the volume begins to be visible. You can set the value, `clean="150"`, for instance if your `transfer-function` shows lower values. Picks, slices and statistics ignore hidden parts too, and `volume.left` says how much is hidden. It works for CT, MRI and similar data; not for labels and radar scans.', 'volume-view' ),
		'moment'                => __( 'The quantity of a radar scan, as its file names it: `DBZH`, `VRAD` ... By default the reflectivity.', 'volume-view' ),
		'color-moment'          => __( 'For a radar scan: another quantity of its file that colours the first one: `VRADH` for reflectivity coloured by velocity.', 'volume-view' ),
		'beam-model'            => __( 'Path of the beams of a radar: `standard`, bent by the atmosphere over a round Earth (4/3 of its radius), or `straight` over a flat one.', 'volume-view' ),
		'vertical-exaggeration' => __( 'Factor by which heights of a radar scan are enlarged; 5 by default, 1 where the range is less than 50 km.', 'volume-view' ),
		'time'                  => __( 'Which of several scans is shown: a zero-based index, or a time in UTC, `2018-12-20T06:06:28Z`, for the latest scan at or before it (the first one if all are later); `12.5 s` where a file counts from its start. By default the first. Setting it shows that scan, even if `next`, `previous`, `play` or a person chose another one since; `scan` says which one is shown.', 'volume-view' ),
		'autoplay'              => __( 'Shows several scans one after the other as soon as a source is open, without `play()`, and starts again after the last. If a person has asked their system for less motion, it waits for `play()`.', 'volume-view' ),
		'play-speed'            => __( 'Scans per second while they play, or as many as can be loaded and drawn; 2 by default.', 'volume-view' ),
		'look'                  => __( 'One word for colours, light, opacity and projection that suit the data: `textbook` and `flat` for all data; `mip` for all data except labels; `xray` and `skin` for CT and MRI; `bone` and `vessels` for CT. Other attributes override it.', 'volume-view' ),
		'transfer-function'     => __( 'The name of a preset, or stops `value colour opacity, ...`; by default a preset that suits the histogram of the data.', 'volume-view' ),
		'projection'            => __( 'Shows one value of each ray in the colours of the transfer function, instead of all that shines and absorbs along the ray: `max`, the largest value, `min`, the smallest, or `average`. The largest opacity then counts as 1.', 'volume-view' ),
		'shading'               => __( '`lit` shows the orientation of surfaces in the volume, by a light at the eye and the X3D lights among the children; `unlit` shows the colours as they are in the legend; `ambient-occlusion` is `lit`, with soft shadows in caves and folds. By default the surfaces of `surface-values` are lit, and MRI and CT if no other attribute and no child decides how they look. A `projection` is never lit.', 'volume-view' ),
		'surface-values'        => __( 'Surfaces where the data have a given value: `value colour opacity, ...`, at most four, each lit. A value is a number or a percentage of the window. The opacity, 1 by default, is the share of light that one surface blocks. Without a `transfer-function` only these surfaces are shown.', 'volume-view' ),
		'gradient-opacity'      => __( 'Factors of the opacity that depend on how steeply values change: `gradient factor, ...`. For instance `0 0, 10% 1` keeps boundaries and hides regions of even values. A gradient is in data units per world unit (of a CT, HU per millimetre), or a percentage of the window along a reference length. Gradients have to ascend.', 'volume-view' ),
		'transfer-function-2d'  => __( 'Colours and opacities by value and gradient: `box low high low high colour opacity`, values before gradients, and `gaussian value gradient width width colour opacity`, separated by commas, at most eight. It replaces `transfer-function`; gradients are as in `gradient-opacity`.', 'volume-view' ),
		'value-window'          => __( 'The range of data values, `low high`, that presets and percentages refer to; by default that of the histogram. Of a DICOM file with windows also the name or the number of one of them, `lung` or `2`.', 'volume-view' ),
		'reference-length'      => __( 'The world length to which the opacity of a stop refers; by default 1 % of the longest edge of the volume, less where the volume is thin.', 'volume-view' ),
		'opacity-factor'        => __( 'Multiplies the extinction of the whole volume; 1 by default.', 'volume-view' ),
		'light-factor'          => __( 'Multiplies the light of the whole volume, which saturates at white; 1 by default.', 'volume-view' ),
		'steps'                 => __( 'Number of steps along the longest ray. A step takes one sample, or several where something may be visible. `auto`, the default, keeps `target-fps` while something moves and `max-error` at rest.', 'volume-view' ),
		'max-error'             => __( 'With `steps="auto"`: the error that a picture at rest may have, in 1/255; 1 by default. The RMS error is at most this, and at most one pixel in a thousand differs by more than 8 times as much.', 'volume-view' ),
		'detail'                => __( 'With `steps="auto"`: whether a picture at rest keeps small things. `keep`, the default, takes a sample in each voxel of each ray, and a ray for each pixel. `free` leaves out what `max-error` does not need: less work, but single voxels and thin lines may be missing.', 'volume-view' ),
		'target-fps'            => __( 'With `steps="auto"`: frames per second while something moves; steps and pixels are chosen so that the device reaches this rate; 30 by default.', 'volume-view' ),
		'region'                => __( 'The only part that is shown, and that the camera frames: two opposite corners of a box, `x0 y0 z0 x1 y1 z1`, in world units; for a radar scan in metres east, north and above the antenna, before the exaggeration of heights.', 'volume-view' ),
		'cutout'                => __( 'A box that is cut out, written as `region`. What lies behind it becomes visible.', 'volume-view' ),
		'rings'                 => __( 'Rings around a radar at the height of its antenna, and a line to the north. The value is the distance between rings in kilometres; an empty value chooses a round distance that suits the range of the radar, or the `region`, which clips the rings. By default a radar has such rings and lines between them, as its ground; with `none` it has neither.', 'volume-view' ),
		'camera-orbit'          => __( 'Position of the camera, `theta phi radius`, for instance `30deg 70deg 110%`; each part may be `auto`. Setting it moves the camera there, wherever a person has moved it; reading it returns the present position.', 'volume-view' ),
		'camera-target'         => __( 'The point that the camera looks at, world coordinates `x y z`; by default the centre of the volume. Set and read like `cameraOrbit`.', 'volume-view' ),
		'field-of-view'         => __( 'Vertical angle of view; 30deg by default.', 'volume-view' ),
		'min-camera-orbit'      => __( 'Lower limits for the camera, written as `camera-orbit`; parts may be `auto` and `Infinity`. By default phi is from 0deg to 180deg, theta has no limit, and a person can bring the camera no nearer than about a hundredth of the distance that shows the whole volume.', 'volume-view' ),
		'max-camera-orbit'      => __( 'Upper limits for the camera, written as `min-camera-orbit`. By default a person can bring the camera no farther than four times the distance that shows the whole volume, or than the distance in `camera-orbit`.', 'volume-view' ),
		'interpolation-decay'   => __( 'How slowly the camera moves to where an attribute, a button or a key sends it: after this number of milliseconds it has gone 63 % of the way. With 0 it jumps there at once, as it does under `prefers-reduced-motion` and before the first picture.', 'volume-view' ),
		'auto-rotate'           => __( 'The camera moves around the volume by itself while nobody moves it and the element is in sight; not under `prefers-reduced-motion`. A button in the picture stops and restarts it.', 'volume-view' ),
		'auto-rotate-delay'     => __( 'Milliseconds until `auto-rotate` begins, counted from the first picture and from the last movement by a person.', 'volume-view' ),
		'rotation-per-second'   => __( 'Speed of `auto-rotate`: an angle per second, `10deg` or `0.2rad`, or a percentage of the usual speed, which is one turn in 64 seconds; negative values turn the other way.', 'volume-view' ),
		'orientation-marker'    => __( 'Shows the orientation of the picture in one of its corners: the letters R, L, A, P, S, I for the sides of a patient, or N, E, S, W for a radar. Each letter is a button that turns the view to that side. Nothing is shown where the file does not say which sides its axes point to.', 'volume-view' ),
		'interaction'           => __( 'What mouse, fingers and keys move: the camera, or, with `none`, nothing.', 'volume-view' ),
		'controls'              => __( 'Shows buttons over the picture, as on a video: standard views, zoom, the first view, full screen, save, copy the view or the code of an iframe, help.', 'volume-view' ),
		'controlslist'          => __( 'Which of the `controls` are left out, separated by blanks: `noplay`, `norotate`, `noviews`, `nozoom`, `noreset`, `nofullscreen`, `nosave`, `nocopy`, `nolink`, `noembed`, `nohelp`, `nohint`.', 'volume-view' ),
		'pickable'              => __( 'A click or a tap on the picture fires `volume-pick`, with the value at that place. A `<volume-readout>` or a `<volume-slice-view>` for the element has the same effect.', 'volume-view' ),
		'self-check'            => __( 'Checks each picture at rest: some of its rays are computed on the CPU too, in 64 bits. If the GPU draws something different, an `error` with the code `webgl/inaccurate` is fired; `picture-check` fires in any case.', 'volume-view' ),
		'width'                 => __( 'Width of the element where CSS sets none: pixels, or a percentage. Together with `height` it sets the aspect ratio.', 'volume-view' ),
		'height'                => __( 'Height of the element where CSS sets none, written as `width`.', 'volume-view' ),
		'alt'                   => __( 'A description of the picture, for people who do not see it.', 'volume-view' ),
		'poster'                => __( 'URL of an image that is shown until the first picture.', 'volume-view' ),
		'loading'               => __( '`lazy`, the default, starts to load when the element comes near the visible part of the page, or when a script requests its picture; `eager` loads at once.', 'volume-view' ),
	);
}
