package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.Dome;
import lightning.scene.sky.Sky;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Arbitrary domes and edits of them. */
final class DomeArbitraries {
    private DomeArbitraries() {}

    /** Returns one to three domes, some of them off or solo. */
    static Arbitrary<List<Dome>> domes() {
        Arbitrary<Dome> dome = Combinators.combine(SceneArbitraries.environmentMaps(), SceneArbitraries.domeRotations(),
                NumberArbitraries.rangeOrSpecial(0, 2, 0.0, 1.0), SceneArbitraries.environmentGains(), Arbitraries.of(4, 5, 7),
                SceneArbitraries.softnesses(), Arbitraries.of(true, true, true, false), Arbitraries.of(false, false, false, true)).as(
                        (image, rotation, intensity, gain, lights, softness, on, solo) -> new Dome("unnamed", Optional.of(image), Sky.NONE,
                                rotation,
                                intensity, gain, lights, softness, on, solo));
        return dome.list().ofMinSize(1).ofMaxSize(3).map(DomeArbitraries::named);
    }

    private static List<Dome> named(List<Dome> domes) {
        List<Dome> named = new ArrayList<>();
        domes.forEach(dome -> named.add(dome.withName("dome " + (named.size() + 1))));
        return named;
    }

    static Arbitrary<Edit> edits() {
        Arbitrary<Integer> index = Arbitraries.integers().between(0, 2);
        return Arbitraries.oneOf(List.of(
                domes().map(Edit.SetDomes::new),
                Arbitraries.just(new Edit.SetDomes(List.of())),
                Combinators.combine(index, SceneArbitraries.environmentMaps().optional(0.8))
                        .as((i, v) -> new Edit.EditDome<>(i, Dome.ENVIRONMENT, v)),
                Combinators.combine(index, SceneArbitraries.rotations()).as((i, v) -> new Edit.EditDome<>(i, Dome.ROTATION, v)),
                Combinators.combine(index, SceneArbitraries.tilts()).as((i, v) -> new Edit.EditDome<>(i, Dome.TILT, v)),
                Combinators.combine(index, NumberArbitraries.rangeOrSpecial(0, 2, 0.0, 1.0))
                        .as((i, v) -> new Edit.EditDome<>(i, Dome.INTENSITY, v)),
                Combinators.combine(index, SceneArbitraries.environmentGains()).as((i, v) -> new Edit.EditDome<>(i, Dome.GAIN, v)),
                Combinators.combine(index, Arbitraries.of(true, false)).as((i, v) -> new Edit.EditDome<>(i, Dome.ON, v)),
                Combinators.combine(index, Arbitraries.of(true, false)).as((i, v) -> new Edit.EditDome<>(i, Dome.SOLO, v))));
    }
}
