/** Looks, which are saved looks of a scene with images, and light rigs as files. */
@NullMarked
package lightning.document.look;

import org.jspecify.annotations.NullMarked;
