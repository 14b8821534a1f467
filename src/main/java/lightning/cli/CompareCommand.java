package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.PictureOutput;
import lightning.cli.report.CompareReport;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.image.ImageSource;
import lightning.format.jen.InputFiles;
import lightning.render.image.Difference;
import lightning.render.image.DifferenceImage;
import lightning.render.image.Film;
import lightning.render.image.Flip;
import lightning.render.image.ViewTransform;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Compares two images. */
@Command(name = "compare", abbreviateSynopsis = true, header = "Compare two images.",
        description = {
            "Compares two images of the same size, in any combination of .png, .jpg, .pfm, .exr and .hdr. Exit codes are those of diff: "
                    + "0 if the images are equal, 1 if they differ, 2 on error.",
            "",
            "Only .pfm and 32-bit .exr files store every bit of an image; equal .png files show only that images are displayed "
                    + "the same.",
            "",
            "FLIP is the perceived difference when flipping between the images, from 0 (none) to 1, at 67 pixels per degree."},
        footer = {
            "Examples:",
            "  lightning compare before.png after.png",
            "  lightning compare before.pfm after.pfm -o difference.png"})
final class CompareCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(index = "0", paramLabel = "a.png", description = "First image.")
    private Path first;
    @Parameters(index = "1", paramLabel = "b.png", description = "Image to compare with.")
    private Path second;
    @Option(names = {"-o", "--output"}, paramLabel = "FILE",
            description = "Write a difference image: black where all bits agree, brighter for larger differences.")
    private @Nullable Path output;

    CompareCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        if (output != null) {
            // Reject an unsupported extension before the images are read.
            ImageFormat.of(output);
            PictureOutput.checkFile(output, InputFiles.of(first, second));
        }
        Picture one = ImageFile.readPicture(first, Picture::of);
        Picture other = ImageFile.readPicture(second, Picture::of);
        Film a = one.film;
        Film b = other.film;
        if (a.width() != b.width() || a.height() != b.height()) {
            throw new BadInputException(Console.text("images to compare must have the same size: %s has %d x %d pixels, %s has %d x %d",
                    first, a.width(), a.height(), second, b.width(), b.height()));
        }
        Difference difference = Difference.of(a, b);
        if (output != null) {
            ImageFile.write(output, DifferenceImage.of(a, b), ViewTransform.DEFAULT);
        }
        double flip = Flip.mean(a, b);
        boolean floats = one.hasFullFloats && other.hasFullFloats;
        print(difference, 3L * a.width() * a.height(), flip, floats);
        console.report().setResult(report(a, difference, flip, floats));
        return difference.isNone() ? ExitCode.OK : ExitCode.CHECK_FAILED;
    }

    /** Picture, and whether its file stores all bits of a float. */
    private record Picture(Film film, boolean hasFullFloats) {
        static Picture of(ImageSource image) throws IOException {
            return new Picture(image.film(), image.hasFullFloats());
        }
    }

    private static CompareReport report(Film film, Difference d, double flip, boolean floats) {
        long pixels = (long) film.width() * film.height();
        return new CompareReport(d.isNone(), film.width(), film.height(), pixels, d.pixels(), 3 * pixels, d.values(), d.maxAbsolute(),
                floats ? Long.valueOf(d.maxUlp()) : null, d.maxLevels(), d.isNone() ? null : Integer.valueOf(d.x()),
                d.isNone() ? null : Integer.valueOf(d.y()), d.meanAbsolute(), d.rmse(), d.linearPsnr(), d.displayPsnr(), d.ssim(), flip);
    }

    /**
     * Prints the differences.
     *
     * @param floats true if units in the last place are meaningful; false for 8-bit levels, between which floats have many
     *     values
     */
    private void print(Difference d, long values, double flip, boolean floats) {
        if (d.isNone()) {
            console.print("equal: all %s are bit-identical", Console.count(values, "value"));
            return;
        }
        console.print("different: %d of %d pixels, %d of %d values", d.pixels(), values / 3, d.values(), values);
        console.print("largest difference  %.6g linear at pixel %d,%d; at most %s", d.maxAbsolute(), d.x(), d.y(),
                floats ? d.maxUlp() + " ulp" : d.maxLevels() + " of 255 levels");
        console.print("mean difference     %.6g linear", d.meanAbsolute());
        console.print("rmse                %.6g linear, PSNR %.2f dB", d.rmse(), d.linearPsnr());
        console.print(Double.isInfinite(d.displayPsnr()) ? "as displayed        equal"
                : "as displayed        PSNR %.2f dB, SSIM %.6f, FLIP %.6f", d.displayPsnr(), d.ssim(), flip);
    }
}
