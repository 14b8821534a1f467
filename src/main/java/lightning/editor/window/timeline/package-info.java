/** Timeline: the keyframes of a shot, the current frame, and the film strip. */
@NullMarked
package lightning.editor.window.timeline;

import org.jspecify.annotations.NullMarked;
