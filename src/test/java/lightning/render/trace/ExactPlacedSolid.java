package lightning.render.trace;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lightning.base.math.Vec3;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;

/** Shape in nested groups, with scales from 10⁻⁶ to 10⁶, and a camera, in arbitrary precision. */
record ExactPlacedSolid(Solid.Canonical solid, List<Placement> placements, Vec3 camera, ExactPlacement exact, Geometry geometry) {
    private static final double[] SCALES = {1e-6, 1e-3, 0.37, 1, 1, 7, 1e3, 1e6};

    static ExactPlacedSolid random(Solid.Canonical solid, Random random) {
        while (true) {
            List<Placement> placements = new ArrayList<>();
            for (int g = random.nextInt(3); g >= 0; g--) {
                placements.add(placement(random));
            }
            double minScale = 1;
            double maxScale = 1;
            boolean isInRange = true;
            for (Placement placement : placements) {
                minScale *= placement.minScale();
                maxScale *= placement.maxScale();
                isInRange &= minScale >= 1e-6 && maxScale <= 1e6;
            }
            if (isInRange) {
                ExactPlacement exact = new ExactPlacement(placements);
                Vec3 camera = random.nextInt(3) == 0 ? Vec3.ZERO
                        : doubles(exact.toScene(exact(HardRay.direction(random).times(Math.pow(10, 4 * random.nextDouble() - 1)))));
                if (camera.maxAbs() < 1e11) {
                    return create(solid, placements, camera);
                }
            }
        }
    }

    static ExactPlacedSolid create(Solid.Canonical solid, List<Placement> placements, Vec3 camera) {
        return new ExactPlacedSolid(solid, placements, camera, new ExactPlacement(placements),
                Geometry.of(TraceScenes.singleShape(solid, placements, camera)));
    }

    private static Placement placement(Random random) {
        Vec3 at = random.nextBoolean() ? Vec3.ZERO : HardRay.direction(random).times(Math.pow(10, 5 * random.nextDouble() - 2));
        Vec3 rotate = switch (random.nextInt(4)) {
            case 0 -> Vec3.ZERO;
            case 1 -> new Vec3(90 * random.nextInt(5), 30 * random.nextInt(12), -60);
            case 2 -> HardRay.direction(random).times(1e5);
            default -> HardRay.direction(random).times(100);
        };
        double scale = scale(random);
        return new Placement(at, rotate, random.nextInt(3) > 0 ? Vec3.ONE.times(scale) : new Vec3(scale, -scale(random), scale(random)));
    }

    private static double scale(Random random) {
        return SCALES[random.nextInt(SCALES.length)];
    }

    Vec3 toRender(Vec3 local) {
        return doubles(exact.toScene(exact(local))).minus(camera);
    }

    /** Returns the local coordinates of a point in render space. */
    BigDecimal[] toLocal(Vec3 render) {
        BigDecimal[] r = exact(render);
        BigDecimal[] c = exact(camera);
        return exact.toLocal(new BigDecimal[] {r[0].add(c[0]), r[1].add(c[1]), r[2].add(c[2])});
    }

    static BigDecimal[] exact(Vec3 v) {
        return ExactSolids.exact(v.x(), v.y(), v.z());
    }

    static Vec3 doubles(BigDecimal[] v) {
        return new Vec3(v[0].doubleValue(), v[1].doubleValue(), v[2].doubleValue());
    }

    static double absSum(Vec3 v) {
        return Math.abs(v.x()) + Math.abs(v.y()) + Math.abs(v.z());
    }
}
