package lightning.cli.report;

import java.util.Map;
import java.util.TreeMap;
import lightning.render.gather.GatherRays;
import lightning.render.shading.RayCounts;

/**
 * Number of rays by purpose.
 *
 * @param eye       camera rays
 * @param bounce    mirrored and refracted rays
 * @param gather    rays of indirect light, of an environment's light and of blurred reflections
 * @param gathering the same by purpose
 * @param shadow    shadow rays
 * @param lights    shadow rays of each light by its name, those of surfels and fog included
 */
public record RaysReport(long eye, long bounce, long gather, GatherRays gathering, long shadow, Map<String, Long> lights) {
    public static RaysReport of(RayCounts rays) {
        return new RaysReport(rays.eye(), rays.mirrored(), rays.gather(), rays.gathering(), rays.shadow(), new TreeMap<>(rays.shadows()));
    }
}
