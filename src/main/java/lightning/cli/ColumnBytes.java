package lightning.cli;

import lightning.cache.CachedTile;
import lightning.cache.PixelCache;
import lightning.cache.TileLevel;
import lightning.shading.LightLayer;
import lightning.shading.LightRows;
import lightning.trace.HitRows;

/**
 * The bytes of a cache by kind of column, the film and array headers left out.
 *
 * @param rows      hit rows of all levels
 * @param layerRows rows of all layers: a row counts once for each light
 * @param geometry  point, normal, view direction and place in the picture
 * @param textures  diffuse colours of textured rows
 * @param mirrored  colours of mirror images, and the shapes that mirrored rays hit
 * @param states    state of each row and light
 * @param cosines   likewise the cosine
 * @param speculars likewise the specular term
 * @param falloffs  likewise attenuation times spot coefficient
 * @param all       everything, as the cache itself counts
 */
record ColumnBytes(long rows, long layerRows, long geometry, long textures, long mirrored, long states, long cosines,
        long speculars, long falloffs, long all) {
    /** The bytes of a term of a light's layer, for each row. */
    static final long TERM = Float.BYTES;
    /** The bytes of a colour, for each row. */
    static final long COLOR = 3L * Float.BYTES;

    static ColumnBytes of(PixelCache cache) {
        long layerRows = 0;
        long textures = 0;
        long geometry = 0;
        long states = 0;
        long cosines = 0;
        long speculars = 0;
        long falloffs = 0;
        long levels = 0;
        for (CachedTile tile : cache.all()) {
            for (TileLevel level : tile.levels) {
                HitRows rows = level.rows();
                long texture = rows.bytes(HitRows.Part.TEXEL);
                textures += texture;
                geometry += rows.bytes() - texture;
                levels += level.bytes();
                for (LightLayer layer : level.layers()) {
                    if (layer instanceof LightRows l) {
                        layerRows += rows.count;
                        states += l.bytes(LightRows.Column.STATE);
                        cosines += l.bytes(LightRows.Column.COSINE);
                        speculars += l.bytes(LightRows.Column.SPECULAR);
                        falloffs += l.bytes(LightRows.Column.FALLOFF);
                    }
                }
            }
        }
        return new ColumnBytes(cache.rowCount(), layerRows, geometry, textures, cache.bytes() - levels, states, cosines, speculars,
                falloffs, cache.bytes());
    }
}
