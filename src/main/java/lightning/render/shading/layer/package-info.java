/** A light's layer: what it contributes to each row of a tile, and its updates. */
package lightning.render.shading.layer;
