package lightning.textures;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import lightning.base.math.Rgb;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * Generator of the images in {@code textures/}. Deterministic: the same program gives the same files.
 *
 * <p>To run it, with Java 25 from the project's folder:
 * <pre>{@code
 * mvn -q test-compile
 * java -cp target/classes:target/test-classes lightning.textures.TextureGenerator textures
 * }</pre>
 * Further arguments select textures, as in {@code wood brick}.
 */
public final class TextureGenerator {

    /** Width and height of each image, pixels. */
    static final int SIZE = 512;

    /** Samples per pixel side. */
    private static final int POINTS = 2;

    /** Shading of a slope of 1. */
    private static final double RELIEF = 0.9;

    /** Textures; a file's name is the constant's in lower case. */
    enum TextureName {
        WOOD(new WoodPattern()),
        BRICK(MasonryPatterns::brick),
        CHECKER(MasonryPatterns::checker),
        STONE(MasonryPatterns::stone),
        ROOF(MasonryPatterns::roof),
        CLOTH(FabricPatterns::cloth),
        LEATHER(FabricPatterns::leather),
        BOOK_COVER(FabricPatterns::bookCover),
        PAPER(FabricPatterns::paper),
        MARBLE(NaturePatterns::marble),
        ORANGE_PEEL(NaturePatterns::orangePeel),
        SAND(NaturePatterns::sand),
        GRASS(new GrassPattern()),
        NIGHT_SKY(NaturePatterns::nightSky),
        METAL_PLATES(new MetalPlatePattern()),
        GOBO_WINDOW(GoboPatterns::window),
        GOBO_LEAVES(GoboPatterns::leaves),
        PIANO_KEYS(StagePatterns::keys),
        MUSIC(StagePatterns::music),
        MOON(StagePatterns::moon),
        LENS(StagePatterns::lens);

        final TexturePattern pattern;

        TextureName(TexturePattern pattern) {
            this.pattern = pattern;
        }

        String fileName() {
            return name().toLowerCase(Locale.ROOT) + ".png";
        }
    }

    private TextureGenerator() {}

    /** Generates all or the named textures in the folder that the first argument names. */
    public static void main(String[] arguments) throws IOException {
        Path folder = Files.createDirectories(Path.of(arguments.length > 0 ? arguments[0] : "textures"));
        for (TextureName name : TextureName.values()) {
            if (arguments.length < 2 || List.of(arguments).contains(name.name().toLowerCase(Locale.ROOT))) {
                ImageFile.write(folder.resolve(name.fileName()), render(name.pattern, SIZE), ViewTransform.DEFAULT);
            }
        }
    }

    /** Renders the texture as a display-referred film of {@code size} by {@code size} pixels. */
    static Film render(TexturePattern pattern, int size) {
        int n = size * POINTS;
        Rgb[] colours = new Rgb[n * n];
        double[] heights = new double[n * n];
        for (int y = 0, i = 0; y < n; y++) {
            for (int x = 0; x < n; x++, i++) {
                TexturePattern.Sample point = pattern.at((x + 0.5) / n, (y + 0.5) / n);
                colours[i] = point.color();
                heights[i] = point.height();
            }
        }
        Film film = Film.black(size, size);
        for (int y = 0; y < n; y++) {
            for (int x = 0; x < n; x++) {
                double light = brightness(heights, x, y, n) / (POINTS * POINTS);
                Rgb colour = colours[y * n + x];
                int tile = film.tileOf(x / POINTS, y / POINTS);
                int pixel = Film.pixelInTile(x / POINTS, y / POINTS);
                film.red(tile)[pixel] += (float) (light * linear(colour.r()));
                film.green(tile)[pixel] += (float) (light * linear(colour.g()));
                film.blue(tile)[pixel] += (float) (light * linear(colour.b()));
            }
        }
        return film;
    }

    /** Returns the shading of the slope at a point, lit from the upper left. */
    private static double brightness(double[] heights, int x, int y, int n) {
        double right = heights[y * n + (x + 1) % n];
        double left = heights[y * n + (x + n - 1) % n];
        double below = heights[(y + 1) % n * n + x];
        double above = heights[(y + n - 1) % n * n + x];
        return Math.clamp(1 + RELIEF * (right - left + below - above) * n / 2, 0.35, 1.6);
    }

    private static double linear(double display) {
        double s = Math.clamp(display, 0, 1);
        return s <= 0.04045 ? s / 12.92 : StrictMath.pow((s + 0.055) / 1.055, 2.4);
    }
}
