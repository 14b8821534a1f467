package lightning.document.manipulation;

import lightning.base.math.Vec3;
import lightning.scene.Camera;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Arbitraries for cameras, canvases and directions. */
final class ViewArbitraries {
    private ViewArbitraries() {}

    static Arbitrary<Vec3> points() {
        Arbitrary<Double> coordinate = Arbitraries.doubles().between(-20, 20).ofScale(3);
        return Combinators.combine(coordinate, coordinate, coordinate).as(Vec3::new);
    }

    static Arbitrary<Vec3> directions() {
        return points().filter(v -> v.length() > 0.5);
    }

    static Arbitrary<PreviewCamera> cameras() {
        Arbitrary<Double> fov = Arbitraries.doubles().between(10, 100).ofScale(1);
        return Combinators.combine(points(), directions(), directions(), fov)
                .filter((from, way, up, f) -> way.normalized().cross(up.normalized()).length() > 0.01)
                .as((from, way, up, f) -> new PreviewCamera(new Camera(from, from.plus(way), up, f)));
    }

    static Arbitrary<Viewport> canvases() {
        Arbitrary<Integer> side = Arbitraries.integers().between(50, 2000);
        return Combinators.combine(side, side).as(Viewport::new);
    }

    /** Returns mouse movements in pixels. */
    static Arbitrary<Double> distances() {
        return Arbitraries.doubles().between(-300, 300).ofScale(1);
    }
}
