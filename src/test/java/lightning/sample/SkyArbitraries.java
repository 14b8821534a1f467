package lightning.sample;

import java.util.List;
import lightning.scene.SkyAttributes;
import lightning.scene.sky.Sky;
import lightning.scene.sky.SkyUnit;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Physical skies and their edits. Values are few, so that most skies are known already. */
final class SkyArbitraries {
    private SkyArbitraries() {}

    static Arbitrary<Sky> skies() {
        return Combinators.combine(elevations(), azimuths(), turbidities(), strengths(), units())
                .as((elevation, azimuth, turbidity, sun, unit) -> Sky.NONE.with(
                        sky -> sky.on(true).elevation(elevation).azimuth(azimuth).turbidity(turbidity).sun(sun).unit(unit)));
    }

    static Arbitrary<Edit> edits() {
        return Arbitraries.oneOf(List.of(
                Arbitraries.of(true, false).map(v -> new Edit.EditWorld<>(SkyAttributes.ON, v)),
                elevations().map(v -> new Edit.EditWorld<>(SkyAttributes.ELEVATION, v)),
                azimuths().map(v -> new Edit.EditWorld<>(SkyAttributes.AZIMUTH, v)),
                turbidities().map(v -> new Edit.EditWorld<>(SkyAttributes.TURBIDITY, v)),
                strengths().map(v -> new Edit.EditWorld<>(SkyAttributes.SUN, v)),
                Arbitraries.of(0.265, 3.0).map(v -> new Edit.EditWorld<>(SkyAttributes.SUN_RADIUS, v)),
                units().map(v -> new Edit.EditWorld<>(SkyAttributes.UNIT, v))));
    }

    private static Arbitrary<Double> elevations() {
        return Arbitraries.of(-18.0, -2.0, 0.0, 12.0, 35.0, 90.0);
    }

    private static Arbitrary<Double> azimuths() {
        return Arbitraries.of(0.0, 60.0, 135.0);
    }

    private static Arbitrary<Double> turbidities() {
        return Arbitraries.of(2.0, 2.0, 2.0, 1.0, 10.0);
    }

    private static Arbitrary<Double> strengths() {
        return Arbitraries.of(1.0, 1.0, 0.0, 20.0);
    }

    private static Arbitrary<SkyUnit> units() {
        return Arbitraries.of(SkyUnit.RELATIVE, SkyUnit.RELATIVE, SkyUnit.NIT);
    }
}
