/**
 * The timeline: the keys of a shot over its frames, and the frame that is shown.
 */
package lightning.editor.window.timeline;
