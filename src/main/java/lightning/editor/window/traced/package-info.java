/**
 * The traced picture: its pixels, what it does not show yet, and what the mouse does over it.
 */
package lightning.editor.window.traced;
