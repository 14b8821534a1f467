/** Saved looks of a scene with their pictures, and light rigs as files. */
@NullMarked
package lightning.document.look;

import org.jspecify.annotations.NullMarked;
