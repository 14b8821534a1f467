/**
 * The light mixer: a board with a strip for each light and bank of the scene.
 */
package lightning.editor.window.mixer;
