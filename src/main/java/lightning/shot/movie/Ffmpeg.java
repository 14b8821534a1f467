package lightning.shot.movie;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Messages;

/**
 * The program that makes a film of pictures, where it is installed.
 *
 * @param program the file
 */
public record Ffmpeg(Path program) {

    /** The first of that name in the folders where the system looks for programs. */
    public static Optional<Ffmpeg> find() {
        return findIn(System.getenv("PATH"));
    }

    /** @param folders as the system's variable {@code PATH} names them; null for none */
    static Optional<Ffmpeg> findIn(String folders) {
        if (folders == null) {
            return Optional.empty();
        }
        for (String folder : folders.split(File.pathSeparator)) {
            for (String name : List.of("ffmpeg", "ffmpeg.exe")) {
                try {
                    Path program = Path.of(folder, name);
                    if (!folder.isEmpty() && Files.isRegularFile(program) && Files.isExecutable(program)) {
                        return Optional.of(new Ffmpeg(program));
                    }
                } catch (InvalidPathException e) {
                    // The system passes over what it cannot read, too.
                }
            }
        }
        return Optional.empty();
    }

    /**
     * The installed one.
     *
     * @throws IOException if there is none; the message says what it is for
     */
    public static Ffmpeg require() throws IOException {
        return find().orElseThrow(() -> new IOException(missingMessage()));
    }

    /** What is told where there is none: a clause without a full stop. */
    public static String missingMessage() {
        return Messages.tr("video export needs ffmpeg, which is not installed; numbered images do not need it");
    }

    /**
     * What it is called with to make a film of pixels that it reads one picture after the other, red, green and blue, 8 bits each.
     *
     * @param width pixels, even; likewise {@code height}
     * @param rate  frames per second
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
