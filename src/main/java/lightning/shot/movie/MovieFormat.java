package lightning.shot.movie;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Video formats for export. */
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

    /** Returns the file extension, with its point. */
    public String ending() {
        return extension;
    }

    /** Returns ffmpeg's name of the container. */
    String format() {
        return muxer;
    }

    /** Returns ffmpeg's encoder options. */
    List<String> encoder() {
        return encoderOptions;
    }

    /** Returns the format of a file name; empty if it is not a video's. */
    public static Optional<MovieFormat> of(Path file) {
        String name = file.getFileName() == null ? "" : file.getFileName().toString().toLowerCase(Locale.ROOT);
        return Arrays.stream(values()).filter(kind -> name.endsWith(kind.extension)).findFirst();
    }
}
