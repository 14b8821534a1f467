package lightning.shot.movie;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.work.DedicatedThread;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.PictureSettings;
import org.jspecify.annotations.Nullable;

/**
 * Writer of a video through ffmpeg, frame by frame. Pads odd sizes, which videos cannot have, by repeating the last column or row.
 *
 * <pre>{@code
 * AtomicFile.of(file).writeToPath(temporary -> {
 *     try (var movie = new MovieWriter(ffmpeg, MovieFormat.MP4, 24, view, temporary)) {
 *         movie.add(film);
 *         movie.finish();
 *     }
 * });
 * }</pre>
 */
public final class MovieWriter implements AutoCloseable {
    /** Maximum bytes of ffmpeg's error output. */
    private static final int MAX_ERROR_CHARS = 4000;
    private static final int MAX_REPORTED_CHARS = 200;
    private static final long TIMEOUT_SECONDS = 120;

    private final Ffmpeg ffmpeg;
    private final MovieFormat format;
    private final double rate;
    private final ViewTransform view;
    private final Path file;
    private @Nullable Process process;
    private @Nullable Thread errorReader;
    private volatile String errorText = "";
    private byte[] pixels = new byte[0];

    /**
     * Creates a writer; ffmpeg starts with the first frame.
     *
     * @param rate frames per second
     * @param view conversion of linear light to display pixels
     */
    public MovieWriter(Ffmpeg ffmpeg, MovieFormat format, double rate, ViewTransform view, Path file) {
        this.ffmpeg = ffmpeg;
        this.format = format;
        this.rate = rate;
        this.view = view;
        this.file = file;
    }

    /** Returns the bytes needed in addition to the images. */
    public static long requiredBytes(PictureSettings picture) {
        // Packed pixels, and the three bytes of each for ffmpeg.
        return (4L + 3) * (picture.width() + 1) * (picture.height() + 1);
    }

    /**
     * Adds a frame of the same size as all before.
     *
     * @throws IOException if ffmpeg cannot be started or failed; the message includes its own
     */
    public void add(Film film) throws IOException {
        int width = film.width() + (film.width() & 1);
        int height = film.height() + (film.height() & 1);
        Process running = process == null ? start(width, height) : process;
        packPixels(film, width, height);
        try {
            running.getOutputStream().write(pixels);
        } catch (IOException e) {
            throw new IOException(awaitExit(running, String.valueOf(e.getMessage())), e);
        }
    }

    private Process start(int width, int height) throws IOException {
        pixels = new byte[Math.multiplyExact(3, Math.multiplyExact(width, height))];
        Process started = new ProcessBuilder(ffmpeg.command(format, width, height, rate, file.toAbsolutePath()))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
        process = started;
        errorReader = DedicatedThread.create("lightning-ffmpeg", () -> readErrors(started));
        errorReader.start();
        return started;
    }

    /** Reads ffmpeg's error output and keeps its end; unread output would block it. */
    private void readErrors(Process started) {
        try (InputStream errors = started.getErrorStream()) {
            byte[] buffer = new byte[MAX_ERROR_CHARS];
            for (int read = errors.read(buffer); read >= 0; read = errors.read(buffer)) {
                String more = errorText + new String(buffer, 0, read, Charset.defaultCharset());
                errorText = more.substring(Math.max(0, more.length() - MAX_ERROR_CHARS));
            }
        } catch (IOException e) {
            // It has ended.
        }
    }

    private void packPixels(Film film, int width, int height) {
        int[] packed = view.toPixels(film);
        for (int y = 0, at = 0; y < height; y++) {
            int row = Math.min(y, film.height() - 1) * film.width();
            for (int x = 0; x < width; x++) {
                int pixel = packed[row + Math.min(x, film.width() - 1)];
                pixels[at++] = (byte) (pixel >> 16);
                pixels[at++] = (byte) (pixel >> 8);
                pixels[at++] = (byte) pixel;
            }
        }
    }

    /**
     * Finishes the video and waits for ffmpeg.
     *
     * @throws IOException if ffmpeg failed
     */
    public void finish() throws IOException {
        if (process == null) {
            throw new IOException(Messages.tr("a video needs at least one frame"));
        }
        try (OutputStream in = process.getOutputStream()) {
            in.flush();
        } catch (IOException e) {
            throw new IOException(awaitExit(process, String.valueOf(e.getMessage())), e);
        }
        String problem = awaitExit(process, "");
        if (!problem.isEmpty()) {
            throw new IOException(problem);
        }
    }

    /** Waits for ffmpeg; returns a sentence that says why it failed. */
    private String awaitExit(Process running, String fallback) {
        try {
            if (!running.waitFor(TIMEOUT_SECONDS, TimeUnit.SECONDS)) {
                return Messages.tr("ffmpeg did not finish");
            }
            requireNonNull(errorReader).join(TimeUnit.SECONDS.toMillis(TIMEOUT_SECONDS));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CancellationException();
        }
        if (running.exitValue() == 0 && fallback.isEmpty()) {
            return "";
        }
        String last = errorText.strip().lines().reduce((_, line) -> line).orElse(fallback);
        return Messages.tr("ffmpeg failed: {0}",
                Quote.path(last.substring(0, Math.min(MAX_REPORTED_CHARS, last.length()))));
    }

    /** Ends ffmpeg if it still runs; the video is then incomplete. */
    @Override
    public void close() {
        if (process != null) {
            process.destroyForcibly();
            try {
                process.waitFor(TIMEOUT_SECONDS, TimeUnit.SECONDS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
