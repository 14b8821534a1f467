package lightning.sample;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Beam;
import lightning.scene.light.Emission;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Falloff;
import lightning.scene.light.FilterShape;
import lightning.scene.light.Influence;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightFilter;
import lightning.scene.light.LightFlag;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.ColorTemperature;
import lightning.scene.value.Photometry;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** Arbitrary lights of all types, including the values at which the equation changes its form. */
final class LightArbitraries {
    private static final Arbitrary<String> LINKED_NAMES =
            Arbitraries.of("floor", "shell", "n0", "n1", "n1_0", "n2", "n2_1", "n3", "n4", "twin0", "wrap");

    /** Weight of area lights that the camera sees, to 2 that it does not see. */
    private static final int VISIBLE = Integer.getInteger("lightning.test.visible", 1);

    private LightArbitraries() {}

    static Arbitrary<LightTemplate> lights() {
        return Combinators.combine(types(), colors(), intensities(), attenuations(), angles(), dropoffs(),
                Combinators.combine(on(), solo()).as((on, solo) -> new boolean[] {on, solo}), areas())
                .as((type, color, intensity, attenuation, angle, dropoff, shines, area) -> Light.of("l", type).withColor(color)
                        .withIntensity(intensity).withAttenuation(attenuation).withAngle(angle).withDropoff(dropoff)
                        .withOn(shines[0]).withSolo(shines[1]).withArea(area))
                .flatMap(light -> doors().map(light::withDoors)).flatMap(light -> feathers().map(light::withFeather))
                .flatMap(light -> textures().map(light::withTexture)).flatMap(light -> gobos().map(light::withGobo))
                .flatMap(light -> profiles().map(light::withProfile)).flatMap(light -> beams().map(light::withBeam))
                .flatMap(light -> Combinators.combine(emissions(), falloffs()).as((e, f) -> light.withEmission(e).withFalloff(f)))
                .flatMap(light -> rarelyTrue().map(light::withIlluminates)).flatMap(light -> rarelyTrue().map(light::withShadowedBy))
                .flatMap(light -> contributions().map(light::withInfluence))
                .flatMap(light -> flags().map(light::withFlag)).flatMap(light -> filters().map(light::withFilter))
                .flatMap(light -> Combinators.combine(places(), aimPositions()).as((at, aim) -> new LightTemplate(light, at, aim)));
    }

