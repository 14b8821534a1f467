package lightning.render.relight;

import java.util.Optional;
import lightning.render.cache.IndirectCache;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.build.GatherBuilder;
import lightning.render.gather.glow.GlowLinks;
import lightning.render.gather.ray.RayHits;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.reflection.ReflectionFilter;
import lightning.render.gather.reflection.ReflectionLinks;
import lightning.render.gather.rim.RimLinks;
import lightning.render.image.Film;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.scene.GatherSettings;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Forecast of the memory of a picture's indirect light, without the weights of its rows. Gather points grow with the pixels, and a little
 * more slowly, because small pictures have more contacts between surfaces in a pixel. Surfels, whose cells are a fixed part of the
 * picture, grow as the root of its side: more rays find more cells.
 *
 * @param bytesPerPixel bytes of gather points per pixel in a picture of any size
 * @param borderBytes   additional bytes per pixel for a longer side of one pixel
 * @param surfelBytes   bytes of surfels and their layers in a picture whose longer side is {@code side}
 * @param surfelBuildBytes bytes of surfels while paths are built, in the same picture
 * @param buildFactor   bytes of gather points while paths are built, relative to those kept
 */
record IndirectEstimate(double bytesPerPixel, double borderBytes, double surfelBytes, double surfelBuildBytes, double side,
        double buildFactor) {
    static final IndirectEstimate NONE = new IndirectEstimate(0, 0, 0, 0, 1, 1);
    /**
     * Bytes of a point without its links: place, normal, lengths, light, its additional rays, an entry of the table of known points, and a filter of 256
     * neighbors, several times the usual number, both before and after it is packed.
     */
    private static final int POINT_BYTES = 56 + 8 + 16 + 8 + (8 + 2) * 256;
    /** Bytes of a surfel besides its row: its number, and while an edit is made its place, cell, first ray and entry in a table. */
    private static final int SURFEL_BYTES = 4 + 28 + 8 + 4 + 16;

    /** Measured indirect light of a small picture. */
    record Sample(double pixels, double side, long pointBytes, long surfelBytes, long pointBuildBytes, long surfelBuildBytes) {
        static Sample of(PictureSettings picture, @Nullable IndirectCache indirect) {
            double pixels = placedPixels(picture);
            double side = longerSide(picture);
            if (indirect == null) {
                return new Sample(pixels, side, 0, 0, 0, 0);
            }
            GatherStructure structure = indirect.structure();
            return new Sample(pixels, side, structure.pointBytes(), indirect.bytes() - structure.pointBytes(), structure.pointBuildBytes(),
                    structure.buildBytes() - structure.pointBuildBytes());
        }

        private double bytesPerPixel() {
            return pointBytes / pixels;
        }

        private double buildFactor() {
            return pointBytes == 0 ? 1 : (double) pointBuildBytes / pointBytes;
        }
    }

    /** Extrapolates from two pictures, the larger of which has twice the side. */
    static IndirectEstimate of(Sample small, Sample large) {
        double border = Math.max(0, (small.bytesPerPixel() - large.bytesPerPixel()) * large.side);
        return new IndirectEstimate(large.bytesPerPixel() - border / large.side, border, large.surfelBytes,
                large.surfelBuildBytes, large.side, large.buildFactor());
    }

    /** Extrapolates from one picture; rather too large for larger ones. */
    static IndirectEstimate upperOf(Sample sample, double margin) {
        return new IndirectEstimate(margin * sample.bytesPerPixel(), 0, margin * sample.surfelBytes, margin * sample.surfelBuildBytes,
                sample.side, sample.buildFactor());
    }

    /** Returns the bytes in a finished picture. */
    double bytes(PictureSettings picture) {
        return pointBytes(picture) + surfelBytes * Math.sqrt(longerSide(picture) / side);
    }

    /** Returns the bytes while paths are built, before there are other rows. */
    double buildBytes(PictureSettings picture) {
        return buildFactor * pointBytes(picture) + surfelBuildBytes * Math.sqrt(longerSide(picture) / side);
    }

    private double pointBytes(PictureSettings picture) {
        return placedPixels(picture) * (bytesPerPixel + borderBytes / Math.max(longerSide(picture), side));
    }

    /** Returns the pixels by which gather points are placed. */
    private static double placedPixels(PictureSettings picture) {
        return picture.width() / IndirectSettings.pixelScale(picture) * (picture.height() / IndirectSettings.pixelScale(picture));
    }

    private static double longerSide(PictureSettings picture) {
        return Math.max(picture.width(), picture.height()) / IndirectSettings.pixelScale(picture);
    }

    /**
     * Returns an upper bound of the bytes, including those only while paths are built. Each candidate becomes a point,
     * and each ray of a point finds a new surfel; further bounces then find no others.
     *
     * @param levels         levels seen from the first
     * @param texelBytes     bytes of the texture colors of a row
     * @param layerBytes     bytes of all layers per row
     * @param glows          whether rays may be aimed at glowing objects, in addition to the others
     */
    static long upperBound(Scene scene, long levels, int texelBytes, long layerBytes, boolean glows) {
        Optional<GatherSettings> needed = GatherSettings.of(scene);
        if (needed.isEmpty()) {
            return 0;
        }
        PictureSettings picture = scene.picture();
        GatherSettings settings = needed.get();
        int along = Math.ceilDiv(Film.TILE_SIZE, GatherBuilder.candidateStep(settings, picture));
        double candidates = (double) Film.tilesAlong(picture.width()) * Film.tilesAlong(picture.height()) * along * along * (1 + levels);
        double rays = settings.gathers() ? candidates * settings.rays() : 0;
        double reflectedRays = settings.reflections() ? candidates * GatherBuilder.maxReflectedRays(settings) : 0;
        int linkBytes = RayLinks.BUILD_BYTES + RayHits.TINT_BUILD_BYTES + Integer.BYTES;
        // Additional rays are at most half as many.
        double rimBytes = settings.environment() ? 0.5 * RimLinks.BUILD_BYTES : 0;
        double glowBytes = glows ? GlowLinks.BUILD_BYTES : 0;
        double surfelBytes = ColumnGroup.HIT.bytesPerRow() + texelBytes + ColumnGroup.OWNER.bytesPerRow()
                + ColumnGroup.TRANSPARENT.bytesPerRow() + layerBytes + SURFEL_BYTES
                + (settings.pathBounces() > 0 && (settings.bounces() > 1 || settings.environment())
                        ? (linkBytes + glowBytes) * settings.surfelRaysPerSide() * settings.surfelRaysPerSide() : 0);
        double rowBytes = ColumnGroup.HIT.bytesPerRow() + texelBytes + ColumnGroup.OWNER.bytesPerRow();
        return (long) Math.min(Long.MAX_VALUE / 4.0,
                candidates * (rowBytes + POINT_BYTES + (settings.reflections() ? ReflectionFilter.ENOUGH * POINT_BYTES : 0))
                        + rays * (linkBytes + rimBytes + glowBytes + surfelBytes)
                        + reflectedRays * (ReflectionLinks.BUILD_BYTES + RayHits.TINT_BUILD_BYTES + surfelBytes));
    }
}
