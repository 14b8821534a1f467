package lightning.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.format.image.ImageFile;
import lightning.render.image.DifferenceImage;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import org.jspecify.annotations.Nullable;

/**
 * Writer of a run's images, downscaled for a web page.
 *
 * @param resultsFolder folder of the results
 */
record PictureWriter(Path resultsFolder) {
    /** Maximum width of an image, in pixels. */
    static final int MAX_WIDTH = 480;
    private static final String FOLDER = "pictures";

    /** Writes an image as displayed; returns its name, relative to the results. */
    String writePicture(String name, Film film) throws IOException {
        return write(name, FilmDownscaler.average(film, MAX_WIDTH));
    }

    /** Writes the difference of two images; returns its name, relative to the results, or null if they are equal. */
    @Nullable
    String writeDifference(String name, Film film, Film reference) throws IOException {
        return film.hasSameBits(reference) ? null : write(name, FilmDownscaler.maximum(DifferenceImage.of(film, reference), MAX_WIDTH));
    }

    private String write(String name, Film film) throws IOException {
        Files.createDirectories(resultsFolder.resolve(FOLDER));
        String file = FOLDER + "/" + name + ".png";
        ImageFile.write(resultsFolder.resolve(file), film, ViewTransform.DEFAULT);
        return file;
    }
}
