"""The armour unit: shape, pose, cones, feature points (paper 2.2 and 2.4)."""
