/**
 * What accuracy and effects cost, measured when the artist asks.
 */
package lightning.editor.window.measure;
