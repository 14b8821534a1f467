package lightning.cli.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.format.jen.InputFiles;
import lightning.shot.movie.FrameFiles;

/**
 * File names for the image after each group of edits, numbered from 1.
 *
 * @param pattern name of one file, or one with {@code %d} or {@code %04d} for the number; a name without an extension is a folder
 * @param stem start of file names in such a folder
 */
public record StepFiles(Path pattern, String stem) {
    private static final Pattern NUMBER = Pattern.compile("%(?:0([1-9]))?d");

    private String name() {
        return pattern.getFileName() == null ? "" : pattern.getFileName().toString();
    }

    private boolean isFolder() {
        return Files.isDirectory(pattern) || name().lastIndexOf('.') <= 0;
    }

    /** Returns whether each step has a file, false if the last one has. */
    boolean isNumbered() {
        return isFolder() || NUMBER.matcher(name()).find();
    }

    /** Returns the file of a step. */
    public Path file(int step) {
        if (isFolder()) {
            return new FrameFiles(pattern, stem, ".png").file(step);
        }
        String file = NUMBER.matcher(name()).replaceAll(match -> Matcher.quoteReplacement(
                String.format(Locale.ROOT, "%0" + (match.group(1) == null ? "1" : match.group(1)) + "d", step)));
        return pattern.resolveSibling(file);
    }

    /** Returns the file that is written after a step; empty if there is none. */
    public Optional<Path> written(int step, int last) {
        return isNumbered() || step == last ? Optional.of(file(step)) : Optional.empty();
    }

    /** Checks that the files of all steps can be written, and are not read, before a long computation. Creates the folder. */
    public void check(int last, InputFiles inputs) throws IOException {
        if (isFolder()) {
            new FrameFiles(pattern, stem, ".png").createFolder();
        }
        for (int step = 1; step <= last; step++) {
            Optional<Path> file = written(step, last);
            if (file.isPresent()) {
                PictureOutput.checkFile(file.get(), inputs);
            }
        }
    }
}
