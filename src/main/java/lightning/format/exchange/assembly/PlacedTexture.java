package lightning.format.exchange.assembly;

import java.util.Optional;
import lightning.base.math.Affine2;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap.Edge;
import lightning.scene.value.SceneLimits;

/** Converter of other programs' maps of texture coordinates to the repetition, rotation and offset of a texture. */
public final class PlacedTexture {
    private static final double MIN_REPEAT = 1e-6;
    /** Largest cosine of axes that count as perpendicular; numbers in files are floats. */
    private static final double MAX_SHEAR = 1e-5;
    private static final double ROUNDING = 1e-9;

    private PlacedTexture() {}

    /**
     * Returns a texture that shows at each coordinate what its image has at the mapped one.
     *
     * @param texture its repetition and placement are replaced
     * @return empty if the map has a shear, or a number that is too large or too small
     */
    public static Optional<TextureMap> of(TextureMap texture, Affine2 map) {
        double length = Math.hypot(map.uu(), map.vu());
        // A rotation by at most a quarter; a larger one mirrors both axes.
        double sign = map.uu() < -ROUNDING * length ? -1 : 1;
        double cosine = sign * map.uu() / length;
        double sine = sign * map.vu() / length;
        double repeatU = NineDigits.rounded(sign * length);
        double repeatV = NineDigits.rounded(cosine * map.vv() - sine * map.uv());
        double shear = cosine * map.uv() + sine * map.vv();
        if (!isRepeat(repeatU) || !isRepeat(repeatV) || !(Math.abs(shear) <= MAX_SHEAR * Math.abs(repeatV))) {
            return Optional.empty();
        }
        // Mirrored images that do not repeat are at their own place.
        double mirroredU = repeatU < 0 && texture.wrap().u() != Edge.REPEAT ? 1 : 0;
        double mirroredV = repeatV < 0 && texture.wrap().v() != Edge.REPEAT ? 1 : 0;
        double offsetU = offset(map.u0() - cosine * mirroredU + sine * mirroredV, texture.wrap().u());
        double offsetV = offset(map.v0() - sine * mirroredU - cosine * mirroredV, texture.wrap().v());
        if (!(Math.max(Math.abs(offsetU), Math.abs(offsetV)) <= SceneLimits.MAX_REPEAT)) {
            return Optional.empty();
        }
        return Optional.of(texture.withRepeatU(repeatU).withRepeatV(repeatV).withPlacement(
                new TexturePlacement(offsetU, offsetV, NineDigits.rounded(Math.toDegrees(Math.atan2(sine, cosine))))));
    }

    private static boolean isRepeat(double v) {
        return Math.abs(v) >= MIN_REPEAT && Math.abs(v) <= SceneLimits.MAX_REPEAT;
    }

    /** Returns the smallest offset that shows the same. */
    private static double offset(double v, Edge edge) {
        double period = switch (edge) {
            case REPEAT -> 1;
            case MIRROR -> 2;
            case CLAMP -> Double.POSITIVE_INFINITY;
        };
        double rounded = NineDigits.rounded(v);
        return rounded > -period && rounded < period ? rounded : NineDigits.rounded(rounded - period * Math.floor(rounded / period));
    }
}
