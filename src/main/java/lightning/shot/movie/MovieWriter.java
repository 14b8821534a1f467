package lightning.shot.movie;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.base.work.OwnThread;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Picture;

/**
 * Hands pictures to ffmpeg one after the other. Sizes that are odd, which films cannot have, get one more column or row like their last.
 *
 * <pre>{@code
 * SafeFile.at(file).writeByName(temporary -> {
 *     try (var movie = new MovieWriter(ffmpeg, MovieKind.MP4, 24, view, temporary)) {
 *         movie.add(film);
 *         movie.finish();
 *     }
 * });
 * }</pre>
 */
public final class MovieWriter implements AutoCloseable {
    /** Of what ffmpeg complains of, bytes. */
    private static final int MOST_SAID = 4000;
    private static final int MOST_TOLD = 200;
    private static final long PATIENCE_SECONDS = 120;

    private final Ffmpeg ffmpeg;
    private final MovieKind kind;
    private final double rate;
    private final ViewTransform view;
    private final Path file;
    private Process process;
    private Thread listening;
    private volatile String said = "";
    private byte[] pixels = new byte[0];

    /**
     * Begins nothing yet.
     *
     * @param rate frames per second
     * @param view how linear light becomes display pixels
     */
    public MovieWriter(Ffmpeg ffmpeg, MovieKind kind, double rate, ViewTransform view, Path file) {
        this.ffmpeg = ffmpeg;
        this.kind = kind;
        this.rate = rate;
        this.view = view;
        this.file = file;
    }

    /** What a film takes beside its pictures, bytes. */
    public static long bytes(Picture picture) {
        // Packed pixels, and the three bytes of each that go to ffmpeg.
        return (4L + 3) * (picture.width() + 1) * (picture.height() + 1);
    }

    /**
     * Adds a picture, of the same size as all before.
     *
     * @throws IOException if ffmpeg cannot be started or gave up; the message has its own words
     */
    public void add(Film film) throws IOException {
        int width = film.width() + (film.width() & 1);
        int height = film.height() + (film.height() & 1);
        if (process == null) {
            begin(width, height);
        }
        pack(film, width, height);
        try {
            process.getOutputStream().write(pixels);
        } catch (IOException e) {
            throw new IOException(end(e.getMessage()), e);
        }
    }

    private void begin(int width, int height) throws IOException {
        pixels = new byte[Math.multiplyExact(3, Math.multiplyExact(width, height))];
        process = new ProcessBuilder(ffmpeg.command(kind, width, height, rate, file.toAbsolutePath()))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
        listening = OwnThread.of("lightning-ffmpeg", this::listen);
        listening.start();
    }

    /** Keeps the last of what it says; what nobody reads would hold it up. */
    private void listen() {
        try (InputStream errors = process.getErrorStream()) {
            byte[] some = new byte[MOST_SAID];
            for (int read = errors.read(some); read >= 0; read = errors.read(some)) {
                String more = said + new String(some, 0, read, Charset.defaultCharset());
                said = more.substring(Math.max(0, more.length() - MOST_SAID));
            }
        } catch (IOException e) {
            // It has ended.
        }
    }

    private void pack(Film film, int width, int height) {
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
     * Waits until the film is whole.
     *
     * @throws IOException if ffmpeg could not make it
     */
    public void finish() throws IOException {
        if (process == null) {
            throw new IOException(Texts.of("a film must have a frame"));
        }
        try (OutputStream in = process.getOutputStream()) {
            in.flush();
        } catch (IOException e) {
            throw new IOException(end(e.getMessage()), e);
        }
        String problem = end("");
        if (!problem.isEmpty()) {
            throw new IOException(problem);
        }
    }

    /** Waits for its end; returns why it was none, in a sentence. */
    private String end(String otherwise) {
        try {
            if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                return Texts.of("ffmpeg did not end");
            }
            listening.join(TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CancellationException();
        }
        if (process.exitValue() == 0 && otherwise.isEmpty()) {
            return "";
        }
        String last = said.strip().lines().reduce((_, line) -> line).orElse(otherwise);
        return Texts.of("ffmpeg could not make the film: {0}", Quote.path(last.substring(0, Math.min(MOST_TOLD, last.length()))));
    }

    /** Ends ffmpeg where it still runs: then what it wrote is no film. */
    @Override
    public void close() {
        if (process != null) {
            process.destroyForcibly();
            try {
                process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
