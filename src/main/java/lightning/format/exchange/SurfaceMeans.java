package lightning.format.exchange;

import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.format.jen.TextureDecoder;
import lightning.format.jen.UnusableFileException;
import lightning.scene.Texture;

/**
 * What glTF's picture of a surface says in the mean: a material here has one roughness and one metalness.
 *
 * @param roughness 0 … 1, its green
 * @param metalness 0 … 1, its blue
 */
record SurfaceMeans(double roughness, double metalness) {
    /** Of no picture. */
    static final SurfaceMeans NONE = new SurfaceMeans(1, 1);

    private static final int GREEN = 1;
    private static final int BLUE = 2;

    /** @return empty where the bytes are no picture that a scene can show */
    static Optional<SurfaceMeans> of(byte[] file) {
        try {
            Texture picture = TextureDecoder.numbers("surface", file);
            return Optional.of(new SurfaceMeans(mean(picture, GREEN), mean(picture, BLUE)));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    /** The mean of a picture of colors, linear; empty where the bytes are no picture that a scene can show. */
    static Optional<Rgb> color(byte[] file) {
        try {
            Texture picture = TextureDecoder.colors("emission", file);
            return Optional.of(new Rgb(mean(picture, 0), mean(picture, GREEN), mean(picture, BLUE)));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    private static double mean(Texture picture, int channel) {
        double sum = 0;
        for (int y = 0; y < picture.height(); y++) {
            for (int x = 0; x < picture.width(); x++) {
                sum += picture.channel(x, y, channel);
            }
        }
        return sum / ((double) picture.width() * picture.height());
    }
}
