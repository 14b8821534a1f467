/**
 * Lights, light groups and the rig that resolves them to what shines.
 * Where a light is and what it sends belongs to {@code render.shading}.
 */
@NullMarked
package lightning.scene.light;

import org.jspecify.annotations.NullMarked;
