/** Physical sky: the light of the sun that air scatters, and the sun itself. */
@NullMarked
package lightning.scene.sky;

import org.jspecify.annotations.NullMarked;
