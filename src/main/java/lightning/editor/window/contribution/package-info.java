/** Contribution of each light to the picture, to a region and to a pixel. */
@NullMarked
package lightning.editor.window.contribution;

import org.jspecify.annotations.NullMarked;
