/** Recorded movement of one light: keyframes and file format (paper §3.7). */
@NullMarked
package lightning.document.motion;

import org.jspecify.annotations.NullMarked;
