package lightning.cli.report;

import lightning.render.shading.RayCounts;

/**
 * Number of rays by kind.
 *
 * @param eye    camera rays
 * @param bounce mirrored and refracted rays
 * @param gather rays of indirect light
 * @param shadow shadow rays
 */
public record RaysReport(long eye, long bounce, long gather, long shadow) {
    public static RaysReport of(RayCounts rays) {
        return new RaysReport(rays.eye(), rays.mirrored(), rays.gather(), rays.shadow());
    }
}
