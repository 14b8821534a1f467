/**
 * The drawn preview, in which lights are taken by hand.
 */
package lightning.editor.window.preview;
