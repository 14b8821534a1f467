/** What the light of one pixel consists of. */
package lightning.render.shading.explanation;
