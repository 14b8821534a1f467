/** Timeline: the keyframes of a shot, the current frame, and the film strip. */
package lightning.editor.window.timeline;
