package lightning.format.layer;

import lightning.format.exr.ExrChunk;
import lightning.format.exr.ExrHeader;
import lightning.render.image.Film;
import lightning.render.trace.SamplePositions;

/**
 * Receiver for the values of a tile in a file.
 *
 * @param centers positions of the tile's pixels
 * @param indices index in the file of each of a source's channels
 * @param chunks the chunks of the tile's row of tiles
 */
record TileSink(ExrHeader header, SamplePositions centers, int[] indices, ExrChunk[] chunks) {
    // Arrays in a record: shared with their creator.

    /** Visitor of pixels. */
    @FunctionalInterface
    interface PixelVisitor {
        /** @param pixel index in the tile */
        void visit(int x, int y, int pixel);
    }

    /** Visits the tile's pixels inside the image. */
    void forEachPixel(PixelVisitor visitor) {
        int right = Math.min(centers.x0() + Film.TILE_SIZE, header.width());
        int bottom = Math.min(centers.y0() + Film.TILE_SIZE, header.height());
        for (int y = centers.y0(); y < bottom; y++) {
            for (int x = centers.x0(); x < right; x++) {
                visitor.visit(x, y, Film.pixelInTile(x, y));
            }
        }
    }

    /** Sets a value. */
    void put(int channel, int x, int y, float value) {
        chunks[y % Film.TILE_SIZE / ExrHeader.LINES_PER_CHUNK].put(indices[channel], x, y % ExrHeader.LINES_PER_CHUNK, value);
    }

    /** Sets the values of a color's three channels, the first of which is {@code firstChannel}. */
    void putColors(int firstChannel, float[][] values) {
        forEachPixel((x, y, pixel) -> {
            for (int c = 0; c < 3; c++) {
                put(firstChannel + c, x, y, values[c][pixel]);
            }
        });
    }
}
