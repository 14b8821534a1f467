package lightning.render.warmup;

import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.material.Material;

/**
 * Estimate of whether an image takes a new process long enough for the second compiler and the lanes to pay off. For the
 * threshold see docs/decisions/0120-single-images-with-a-smaller-java.md.
 */
public final class LongRenderCheck {
    /** About four seconds of processor time. */
    private static final long MIN_RAYS = 25_000_000;
    /** Rays for each ray that would be cast without glass: the image shows glass in part, and its rays split up to the depth. */
    private static final int GLASS_FACTOR = 6;
    /**
     * Rays that take as long as one of a gather point, with what follows from it: smaller cells, surfels, and weights of rows. Where points of
     * the largest cells cast 64 rays, 20 rays a pixel are cast in all on the scenes that come with the program.
     */
    private static final int GATHER_FACTOR = 150;
    /** The same for one of the rays by which a point collects blurred reflections, for each pixel: rough surfaces fill a part of the image. */
    private static final double REFLECTION_FACTOR = 2;
    /** Share of all finer samples that anti-aliasing at edges traces: 0.05 to 0.35 on the scenes that come with the program. */
    private static final double EDGE_SHARE = 0.2;

    private LongRenderCheck() {}

    /** @param scene scene as the view shows it */
    public static boolean isLong(Scene scene) {
        return estimateRays(scene) >= MIN_RAYS;
    }

    /**
     * Estimates the number of camera rays and shadow rays, as if a surface in each pixel faced every light; without mirrored
     * rays, and with rough numbers of refracted ones and of those that gather light.
     */
    static long estimateRays(Scene scene) {
        PictureSettings picture = scene.picture();
        SamplingSettings sampling = picture.sampling();
        double perPixel = switch (sampling.antialias()) {
            case OFF -> raysPerCenter(scene);
            case EDGES -> raysPerCenter(scene)
                    + (scene.hasSamplesOnlyAtEdges() ? EDGE_SHARE : 1) * sampling.samplesPerPixel() * raysPerFineSample(scene);
            case EVERY -> sampling.samplesPerPixel() * raysPerFineSample(scene);
        };
        double gathered = GatherSettings.of(scene).map(LongRenderCheck::raysPerPixel).orElse(0.0);
        boolean hasGlass = picture.depth() > 0 && scene.materials().stream().anyMatch(Material::isClear);
        return (long) (picture.width() * (double) picture.height() * (perPixel * (hasGlass ? GLASS_FACTOR : 1) + gathered));
    }

    private static double raysPerPixel(GatherSettings settings) {
        double ofPoints = settings.gathers() ? (double) settings.rays() / (settings.spacing() * settings.spacing()) : 0;
        return GATHER_FACTOR * ofPoints + REFLECTION_FACTOR * settings.reflectionRays();
    }

    private static long raysPerCenter(Scene scene) {
        return 1 + scene.rig().effectiveLights().stream().mapToLong(light -> light.isArea() ? light.area().samples() : 1).sum();
    }

    /** The finer samples of a pixel share the samples of an area light. */
    private static long raysPerFineSample(Scene scene) {
        SamplingSettings sampling = scene.picture().sampling();
        return 1 + scene.rig().effectiveLights().stream()
                .mapToLong(light -> light.isArea() ? sampling.lightSamples(light.area().samples()) : 1)
                .sum();
    }
}
