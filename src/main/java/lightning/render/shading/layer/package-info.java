/** Layer of one light: its contribution to each row of a tile, and updates of it. */
package lightning.render.shading.layer;
