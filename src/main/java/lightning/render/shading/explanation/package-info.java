/** Explanation of a pixel: the contributions of all lights. */
package lightning.render.shading.explanation;
