/// What each channel of a texel adds to the sum of values times their weights, and to the sum of weights: voxels without data have neither.
/// A linear filter may come before both.
uniform vec4 uValueChannels;
uniform vec4 uWeightChannels;

/// Texels store differences from this value.
uniform float uWeighedFrom;
