package lightning.render.fog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

class FogPathTest {
    private static FogPath toPoint(double x, double y, double z) {
        FogPath path = new FogPath();
        path.aimAtPoint(x, y, z, 0, 0, 1, 1);
        return path;
    }

    @Example
    void places_startAtEyeAndEndInInfinity() {
        assertThat(toPoint(1, 2, 3).distance(0)).isCloseTo(0, within(1e-12));
        assertThat(toPoint(1, 2, 3).distance(1)).isInfinite();
        assertThat(toPoint(1, 2, 3).place(Double.POSITIVE_INFINITY)).isEqualTo(1);
        assertThat(toPoint(1, 2, 3).place(0)).isZero();
    }

    @Example
    void nearestPoint_isAtRightAngle() {
        FogPath path = toPoint(2, 0, 2);
        // From −45 to 90 degrees: tan(θ/2) grows from −0.414 to 1, and is 0 next to the light.
        assertThat(path.place(2)).isCloseTo(0.41421356 / 1.41421356, within(1e-8));
    }

    @Example
    void directionalLight_hasHalfOfPlacesBeforeScale() {
        FogPath path = new FogPath();
        path.aimAlong(7);
        assertThat(path.place(7)).isEqualTo(0.5);
        assertThat(path.distance(0.5)).isEqualTo(7);
    }

    @Property
    void place_isInverseOfDistance(@ForAll @DoubleRange(min = -5, max = 5) double x, @ForAll @DoubleRange(min = -5, max = 5) double y,
            @ForAll @DoubleRange(min = -5, max = 5) double z, @ForAll @DoubleRange(min = 0, max = 0.99) double place) {
        FogPath path = toPoint(x, y, z);
        assertThat(path.place(path.distance(place))).isCloseTo(place, within(1e-9));
    }

    @Property
    void distances_grow(@ForAll @DoubleRange(min = -5, max = 5) double x, @ForAll @DoubleRange(min = -5, max = 5) double z) {
        FogPath path = toPoint(x, 0, z);
        double last = -1;
        for (int i = 0; i <= FogGrid.SAMPLES; i++) {
            double distance = path.distance((double) i / FogGrid.SAMPLES);
            assertThat(distance).isGreaterThanOrEqualTo(last);
            last = distance;
        }
    }
}
