package lightning.render.shading;

import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import lightning.render.gather.GatherRays;

/**
 * Numbers of rays cast by a trace, by purpose.
 *
 * @param eye       camera rays
 * @param mirrored  bounced rays
 * @param gathering rays of indirect light, light of environments and blurred reflections
 * @param shadows   shadow rays of each light by its name, those of surfels and fog included; none of a light without any
 */
public record RayCounts(long eye, long mirrored, GatherRays gathering, Map<String, Long> shadows) {
    public static final RayCounts NONE = new RayCounts(0, 0, GatherRays.NONE, Map.of());

    public RayCounts {
        shadows = shadows.entrySet().stream().filter(light -> light.getValue() != 0)
                .collect(Collectors.toUnmodifiableMap(Map.Entry::getKey, Map.Entry::getValue));
    }

    /** Returns the counts of shadow rays. */
    public static RayCounts ofShadows(Map<String, Long> shadows) {
        return new RayCounts(0, 0, GatherRays.NONE, shadows);
    }

    /** Returns the counts of rays of indirect light. */
    public static RayCounts of(GatherRays gathering) {
        return new RayCounts(0, 0, gathering, Map.of());
    }

    /** Returns the number of rays of indirect light, light of environments and blurred reflections. */
    public long gather() {
        return gathering.total();
    }

    /** Returns the number of shadow rays. */
    public long shadow() {
        return shadows.values().stream().mapToLong(Long::longValue).sum();
    }

    public long total() {
        return eye + mirrored + gather() + shadow();
    }

    public RayCounts plus(RayCounts o) {
        return new RayCounts(eye + o.eye, mirrored + o.mirrored, gathering.plus(o.gathering), plus(shadows, o.shadows, 1));
    }

    public RayCounts minus(RayCounts o) {
        return new RayCounts(eye - o.eye, mirrored - o.mirrored, gathering.minus(o.gathering), plus(shadows, o.shadows, -1));
    }

    private static Map<String, Long> plus(Map<String, Long> a, Map<String, Long> b, long sign) {
        Map<String, Long> sum = new TreeMap<>(a);
        b.forEach((light, rays) -> sum.merge(light, sign * rays, Long::sum));
        return sum;
    }
}
