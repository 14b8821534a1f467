/** The tree of shapes and groups: geometry without materials. */
@NullMarked
package lightning.scene.node;

import org.jspecify.annotations.NullMarked;
