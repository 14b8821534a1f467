package lightning.shot.movie;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.file.SearchPath;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Messages;

/**
 * Installed ffmpeg program, which encodes videos.
 *
 * @param program the executable
 */
public record Ffmpeg(Path program) {

    /** Finds the first one in the system's search path. */
    public static Optional<Ffmpeg> find() {
        return findIn(SearchPath.ofSystem());
    }

    static Optional<Ffmpeg> findIn(SearchPath path) {
        return path.find("ffmpeg").map(Ffmpeg::new);
    }

    /**
     * Returns the installed program.
     *
     * @throws IOException if it is missing; the message says what it is for
     */
    public static Ffmpeg require() throws IOException {
        return find().orElseThrow(() -> new IOException(missingMessage()));
    }

    /** Returns the message for a missing program: a clause without a full stop. */
    public static String missingMessage() {
        return Messages.tr("video export needs ffmpeg, which is not installed; numbered images do not need it");
    }

    /**
     * Returns the command that encodes a video from raw frames on standard input: red, green and blue, 8 bits each.
     *
     * @param width  pixels, even
     * @param height pixels, even
     * @param rate   frames per second
     */
    List<String> command(MovieFormat kind, int width, int height, double rate, Path output) {
        List<String> command = new ArrayList<>(List.of(program.toString(), "-hide_banner", "-loglevel", "error", "-nostdin", "-y",
                "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", width + "x" + height, "-framerate", DecimalNumber.format(rate),
                "-i",
                "pipe:0", "-an", "-vf", "scale=out_color_matrix=bt709:out_range=tv", "-pix_fmt", "yuv420p", "-colorspace", "bt709",
                "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"));
        command.addAll(kind.encoder());
        command.addAll(List.of("-f", kind.format(), "file:" + output));
        return command;
    }
}
