/// Two ends of rays are on two sides of an edge if they are farther apart than this, in bounding diameters.
uniform float uMinJump;

/// A pixel through which a shape's edge passes, if one does.
struct Split {
  bool isSplit;
  /// Depths as stored in the buffer: in the pixel's middle, on the other side of the edge, and half way between both.
  float own;
  float other;
  float between;
};

/// Where a ray ends, limited to the volume's bounding sphere: all ends before the volume count as equal, and so do all ends behind it.
float endAt(vec2 pixel) {
  return clamp(depthToT(depthAt(pixel)), -0.5, 0.5);
}

/// Find the neighbour on the other side of an edge: the one whose end differs most from the end that the slope at this pixel predicts.
Split splitAt(vec2 pixel) {
  float own = endAt(pixel);
  float jump = uMinJump;
  Split split = Split(false, depthAt(pixel), 1.0, 1.0);
  for (int i = 0; i < 4; i++) {
    vec2 offset = i == 0 ? vec2(1.0, 0.0) : i == 1 ? vec2(0.0, 1.0) : i == 2 ? vec2(1.0, 1.0) : vec2(1.0, -1.0);
    vec2 ends = vec2(endAt(pixel - offset), endAt(pixel + offset)) - own;
    float bend = abs(ends.x + ends.y);
    if (bend <= jump) continue;
    jump = bend;
    split.isSplit = true;
    vec2 away = abs(ends.x) > abs(ends.y) ? -offset : offset;
    float beside = depthAt(pixel + away);
    split.between = 0.5 * (split.own + beside);
    // The edge is about half a pixel from that neighbour. Extrapolate the other side's depth to it, unless another edge follows.
    float rise = beside - depthAt(pixel + 2.0 * away);
    split.other = abs(rise) < 0.25 * abs(split.own - beside) ? clamp(beside + 0.5 * rise, 0.0, 1.0) : beside;
  }
  return split;
}
