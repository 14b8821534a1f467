package lightning.format.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import lightning.format.exr.ExrColorReader;
import lightning.format.exr.ExrReader;
import lightning.format.exr.ExrType;
import lightning.scene.asset.TextureUsage;

/** OpenEXR image: its colors in the working space, or its numbers or alpha as they are. */
final class ExrImage extends ImageSource {
    private static final String ALPHA = "A";

    private final ExrReader reader;

    /** Reads the header of a file. */
    ExrImage(Path file) throws IOException {
        reader = new ExrReader(file);
    }

    @Override
    public int width() {
        return reader.header().width();
    }

    @Override
    public int height() {
        return reader.header().height();
    }

    @Override
    public boolean hasAlpha() {
        return reader.header().channels().stream().anyMatch(channel -> channel.name().equals(ALPHA));
    }

    /** Returns whether the color channels have more bits than a half. */
    @Override
    public boolean hasFullFloats() {
        return reader.header().channels().stream()
                .anyMatch(channel -> Exr.COLORS.contains(channel.name()) && channel.type() != ExrType.HALF);
    }

    @Override
    Pixels pixels(TextureUsage usage) {
        return switch (usage) {
            case COLOR, EMISSION -> sink -> ExrColorReader.read(reader, sink::accept);
            case DATA -> sink -> reader.read(ExrColorReader.channels(reader.header()), sink::accept);
            case OPACITY -> sink -> reader.read(hasAlpha() ? List.of(ALPHA, ALPHA, ALPHA) : ExrColorReader.channels(reader.header()),
                    sink::accept);
        };
    }

    @Override
    public void close() throws IOException {
        reader.close();
    }
}
