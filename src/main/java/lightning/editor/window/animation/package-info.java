/** Animation of one light: recording, playback, scrubbing and export. */
@NullMarked
package lightning.editor.window.animation;

import org.jspecify.annotations.NullMarked;