    /** Returns no flag, and flags within the scene, some of which let light pass or are turned edge on. */
    static Arbitrary<LightFlag> flags() {
        Arbitrary<Double> shares = NumberArbitraries.rangeOrSpecial(0, 1, 0.0, 1.0);
        Arbitrary<Double> lengths = NumberArbitraries.rangeOrSpecial(0, 6, 0.0, 1e9);
        return Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.just(LightFlag.NONE)),
                Tuple.of(2, Combinators.combine(positions(), turns(), lengths, lengths, shares, shares)
                        .as((at, rotation, width, height, softness, density) -> new LightFlag(true, at, rotation, width, height, softness,
                                density))));
    }

    /** Returns no filter, and filters within the scene. */
    static Arbitrary<LightFilter> filters() {
        Arbitrary<Double> shares = NumberArbitraries.rangeOrSpecial(0, 1, 0.0, 1.0);
        Arbitrary<Double> lengths = NumberArbitraries.rangeOrSpecial(0, 6, 0.0, 1e9);
        return Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.just(LightFilter.NONE)),
                Tuple.of(2, Combinators.combine(Arbitraries.of(FilterShape.class), positions(), turns(),
                        Combinators.combine(lengths, lengths, lengths).as(Vec3::new), shares, shares, Arbitraries.of(true, false))
                        .as(LightFilter::new)));
    }

    private static Arbitrary<Vec3> positions() {
        Arbitrary<Double> near = NumberArbitraries.rangeOrSpecial(-4, 4, 0.0, 1e12);
        return Combinators.combine(near, near, near).as(Vec3::new);
    }

    private static Arbitrary<Vec3> turns() {
        Arbitrary<Double> angles = NumberArbitraries.rangeOrSpecial(-180, 180, 0.0, 90.0);
        return Arbitraries.oneOf(Arbitraries.just(Vec3.ZERO), Combinators.combine(angles, angles, angles).as(Vec3::new));
    }

    static Arbitrary<LightType> types() {
        return Arbitraries.of(LightType.class);
    }

    static Arbitrary<Rgb> colors() {
        return Arbitraries.frequencyOf(Tuple.of(9, NumberArbitraries.colors()),
                Tuple.of(1, NumberArbitraries.colors().map(c -> c.times(1000))));
    }

    static Arbitrary<Double> intensities() {
        return Arbitraries.frequencyOf(Tuple.of(6, NumberArbitraries.range(0, 3)), Tuple.of(2, Arbitraries.of(1.0)),
                Tuple.of(1, Arbitraries.of(0.0, 1e-45, 1e-300, 1e6, 1e22, 1e30)));
    }

    /** Returns exposures, units and temperatures, half of them neutral. */
    static Arbitrary<Emission> emissions() {
        Arbitrary<Double> exposures = Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(0.0)), Tuple.of(3, NumberArbitraries.range(-4, 4)),
                Tuple.of(1, Arbitraries.of(-64.0, 64.0, 1.0)));
        Arbitrary<Double> temperatures = Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(ColorTemperature.NEUTRAL)),
                Tuple.of(1, NumberArbitraries.range(ColorTemperature.MIN, ColorTemperature.MAX)));
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(Emission.DEFAULT)),
                Tuple.of(3, Combinators.combine(exposures, Arbitraries.of(IntensityUnit.class), temperatures).as(Emission::new)));
    }

    static Arbitrary<Falloff> falloffs() {
        return Arbitraries.frequency(Tuple.of(2, Falloff.CUSTOM), Tuple.of(1, Falloff.INVERSE_SQUARE));
    }

    static Arbitrary<Attenuation> attenuations() {
        Arbitrary<Double> factor = NumberArbitraries.rangeOrSpecial(0, 1, 0.0, 1.0);
        return Arbitraries.frequencyOf(
                Tuple.of(2, Arbitraries.of(Attenuation.NONE, new Attenuation(0, 0, 0))),
                Tuple.of(1, Arbitraries.of(new Attenuation(0, 1, 1), new Attenuation(0.1, 1, 0.1), new Attenuation(0, 0, 1),
                        new Attenuation(1e30, 0, 1e30), new Attenuation(0, 1e-30, 0))),
                Tuple.of(3, Combinators.combine(factor, factor, factor).as(Attenuation::new)));
    }

    static Arbitrary<Double> angles() {
        return Arbitraries.frequencyOf(Tuple.of(4, NumberArbitraries.range(5, 60)), Tuple.of(1, NumberArbitraries.range(0, 180)),
                Tuple.of(1, Arbitraries.of(0.0, 1e-3, 90.0, 180.0)));
    }

    static Arbitrary<Double> dropoffs() {
        return Arbitraries.frequencyOf(Tuple.of(2, Arbitraries.of(0.0)), Tuple.of(3, NumberArbitraries.range(0, 12)),
                Tuple.of(1, Arbitraries.of(1.0, 2.0, 0.5, 1e-9, 1e4, 1e6)));
    }

    /** Returns doors that are open, at angles within a cone, beyond its axis, and shut. */
    static Arbitrary<BarnDoors> doors() {
        Arbitrary<Double> door = NumberArbitraries.rangeOrSpecial(-20, 40, 90.0, 90.0, 0.0, -90.0);
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(BarnDoors.OPEN)),
                Tuple.of(1, Combinators.combine(door, door, door, door).as(BarnDoors::new)));
    }

    /** Returns beams of rectangles and discs, half of them open. */
    static Arbitrary<Beam> beams() {
        Arbitrary<Double> cone = NumberArbitraries.rangeOrSpecial(5, 80, 90.0, 90.0, 0.0, 1e-3);
        Arbitrary<Double> softness = NumberArbitraries.rangeOrSpecial(0, 1, 0.0, 0.0, 1.0, 1e-9);
        Arbitrary<Double> spread = NumberArbitraries.rangeOrSpecial(5, 85, 90.0, 90.0, 1.0, 89.9999);
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(Beam.OPEN)),
                Tuple.of(3, Combinators.combine(cone, softness, spread).as(Beam::new)));
    }

    static Arbitrary<Optional<Gobo>> gobos() {
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(Optional.<Gobo>empty())),
                Tuple.of(1, MaterialArbitraries.images().map(image -> Optional.of(new Gobo("sample.png", image)))));
    }

    /** Returns images on faces, half of them none, some with values above 1. */
    static Arbitrary<Optional<LightTexture>> textures() {
        Arbitrary<Texture> bright = Combinators.combine(MaterialArbitraries.images(), Arbitraries.of(3.7f, 1e6f)).as((image, factor) -> {
            float[] rgb = new float[3 * image.width() * image.height()];
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] = factor * image.channel(i / 3 % image.width(), i / 3 / image.width(), i % 3);
            }
            return new Texture(image.width(), image.height(), rgb);
        });
        return Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.of(Optional.<LightTexture>empty())),
                Tuple.of(4, MaterialArbitraries.images().map(image -> Optional.of(new LightTexture("sample.png", image)))),
                Tuple.of(1, bright.map(image -> Optional.of(new LightTexture("sample.hdr", image)))));
    }

    /** Returns profiles of all types and symmetries, with steps and dark directions. */
    static Arbitrary<Optional<IesProfile>> profiles() {
        Arbitrary<Photometry> measured = Arbitraries.of(Photometry.Type.values()).flatMap(type -> Arbitraries.of(type == Photometry.Type.C
                ? List.of(new double[] {0}, new double[] {0, 90}, new double[] {0, 60, 180}, new double[] {0, 90, 200, 360},
                        new double[] {90, 180, 270})
                : List.of(new double[] {0}, new double[] {0, 90}, new double[] {-90, -10, 90})).flatMap(
                        across -> Arbitraries
                                .of(type == Photometry.Type.C
                                        ? List.of(new double[] {0, 20, 20.001, 90}, new double[] {0, 45, 180}, new double[] {90, 180})
                                        : List.of(new double[] {-90, 0, 90}, new double[] {0, 30, 90}))
                                .flatMap(up -> NumberArbitraries.rangeOrSpecial(0, 9, 0.0, 1e-30).array(double[].class)
                                        .ofSize(up.length * across.length)
                                        .filter(c -> Arrays.stream(c).max().orElse(0) > 0).map(c -> new Photometry(type, up, across, c)))));
        return Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(Optional.<IesProfile>empty())),
                Tuple.of(1, measured.map(p -> Optional.of(new IesProfile("sample.ies", p)))));
    }

    static Arbitrary<Double> feathers() {
        return Arbitraries.frequencyOf(Tuple.of(2, Arbitraries.of(0.0)), Tuple.of(1, NumberArbitraries.rangeOrSpecial(0, 60, 1e-9, 90.0)));
    }

    /** Returns light groups with every kind of master: dark, neutral, slightly dimmed, and very bright. */
    static Arbitrary<LightGroup> lightGroupNames(String name) {
        Arbitrary<Double> masters = Arbitraries.frequencyOf(Tuple.of(4, NumberArbitraries.range(0, 2)),
                Tuple.of(2, Arbitraries.of(0.0, 1.0, 1e-300, 1000.0)));
        Arbitrary<Rgb> gels =
                Arbitraries.frequencyOf(Tuple.of(3, NumberArbitraries.colors()), Tuple.of(2, Arbitraries.of(Rgb.WHITE, Rgb.BLACK)));
        return Combinators.combine(gels, masters, on(), solo()).as((gel, master, on, solo) -> new LightGroup(name, gel, master, on, solo));
    }

    /** Returns names of shapes and groups that scenes of {@link NodeArbitraries} may have. */
    static Arbitrary<ShapeLinks> links() {
        Arbitrary<List<String>> names = LINKED_NAMES.list().ofMinSize(0).ofMaxSize(5);
        return Combinators.combine(Arbitraries.of(true, false), names).as(ShapeLinks::new);
    }

    /** Returns gains on shapes and groups that scenes of {@link NodeArbitraries} may have. */
    static Arbitrary<ShapeGains> gains() {
        Arbitrary<ShapeGains.Entry> entry = Combinators.combine(LINKED_NAMES, gain()).as(ShapeGains.Entry::new);
        return entry.list().ofMinSize(0).ofMaxSize(5).uniqueElements(ShapeGains.Entry::name).map(ShapeGains::new);
    }

    private static Arbitrary<Double> gain() {
        return Arbitraries.frequencyOf(Tuple.of(4, NumberArbitraries.range(0, 2)), Tuple.of(2, Arbitraries.of(0.0, 1.0, 1e-300, 100.0)));
    }

    /** Returns contributions, most of them without gains and with shadows. */
    static Arbitrary<Influence> contributions() {
        Arbitrary<Double> factor = Arbitraries.frequencyOf(Tuple.of(3, Arbitraries.of(1.0)), Tuple.of(1, gain()));
        Arbitrary<ShapeGains> onShapes = Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.of(ShapeGains.NONE)), Tuple.of(2, gains()));
        return Combinators.combine(Arbitraries.frequency(Tuple.of(9, true), Tuple.of(1, false)), factor, factor, factor, onShapes)
                .as(Influence::new);
    }

    private static Arbitrary<ShapeLinks> rarelyTrue() {
        return Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.of(ShapeLinks.ALL)), Tuple.of(2, links()));
    }

    /** Returns area shapes, half of them points. */
    static Arbitrary<AreaShape> areas() {
        Arbitrary<Double> length = Arbitraries.frequencyOf(Tuple.of(4, Arbitraries.of(0.0)), Tuple.of(3, NumberArbitraries.range(0, 2)),
                Tuple.of(1, NumberArbitraries.range(-9, 9).map(e -> Math.pow(10, e))));
        Arbitrary<Double> spread = Arbitraries.frequencyOf(Tuple.of(4, Arbitraries.of(0.0)), Tuple.of(3, NumberArbitraries.range(0, 15)),
                Tuple.of(1, Arbitraries.of(1e-9, 90.0)));
        Arbitrary<Vec3> up = Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Vec3.Y, new Vec3(0, -1, 0))),
                Tuple.of(1, NumberArbitraries.vectors(-2, 2).filter(v -> v.maxAbs() > 1e-3)));
        return Combinators.combine(Combinators.combine(length, spread, length, length, up, samples()).as(AreaShape::new), visibilities(),
                shapes()).as((area, visibility, shape) -> area.withVisibility(visibility).withShape(shape));
    }

    /** Returns names of shapes that may be lights, of groups and of none. */
    static Arbitrary<String> shapes() {
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.just("")), Tuple.of(6, LINKED_NAMES));
    }

    private static Arbitrary<FaceVisibility> visibilities() {
        return Arbitraries.frequency(Tuple.of(2, FaceVisibility.HIDDEN), Tuple.of(VISIBLE, FaceVisibility.GLOWING));
    }

    static Arbitrary<Integer> samples() {
        return Arbitraries.frequency(Tuple.of(16, 4), Tuple.of(3, 5), Tuple.of(2, 17), Tuple.of(1, 33), Tuple.of(1, 64));
    }

    private static Arbitrary<Boolean> on() {
        return Arbitraries.frequency(Tuple.of(9, true), Tuple.of(1, false));
    }

    private static Arbitrary<Boolean> solo() {
        return Arbitraries.frequency(Tuple.of(19, false), Tuple.of(1, true));
    }

    static Arbitrary<RelativePosition> places() {
        Arbitrary<RelativePosition> above =
                NumberArbitraries.vectors(NumberArbitraries.range(-4, 4), NumberArbitraries.range(1, 6), NumberArbitraries.range(-4, 4))
                        .map(RelativePosition.Near::new);
        return Arbitraries.frequencyOf(
                Tuple.of(8, above),
                Tuple.of(1, NumberArbitraries.vectors(-15, 15).map(RelativePosition.Near::new)),
                Tuple.of(1, Arbitraries.integers().between(0, 9).map(RelativePosition.InShape::new)),
                Tuple.of(1, rows()));
    }

    static Arbitrary<RelativePosition> aimPositions() {
        return Arbitraries.frequencyOf(
                Tuple.of(5, NumberArbitraries.vectors(-2, 2).map(RelativePosition.Near::new)),
                Tuple.of(1, Arbitraries.of(new RelativePosition.Near(Vec3.ZERO))),
                Tuple.of(1, NumberArbitraries.vectors(-20, 20).map(RelativePosition.Near::new)),
                Tuple.of(1, Arbitraries.integers().between(0, 9).map(RelativePosition.InShape::new)),
                Tuple.of(1, rows()));
    }

    private static Arbitrary<RelativePosition> rows() {
        return Combinators.combine(Arbitraries.integers().between(0, 39), Arbitraries.integers().between(0, 39))
                .as(RelativePosition.OnRow::new);
    }
}
