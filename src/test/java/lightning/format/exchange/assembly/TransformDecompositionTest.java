package lightning.format.exchange.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.value.Placement;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** Decomposition recovers placements from their transforms, and reports transforms that are none. */
class TransformDecompositionTest {
    @Property
    void placement_isRecovered(@ForAll @DoubleRange(min = -180, max = 180) double x, @ForAll @DoubleRange(min = -180, max = 180) double y,
            @ForAll @DoubleRange(min = -180, max = 180) double z, @ForAll @DoubleRange(min = 0.01, max = 100) double scale,
            @ForAll boolean isMirrored) {
        assertSame(new Placement(new Vec3(x, -y, 3), new Vec3(x, y, z), new Vec3(isMirrored ? -scale : scale, 2, scale + 1)).transform());
    }

    @Property
    void quarterTurns_areRecovered(@ForAll int x, @ForAll int y, @ForAll int z) {
        assertSame(Transform.rotation(new Vec3(90 * (x % 4), 90 * (y % 4), 90 * (z % 4))));
    }

    @Property
    void nearQuarterTurnsAboutY_areRecovered(@ForAll @DoubleRange(min = -180, max = 180) double x,
            @ForAll @DoubleRange(min = -180, max = 180) double z, @ForAll @DoubleRange(min = -12, max = 0) double deviation,
            @ForAll boolean isNegative) {
        Transform transform = Transform.rotation(new Vec3(x, (isNegative ? -90 : 90) - Math.pow(10, deviation), z));
        Transform found = TransformDecomposition.decompose(transform).getFirst().transform();
        for (Vec3 axis : new Vec3[] {new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1)}) {
            // Three angles are rounded to nine decimals of a degree, about 1e-11 radians.
            assertThat(found.transformPoint(axis).minus(transform.transformPoint(axis)).maxAbs()).isLessThan(1e-10);
        }
    }

    @Property
    void shear_becomesTwoPlacements(@ForAll @DoubleRange(min = -180, max = 180) double angle,
            @ForAll @DoubleRange(min = -3, max = 3) double size,
            @ForAll @DoubleRange(min = -3, max = 3) double xy, @ForAll @DoubleRange(min = -3, max = 3) double yz,
            @ForAll boolean isMirrored) {
        assertSame(new Transform(1, xy, 0, 1, 0, 1, yz, 2, 0, 0, isMirrored ? -1 : 1, 3).times(Math.pow(10, size))
                .times(Transform.rotation(new Vec3(angle, 2 * angle, 3 * angle))));
        assertThat(TransformDecomposition.decompose(new Transform(1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0))).hasSize(2);
    }

    @Test
    void flatTransforms_haveNoPlacement() {
        assertThat(TransformDecomposition.decompose(new Transform(1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0))).isEmpty();
        assertThat(TransformDecomposition.decompose(Transform.scaling(new Vec3(1, 0, 1)))).isEmpty();
        assertThat(TransformDecomposition.decompose(Transform.scaling(new Vec3(1, Double.NaN, 1)))).isEmpty();
        assertThat(TransformDecomposition.decompose(Transform.translation(new Vec3(1e13, 0, 0)))).isEmpty();
    }

    private static void assertSame(Transform transform) {
        Transform found =
                TransformDecomposition.decompose(transform).stream().map(Placement::transform).reduce(Transform::times).orElseThrow();
        for (Vec3 p : new Vec3[] {Vec3.ZERO, new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1)}) {
            assertThat(found.transformPoint(p).minus(transform.transformPoint(p)).maxAbs()).as("%s of %s", p, transform).isLessThan(1e-4);
        }
    }
}
