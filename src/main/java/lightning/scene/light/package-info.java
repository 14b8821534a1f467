/**
 * Lights, light groups and the rig that resolves them to what shines.
 * Samples of lights and their shading belong to {@code render.shading}.
 */
@NullMarked
package lightning.scene.light;

import org.jspecify.annotations.NullMarked;
