/** Sums of weighted layers, ambient light and bounces, and the edges that need finer samples. */
package lightning.render.shading.composition;
