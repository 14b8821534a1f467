package lightning.scene;

import lightning.math.Transform;

/**
 * A shape of the tree with its material looked up and all the groups around it multiplied in.
 *
 * @param toWorld maps the shape's own coordinates to the scene's
 */
public record PlacedShape(Shape shape, Material material, Transform toWorld) {}
