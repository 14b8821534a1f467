package lightning.scene;

import lightning.base.math.Transform;

/**
 * A shape of the tree with its material looked up and all the groups around it multiplied in.
 *
 * @param toWorld        maps the shape's own coordinates to the scene's
 * @param directionsToLocal maps directions in the scene to the shape's own: the inverse without translation
 * @param error          how far both may be off
 */
public record PlacedShape(Shape shape, Material material, Transform toWorld, Transform directionsToLocal, PlacementError error) {}
