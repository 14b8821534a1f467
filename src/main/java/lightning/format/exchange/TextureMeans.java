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
record TextureMeans(double roughness, double metalness) {
    /** Of no picture. */
    static final TextureMeans NONE = new TextureMeans(1, 1);

    private static final int GREEN = 1;
    private static final int BLUE = 2;

    /** @return empty where the bytes are no picture that a scene can show */
    static Optional<TextureMeans> of(byte[] file) {
        try {
            Texture texture = TextureDecoder.decodeNumbers("surface", file);
            return Optional.of(new TextureMeans(mean(texture, GREEN), mean(texture, BLUE)));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    /** The mean of a picture of colors, linear; empty where the bytes are no picture that a scene can show. */
    static Optional<Rgb> meanColor(byte[] file) {
        try {
            Texture texture = TextureDecoder.decodeColors("emission", file);
            return Optional.of(new Rgb(mean(texture, 0), mean(texture, GREEN), mean(texture, BLUE)));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    private static double mean(Texture texture, int channel) {
        double sum = 0;
        for (int y = 0; y < texture.height(); y++) {
            for (int x = 0; x < texture.width(); x++) {
                sum += texture.channel(x, y, channel);
            }
        }
        return sum / ((double) texture.width() * texture.height());
    }
}
