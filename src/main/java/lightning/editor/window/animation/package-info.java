/** Animation of one light: recording, playback, scrubbing and export. */
package lightning.editor.window.animation;
