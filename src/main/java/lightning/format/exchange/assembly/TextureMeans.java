package lightning.format.exchange.assembly;

import java.util.Optional;
import lightning.base.file.UnusableFileException;
import lightning.format.image.ImageFile;
import lightning.format.jen.asset.TextureFile;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;

/**
 * Means of a glTF metallic-roughness texture, for transparent materials: they have one roughness and one metalness.
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
            Texture texture = ImageFile.read("surface", file, TextureFile.WHOLE, image -> image.texture(TextureUsage.DATA, 1));
            return Optional.of(new TextureMeans(mean(texture, GREEN), mean(texture, BLUE)));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    public static double mean(Texture texture, int channel) {
        return mean(texture, 0, texture.width(), 0, texture.height(), channel);
    }

    /** Returns the mean of a block of pixels: columns from {@code x0} to below {@code x1}, rows from {@code y0} to below {@code y1}. */
    public static double mean(Texture texture, int x0, int x1, int y0, int y1, int channel) {
        double sum = 0;
        for (int y = y0; y < y1; y++) {
            for (int x = x0; x < x1; x++) {
                sum += texture.channel(x, y, channel);
            }
        }
        return sum / ((double) (x1 - x0) * (y1 - y0));
    }
}
