/** Pane of the traced picture: pixels, badges, and mouse actions. */
package lightning.editor.window.traced;
