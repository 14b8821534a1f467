/** Contribution of each light to the picture, to a region and to a pixel. */
package lightning.editor.window.contribution;
