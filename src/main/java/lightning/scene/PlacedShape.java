package lightning.scene;

import lightning.base.math.Transform;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.value.PlacementError;

/**
 * Shape with its material resolved and the transforms of all enclosing groups applied.
 *
 * @param toWorld           map from shape coordinates to the scene's
 * @param directionsToLocal map of directions from the scene to the shape: the inverse without translation
 * @param error             error bounds of both maps
 */
public record PlacedShape(Shape shape, Material material, Transform toWorld, Transform directionsToLocal, PlacementError error) {}
