/// Voxels of the layer along i, j and k.
uniform vec3 uOverlayDimensions;

/// From the volume's unit cube to the layer's unit cube.
uniform mat4 uToOverlay;
