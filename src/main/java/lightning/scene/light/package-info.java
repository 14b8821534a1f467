/** Lights, light groups and the rig that resolves them to what shines. */
@NullMarked
package lightning.scene.light;

import org.jspecify.annotations.NullMarked;
