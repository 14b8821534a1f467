package lightning.format.exchange.usd;

import java.io.IOException;
import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.base.file.UnusableFileException;
import lightning.format.gltf.JsonValue;
import lightning.format.image.ImageSource;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureUsage;

/**
 * Numbers that an input of a surface reads from a texture: {@code scale · sample + bias}, limited to 0…1.
 *
 * @param channel index of the channel: red, green, blue, alpha
 * @param isCurved whether the samples are sRGB codes, which are converted to linear values
 */
record TextureNumbers(int channel, double scale, double bias, boolean isCurved) {
    private static final int ALPHA = 3;

    /** Returns the numbers of a texture in a stage. */
    static TextureNumbers of(JsonValue image) throws MeshException {
        int channel = Math.max(0, "rgba".indexOf(image.get("channel").text().orElse("r")));
        double scale = image.get("scale").numbers(1, 1, 1, 1)[channel];
        double bias = image.get("bias").numbers(0, 0, 0, 0)[channel];
        return new TextureNumbers(channel, UsdNumbers.tidy(scale), UsdNumbers.tidy(bias),
                channel != ALPHA && image.get("space").text().orElse("").equals("sRGB"));
    }

    /** Returns whether the image's own samples, multiplied by {@link #scale}, are these numbers. */
    boolean isProduct() {
        return channel != ALPHA && !isCurved && bias == 0 && scale >= 0 && scale <= 1;
    }

    /** Returns whether these numbers are an image's alpha. */
    boolean isAlpha() {
        return channel == ALPHA;
    }

    /**
     * Returns whether these numbers are the opacity of an image: its alpha, or its gray if it has none.
     *
     * @throws UnusableFileException as {@link UsdImages#read}
     */
    boolean isOpacityOf(UsdTiles.Tile tile) throws IOException {
        if (scale != 1 || bias != 0 || isCurved || UsdImages.read(tile.place(), ImageSource::hasAlpha) != isAlpha()) {
            return false;
        }
        return isAlpha() || isGray(UsdImages.read(tile.place(), TextureUsage.DATA));
    }

    private static boolean isGray(Texture image) {
        float[] rgb = image.values();
        return IntStream.range(0, rgb.length).allMatch(i -> rgb[i] == rgb[i - i % 3]);
    }

    /** Returns the channel of a map whose numbers are a product. */
    TextureChannel mapChannel() {
        return TextureChannel.values()[channel];
    }

    /** Returns how the image is decoded. */
    TextureUsage usage() {
        return channel == ALPHA ? TextureUsage.OPACITY : isCurved ? TextureUsage.COLOR : TextureUsage.DATA;
    }

    /** Returns the number of a decoded sample, 0…1. */
    float of(double sample) {
        return (float) Math.clamp(scale * sample + bias, 0, 1);
    }

    /**
     * Reads an image and returns these numbers as its red, green and blue.
     *
     * @throws UnusableFileException as {@link UsdImages#read}
     */
    Texture read(UsdTiles.Tile tile) throws IOException {
        // An image without alpha is opaque.
        boolean isOpaque = channel == ALPHA && !UsdImages.read(tile.place(), ImageSource::hasAlpha);
        Texture image = UsdImages.read(tile.place(), usage());
        float[] rgb = image.values();
        for (int i = 0; i < rgb.length; i += 3) {
            Arrays.fill(rgb, i, i + 3, of(isOpaque ? 1 : rgb[i + channel % ALPHA]));
        }
        return new Texture(image.width(), image.height(), rgb);
    }
}
