/**
 * Which lights matter to the picture, to a part of it, and to a pixel.
 */
package lightning.editor.window.contribution;
