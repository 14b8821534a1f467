package lightning.editor.window.timeline;

import java.nio.file.Path;
import java.util.Optional;
import lightning.base.text.Messages;
import lightning.format.image.ImageFormat;
import lightning.shot.movie.MovieFormat;

/** Export format of a shot. */
enum ShotFormat {
    PNG(Messages.key("Numbered PNG, 8 bits"), ImageFormat.PNG.extension(), 8),
    PNG_16_BIT(Messages.key("Numbered PNG, 16 bits"), ImageFormat.PNG.extension(), 16),
    EXR(Messages.key("Numbered OpenEXR, 32 bits"), ImageFormat.EXR.extension(), 32),
    MP4(Messages.key("Video, MP4"), MovieFormat.MP4.ending(), 8),
    MOV(Messages.key("Video, MOV"), MovieFormat.MOV.ending(), 8),
    WEBM(Messages.key("Video, WebM"), MovieFormat.WEBM.ending(), 8);

    private final String title;
    private final String extension;
    private final int bits;

    ShotFormat(String title, String extension, int bits) {
        this.title = title;
        this.extension = extension;
        this.bits = bits;
    }

    /** Returns the file extension, with its dot. */
    String extension() {
        return extension;
    }

    /** Returns the bit depth of a color channel. */
    int bits() {
        return bits;
    }

    /** Returns the video format; empty for numbered images. */
    Optional<MovieFormat> movie() {
        return MovieFormat.of(Path.of(extension));
    }

    @Override
    public String toString() {
        return Messages.tr(title);
    }
}
