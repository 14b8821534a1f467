package lightning.layer;

import lightning.render.image.Film;
import lightning.render.trace.SamplePositions;

/**
 * Receiver for the values of a tile.
 *
 * @param area    part of the image that it receives
 * @param centers positions of the tile's pixels
 * @param indices index in {@code values} of each of a source's channels
 * @param values  receives them
 */
record TileSink(ImageCrop area, SamplePositions centers, int[] indices, Values values) {
    // Arrays in a record: shared with their creator.

    /** Receiver for the values of a row of tiles. */
    @FunctionalInterface
    interface Values {
        /** Sets a value; {@code x} and {@code y} are those of the image. */
        void put(int channel, int x, int y, float value);
    }

    /** Visitor of pixels. */
    @FunctionalInterface
    interface PixelVisitor {
        /** @param pixel index in the tile */
        void visit(int x, int y, int pixel);
    }

    /** Visits the tile's pixels inside the area. */
    void forEachPixel(PixelVisitor visitor) {
        int right = Math.min(centers.x0() + Film.TILE_SIZE, area.right());
        int bottom = Math.min(centers.y0() + Film.TILE_SIZE, area.bottom());
        for (int y = Math.max(centers.y0(), area.top()); y < bottom; y++) {
            for (int x = Math.max(centers.x0(), area.left()); x < right; x++) {
                visitor.visit(x, y, Film.pixelInTile(x, y));
            }
        }
    }

    /** Sets a value. */
    void put(int channel, int x, int y, float value) {
        values.put(indices[channel], x, y, value);
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
