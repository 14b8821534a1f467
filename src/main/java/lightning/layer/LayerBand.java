package lightning.layer;

import java.util.ArrayList;
import java.util.List;
import lightning.format.exr.ExrChunk;
import lightning.format.exr.ExrHeader;
import lightning.format.exr.ExrWriter;
import lightning.render.image.Film;
import org.jspecify.annotations.Nullable;

/** Chunks of all parts of a file for {@value #LINES} lines of an image, or for those that are left. */
final class LayerBand {
    /** Lines: those of a row of tiles, and a multiple of the lines of each part's chunks. */
    static final int LINES = Film.TILE_SIZE;

    private final int number;
    private final ImageCrop crop;
    private final int top;
    /** Chunks of each part; null for those that are compressed. */
    private final @Nullable ExrChunk[][] chunks;
    private final int[] chunkLines;

    /**
     * @param number number of the band, from the top of the crop
     * @param crop part of the image in the file
     */
    LayerBand(int number, LayerParts parts, ImageCrop crop) {
        this.number = number;
        this.crop = crop;
        top = crop.top() + number * LINES;
        List<ExrHeader> headers = parts.headers();
        chunks = new ExrChunk[headers.size()][];
        chunkLines = headers.stream().mapToInt(header -> header.compression().lines()).toArray();
        for (int p = 0; p < chunks.length; p++) {
            chunks[p] = new ExrChunk[Math.ceilDiv(area().height(), chunkLines[p])];
            for (int c = 0; c < chunks[p].length; c++) {
                chunks[p][c] = new ExrChunk(headers.get(p), firstChunk(p) + c);
            }
        }
    }

    /** Returns the number of bands of a file. */
    static int count(ImageCrop crop) {
        return Math.ceilDiv(crop.height(), LINES);
    }

    /** Returns the lines and columns of the image that it has. */
    ImageCrop area() {
        return new ImageCrop(crop.left(), top, crop.right(), Math.min(top + LINES, crop.bottom()));
    }

    private int firstChunk(int part) {
        return number * LINES / chunkLines[part];
    }

    /** Sets a value; {@code x} and {@code y} are those of the image. */
    void put(LayerParts.Slot slot, int x, int y, float value) {
        int line = y - top;
        int lines = chunkLines[slot.part()];
        ExrChunk chunk = chunks[slot.part()][line / lines];
        assert chunk != null;
        chunk.put(slot.channel(), x - crop.left(), line % lines, value);
    }

    /** Returns the compressed chunks, and drops the others. */
    List<ExrWriter.Chunk> compress() {
        List<ExrWriter.Chunk> result = new ArrayList<>();
        for (int p = 0; p < chunks.length; p++) {
            for (int c = 0; c < chunks[p].length; c++) {
                ExrChunk chunk = chunks[p][c];
                assert chunk != null;
                result.add(new ExrWriter.Chunk(p, firstChunk(p) + c, chunk.compress()));
                chunks[p][c] = null;
            }
        }
        return result;
    }
}
