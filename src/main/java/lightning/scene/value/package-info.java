/** Values that lights, materials, shapes and cameras consist of, and the limits of all of them. */
@NullMarked
package lightning.scene.value;

import org.jspecify.annotations.NullMarked;
