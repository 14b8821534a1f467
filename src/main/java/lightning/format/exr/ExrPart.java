package lightning.format.exr;

import org.jspecify.annotations.Nullable;

/**
 * A part of a file: a picture with a size, channels and a compression of its own. Most files have one.
 *
 * @param header size and window of the data, channels, attributes and compression
 * @param top first line in the file's coordinates
 * @param tileSize width and height of tiles; null for scan lines
 * @param number number with which each of its chunks begins, from 0; −1 in a file of one part, whose chunks have none
 * @param tableOffset place of the table of its chunks, bytes
 */
record ExrPart(ExrHeader header, int top, int @Nullable [] tileSize, int number,
        long tableOffset) {
    /** Returns the header with the size of the picture. */
    ExrHeader shown() {
        ExrWindow window = header.window();
        return new ExrHeader(window.width(), window.height(), header.channels(), header.attributes(), header.compression(),
                new ExrWindow(0, 0, window.width(), window.height()));
    }

    /** Returns the bytes at the start of a chunk: the number of its part, its place, and its size. */
    int chunkHeaderBytes() {
        return (tileSize == null ? 2 : 5) * Integer.BYTES + (number < 0 ? 0 : Integer.BYTES);
    }
}
