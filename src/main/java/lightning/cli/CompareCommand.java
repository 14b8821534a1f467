package lightning.cli;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import lightning.format.hdr.HdrReader;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.render.image.Difference;
import lightning.render.image.DifferenceImage;
import lightning.render.image.Film;
import lightning.render.image.Flip;
import lightning.render.image.ViewTransform;
import lightning.scene.EnvironmentMap;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Tells how much two pictures differ. */
@Command(name = "compare", abbreviateSynopsis = true, header = "Tell how much two pictures differ.",
        description = {
            "Compares two pictures of the same size, of the formats .png, .pfm, .exr and .hdr in any combination. The exit code is",
            "that of diff: 0 for equal pictures, 1 for different ones, 2 for trouble.",
            "Only .pfm and an .exr of 32 bits hold all bits of a picture: a .png can tell equal displays, not equal pictures.",
            "FLIP is how much of a difference a person sees who flips between the two: 0 none, 1 the worst; 67 pixels per degree."},
        footer = {
            "Examples:",
            "  lightning compare before.png after.png",
            "  lightning compare before.pfm after.pfm -o difference.png"})
final class CompareCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(index = "0", paramLabel = "a.png", description = "One picture.")
    private Path first;
    @Parameters(index = "1", paramLabel = "b.png", description = "The other.")
    private Path second;
    @Option(names = {"-o", "--output"}, paramLabel = "FILE",
            description = "Writes where they differ: black where all bits agree, brighter the larger the difference.")
    private Path output;

    CompareCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        if (output != null) {
            // Refuses another ending before the pictures are read.
            ImageFormat.of(output);
            PictureOutput.checkFile(output);
        }
        Film a = read(first);
        Film b = read(second);
        if (a.width() != b.width() || a.height() != b.height()) {
            throw new BadInputException(Console.text("pictures to compare must have the same size, %s has %d x %d pixels, %s has %d x %d",
                    first, a.width(), a.height(), second, b.width(), b.height()));
        }
        Difference difference = Difference.of(a, b);
        if (output != null) {
            ImageFile.write(output, DifferenceImage.of(a, b), ViewTransform.DEFAULT);
        }
        print(difference, 3L * a.width() * a.height(), Flip.mean(a, b),
                ImageFormat.of(first).hasFullFloats(first) && ImageFormat.of(second).hasFullFloats(second));
        return difference.isNone() ? ExitCode.OK : ExitCode.CHECK_FAILED;
    }

    private static Film read(Path file) throws Exception {
        if (ImageFormat.of(file) != ImageFormat.HDR) {
            return ImageFile.read(file);
        }
        EnvironmentMap picture = HdrReader.read(file);
        float[] rgb = new float[3 * picture.width() * picture.height()];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = picture.channel(i / 3 % picture.width(), i / 3 / picture.width(), i % 3);
        }
        return Film.ofScanlines(picture.width(), picture.height(), rgb);
    }

    /** @param floats whether units in the last place mean something: the numbers between two 8-bit levels are none that a file could hold */
    private void print(Difference d, long values, double flip, boolean floats) {
        if (d.isNone()) {
            console.print("equal: all %s agree in every bit", Console.count(values, "value"));
            return;
        }
        console.print("different: %d of %d pixels, %d of %d values", d.pixels(), values / 3, d.values(), values);
        console.print("largest difference  %.6g linear at pixel %d,%d; %s at most anywhere", d.maxAbsolute(), d.x(), d.y(),
                floats ? d.maxUlp() + " ulp" : d.maxLevels() + " of 255 levels");
        console.print("mean difference     %.6g linear", d.meanAbsolute());
        console.print("rmse                %.6g linear, PSNR %.2f dB", d.rmse(), d.linearPsnr());
        console.print(Double.isInfinite(d.displayPsnr()) ? "as displayed        equal"
                : "as displayed        PSNR %.2f dB, SSIM %.6f, FLIP %.6f", d.displayPsnr(), d.ssim(), flip);
    }
}
