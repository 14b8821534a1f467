/** Panel that matches lights to a reference image, or to strokes of a brush. */
@NullMarked
package lightning.editor.window.match;

import org.jspecify.annotations.NullMarked;
