package lightning.shot.movie;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The kinds of films that can be written. */
public enum MovieFormat {
    MP4(".mp4", "mp4", List.of("-c:v", "libx264", "-crf", "17", "-preset", "medium", "-movflags", "+faststart")),
    MOV(".mov", "mov", List.of("-c:v", "libx264", "-crf", "17", "-preset", "medium")),
    MKV(".mkv", "matroska", List.of("-c:v", "libx264", "-crf", "17", "-preset", "medium")),
    WEBM(".webm", "webm", List.of("-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0"));

    private final String extension;
    private final String muxer;
    private final List<String> encoderOptions;

    MovieFormat(String ending, String format, List<String> encoder) {
        this.extension = ending;
        this.muxer = format;
        this.encoderOptions = encoder;
    }

    /** What a file's name ends in, with its point. */
    public String ending() {
        return extension;
    }

    /** As ffmpeg calls it. */
    String format() {
        return muxer;
    }

    /** What ffmpeg is asked for. */
    List<String> encoder() {
        return encoderOptions;
    }

    /** The kind that a file's name asks for; empty where it is no film's. */
    public static Optional<MovieFormat> of(Path file) {
        String name = file.getFileName() == null ? "" : file.getFileName().toString().toLowerCase(Locale.ROOT);
        return Arrays.stream(values()).filter(kind -> name.endsWith(kind.extension)).findFirst();
    }
}
