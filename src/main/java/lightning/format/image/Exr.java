package lightning.format.image;

import java.io.IOException;
import java.nio.channels.SeekableByteChannel;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrChunk;
import lightning.format.exr.ExrHeader;
import lightning.format.exr.ExrPrimaries;
import lightning.format.exr.ExrType;
import lightning.format.exr.ExrWriter;
import lightning.render.image.Film;

/** OpenEXR format: the linear film as channels R, G and B. */
final class Exr {
    static final List<String> COLORS = List.of("R", "G", "B");

    private Exr() {}

    /**
     * Writes a film.
     *
     * @param primaries color space of the file; Rec. 709 adds no attributes
     */
    static void write(SeekableByteChannel file, Film film, ExrType type, Map<String, ExrAttribute> given, ExrPrimaries primaries)
            throws IOException {
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>(given);
        if (primaries != ExrPrimaries.REC_709) {
            attributes.putAll(primaries.attributes());
        }
        List<ExrChannel> channels = COLORS.stream().map(name -> new ExrChannel(name, type)).toList();
        ExrHeader header = new ExrHeader(film.width(), film.height(), channels, attributes);
        int[] channelIndices = COLORS.stream().mapToInt(name -> header.channels().indexOf(new ExrChannel(name, type))).toArray();
        ExrWriter writer = new ExrWriter(file, header);
        float[][] pixels = new float[3][film.width()];
        for (int c = 0; c < header.chunkCount(); c++) {
            ExrChunk chunk = new ExrChunk(header, c);
            for (int y = 0; y < header.lineCount(c); y++) {
                int line = c * ExrHeader.LINES_PER_CHUNK + y;
                for (int x = 0; x < film.width(); x++) {
                    pixels[0][x] = film.red(x, line);
                    pixels[1][x] = film.green(x, line);
                    pixels[2][x] = film.blue(x, line);
                }
                float[][] converted = primaries.convert(pixels);
                for (int x = 0; x < film.width(); x++) {
                    for (int color = 0; color < 3; color++) {
                        chunk.put(channelIndices[color], x, y, converted[color][x]);
                    }
                }
            }
            writer.writeChunk(c, chunk.compress());
        }
        writer.finish();
    }
}
