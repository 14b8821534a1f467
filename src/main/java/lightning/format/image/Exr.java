package lightning.format.image;

import java.io.IOException;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrChunk;
import lightning.format.exr.ExrColorReader;
import lightning.format.exr.ExrHeader;
import lightning.format.exr.ExrReader;
import lightning.format.exr.ExrType;
import lightning.format.exr.ExrWriter;
import lightning.render.image.Film;

/** OpenEXR format: the linear film as channels R, G and B. */
final class Exr {
    private static final List<String> COLORS = List.of("R", "G", "B");

    private Exr() {}

    static void write(SeekableByteChannel file, Film film, ExrType type, Map<String, ExrAttribute> attributes) throws IOException {
        List<ExrChannel> channels = COLORS.stream().map(name -> new ExrChannel(name, type)).toList();
        ExrHeader header = new ExrHeader(film.width(), film.height(), channels, attributes);
        int[] channelIndices = COLORS.stream().mapToInt(name -> header.channels().indexOf(new ExrChannel(name, type))).toArray();
        ExrWriter writer = new ExrWriter(file, header);
        for (int c = 0; c < header.chunkCount(); c++) {
            ExrChunk chunk = new ExrChunk(header, c);
            for (int y = 0; y < header.lineCount(c); y++) {
                int line = c * ExrHeader.LINES_PER_CHUNK + y;
                for (int x = 0; x < film.width(); x++) {
                    chunk.put(channelIndices[0], x, y, film.red(x, line));
                    chunk.put(channelIndices[1], x, y, film.green(x, line));
                    chunk.put(channelIndices[2], x, y, film.blue(x, line));
                }
            }
            writer.writeChunk(c, chunk.compress());
        }
        writer.finish();
    }

    /**
     * Reads channels R, G and B, converted to the working space.
     *
     * @throws IOException if a channel is missing, or the file is unsupported, damaged or too large; the message does not
     *     contain its name
     */
    static Film read(Path file) throws IOException {
        try (ExrReader reader = new ExrReader(file)) {
            ImageLimits.check(reader.header().width(), reader.header().height());
            Film film = Film.black(reader.header().width(), reader.header().height());
            ExrColorReader.read(reader, (x, y, rgb) -> {
                int tile = film.tileOf(x, y);
                int pixel = Film.pixelInTile(x, y);
                film.red(tile)[pixel] = rgb[0];
                film.green(tile)[pixel] = rgb[1];
                film.blue(tile)[pixel] = rgb[2];
            });
            return film;
        }
    }

    /** Returns whether the color channels have more bits than a half. */
    static boolean hasFullFloats(Path file) throws IOException {
        try (ExrReader reader = new ExrReader(file)) {
            return reader.header().channels().stream().anyMatch(c -> COLORS.contains(c.name()) && c.type() != ExrType.HALF);
        }
    }
}
