/** Recorded movement of one light: keyframes, file format and image export (paper §3.7). */
@NullMarked
package lightning.editor.document.motion;

import org.jspecify.annotations.NullMarked;
