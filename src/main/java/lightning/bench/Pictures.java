package lightning.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.format.picture.PictureFile;
import lightning.render.image.DifferencePicture;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** Writes the pictures of a run, small enough for a page. */
final class Pictures {
    /** The widest picture, pixels. */
    static final int WIDEST = 480;
    private static final String FOLDER = "pictures";

    private final Path results;

    /** @param results the folder of the results */
    Pictures(Path results) {
        this.results = results;
    }

    /** Writes a picture as it is displayed; returns its name, relative to the results. */
    String picture(String name, Film film) throws IOException {
        return write(name, Shrink.average(film, WIDEST));
    }

    /** Writes where two pictures differ; returns its name, relative to the results, or null where they do not differ. */
    String difference(String name, Film film, Film reference) throws IOException {
        return film.sameBits(reference) ? null : write(name, Shrink.brightest(DifferencePicture.of(film, reference), WIDEST));
    }

    private String write(String name, Film film) throws IOException {
        Files.createDirectories(results.resolve(FOLDER));
        String file = FOLDER + "/" + name + ".png";
        PictureFile.write(results.resolve(file), film, ViewTransform.DEFAULT);
        return file;
    }
}
