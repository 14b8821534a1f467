/** Interactive preview, in which lights are moved with the mouse. */
package lightning.editor.window.preview;
