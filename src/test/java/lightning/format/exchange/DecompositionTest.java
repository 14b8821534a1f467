package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.Placement;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** What a placement can say is found again in its map; what it cannot say is known. */
class DecompositionTest {
    @Property
    void placement_isFoundAgain(@ForAll @DoubleRange(min = -180, max = 180) double x, @ForAll @DoubleRange(min = -180, max = 180) double y,
            @ForAll @DoubleRange(min = -180, max = 180) double z, @ForAll @DoubleRange(min = 0.01, max = 100) double scale,
            @ForAll boolean mirrors) {
        assertSame(new Placement(new Vec3(x, -y, 3), new Vec3(x, y, z), new Vec3(mirrors ? -scale : scale, 2, scale + 1)).transform());
    }

    @Property
    void quarterTurns_areFoundAgain(@ForAll int x, @ForAll int y, @ForAll int z) {
        assertSame(Transform.rotation(new Vec3(90 * (x % 4), 90 * (y % 4), 90 * (z % 4))));
    }

    @Property
    void turnsNearAQuarterAboutY_areFoundAgain(@ForAll @DoubleRange(min = -180, max = 180) double x,
            @ForAll @DoubleRange(min = -180, max = 180) double z, @ForAll @DoubleRange(min = -12, max = 0) double off,
            @ForAll boolean other) {
        Transform map = Transform.rotation(new Vec3(x, (other ? -90 : 90) - Math.pow(10, off), z));
        Transform found = Decomposition.of(map).getFirst().transform();
        for (Vec3 axis : new Vec3[] {new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1)}) {
            // Three angles are rounded to nine decimals of a degree, some 1e-11 radians.
            assertThat(found.point(axis).minus(map.point(axis)).maxAbs()).isLessThan(1e-10);
        }
    }

    @Property
    void shear_isTwoPlacements(@ForAll @DoubleRange(min = -180, max = 180) double turn, @ForAll @DoubleRange(min = -3, max = 3) double size,
            @ForAll @DoubleRange(min = -3, max = 3) double xy, @ForAll @DoubleRange(min = -3, max = 3) double yz, @ForAll boolean mirrors) {
        assertSame(new Transform(1, xy, 0, 1, 0, 1, yz, 2, 0, 0, mirrors ? -1 : 1, 3).times(Math.pow(10, size))
                .times(Transform.rotation(new Vec3(turn, 2 * turn, 3 * turn))));
        assertThat(Decomposition.of(new Transform(1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0))).hasSize(2);
    }

    @Test
    void mapsThatAreFlat_areNone() {
        assertThat(Decomposition.of(new Transform(1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0))).isEmpty();
        assertThat(Decomposition.of(Transform.scaling(new Vec3(1, 0, 1)))).isEmpty();
        assertThat(Decomposition.of(Transform.scaling(new Vec3(1, Double.NaN, 1)))).isEmpty();
        assertThat(Decomposition.of(Transform.translation(new Vec3(1e13, 0, 0)))).isEmpty();
    }

    private static void assertSame(Transform map) {
        Transform found = Decomposition.of(map).stream().map(Placement::transform).reduce(Transform::times).orElseThrow();
        for (Vec3 p : new Vec3[] {Vec3.ZERO, new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1)}) {
            assertThat(found.point(p).minus(map.point(p)).maxAbs()).as("%s of %s", p, map).isLessThan(1e-4);
        }
    }
}
