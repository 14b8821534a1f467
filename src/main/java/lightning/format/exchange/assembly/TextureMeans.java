package lightning.format.exchange.assembly;

import java.util.Optional;
import lightning.format.jen.asset.TextureDecoder;
import lightning.format.jen.asset.UnusableFileException;
import lightning.scene.asset.Texture;

/**
 * Means of a glTF metallic-roughness texture, since materials here have one roughness and one metalness.
 *
 * @param roughness 0 … 1, green channel
 * @param metalness 0 … 1, blue channel
 */
public record TextureMeans(double roughness, double metalness) {
    /** Means if there is no texture. */
    public static final TextureMeans NONE = new TextureMeans(1, 1);

    private static final int GREEN = 1;
    private static final int BLUE = 2;

    /**
     * Computes the means of an image.
     *
     * @return empty if the image format is not supported
     */
    public static Optional<TextureMeans> of(byte[] file) {
        try {
            Texture texture = TextureDecoder.decodeNumbers("surface", file);
            return Optional.of(new TextureMeans(mean(texture, GREEN), mean(texture, BLUE)));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    public static double mean(Texture texture, int channel) {
        double sum = 0;
        for (int y = 0; y < texture.height(); y++) {
            for (int x = 0; x < texture.width(); x++) {
                sum += texture.channel(x, y, channel);
            }
        }
        return sum / ((double) texture.width() * texture.height());
    }
}
