/**
 * How a plan is carried out: tile by tile, on all threads, each with a {@link lightning.render.relight.tile.TileWorker} of its own.
 * New tiles are made of old ones; no tile is ever written twice.
 */
package lightning.render.relight.tile;
