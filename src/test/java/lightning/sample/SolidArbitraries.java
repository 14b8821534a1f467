package lightning.sample;

import java.util.Random;
import lightning.scene.node.Solid;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/**
 * Arbitrary solids of all kinds and meshes, with and without caps; tops of frustums are mostly ordinary, else from 10⁻¹² to 10⁶ or next to
 * 1.
 */
public final class SolidArbitraries {
    private SolidArbitraries() {}

    public static Arbitrary<Solid> solids() {
        return Arbitraries.frequencyOf(
                Tuple.of(4, Arbitraries.of(Solid.SPHERE, Solid.CONE, Solid.CYLINDER, Solid.PLANE)),
                Tuple.of(3, Arbitraries.of(SampleMeshes.samples())),
                Tuple.of(2, Arbitraries.of(new Solid.Cone(false), new Solid.Cylinder(false))),
                Tuple.of(2, Combinators.combine(tops(), Arbitraries.of(true, false)).as(Solid.Frustum::new)));
    }

    private static Arbitrary<Double> tops() {
        return Arbitraries.frequencyOf(
                Tuple.of(4, NumberArbitraries.range(0.1, 2)),
                Tuple.of(2, Arbitraries.randomValue(SolidArbitraries::extreme)),
                Tuple.of(1, Arbitraries.of(0.0, 1.0, 1 - 0x1p-53, 1 + 0x1p-52)));
    }

    private static double extreme(Random random) {
        return Math.pow(10, 18 * random.nextDouble() - 12);
    }
}
