/**
 * Execution of plans: tile by tile on all threads, each with its own {@link lightning.render.relight.tile.TileWorker}. New tiles
 * are built from old ones; no tile is modified.
 */
@NullMarked
package lightning.render.relight.tile;

import org.jspecify.annotations.NullMarked;
