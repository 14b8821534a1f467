/** Interactive preview, in which lights are moved with the mouse. */
@NullMarked
package lightning.editor.window.preview;

import org.jspecify.annotations.NullMarked;
