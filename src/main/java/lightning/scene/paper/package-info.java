/** The edits of the paper, and more of materials and shapes, for any scene. */
@NullMarked
package lightning.scene.paper;

import org.jspecify.annotations.NullMarked;
