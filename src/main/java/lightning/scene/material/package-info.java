/** Materials and their attributes. */
@NullMarked
package lightning.scene.material;

import org.jspecify.annotations.NullMarked;
