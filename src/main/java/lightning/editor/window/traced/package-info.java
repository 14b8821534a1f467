/** Pane of the traced picture: pixels, badges, and mouse actions. */
@NullMarked
package lightning.editor.window.traced;

import org.jspecify.annotations.NullMarked;
