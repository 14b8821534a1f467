package lightning.sample;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.Lens;
import lightning.scene.value.LensShift;
import lightning.scene.value.Placement;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/**
 * Arbitrary scenes: up to ten nodes, up to six lights, small images of one to four tiles. All are built around the origin and seen from 7
 * units away; some are then scaled or moved far off together with their camera.
 */
public final class SceneArbitraries {
    private SceneArbitraries() {}

    /** Returns any scene. */
    public static Arbitrary<Scene> scenes() {
        Arbitrary<List<Material>> materials = Combinators.combine(MaterialArbitraries.materials("m0"),
                MaterialArbitraries.materials("m1"), MaterialArbitraries.materials("m2")).as(List::of);
        // jqwik shrinks the first component first when a case fails.
        Arbitrary<Scene> alone = Combinators.combine(LightArbitraries.lights().list().ofMinSize(0).ofMaxSize(6), NodeArbitraries.nodes(),
                pictures(), frames(), materials, worlds(), cameras()).as(SceneArbitraries::assemble);
        return Arbitraries.frequencyOf(Tuple.of(2, alone), Tuple.of(1, Combinators.combine(alone, LightArbitraries.lightGroupNames("b0"),
                LightArbitraries.lightGroupNames("b1"), Arbitraries.integers().between(1, 1 << 12)).as(SceneArbitraries::withLightGroups)))
                .map(TestBudget::limit);
    }

    /** @param members two bits for each light: its group, or none */
    private static Scene withLightGroups(Scene scene, LightGroup first, LightGroup second, int members) {
        List<LightGroup> banks = List.of(first, second);
        List<Light> lights = new ArrayList<>();
        for (Light light : scene.lights()) {
            int bank = members >> 2 * lights.size() & 3;
            lights.add(bank < 2 ? light.withLightGroup(banks.get(bank).name()) : light);
        }
        return EdgeCaseScenes.dimmed(scene, LightRig.of(lights, banks));
    }

    /** Scale of the scene and its position in the world. */
    private record CoordinateFrame(Vec3 origin, double unit) {
        Vec3 point(Vec3 p) {
            return origin.plus(p.times(unit));
        }

        Camera camera(Camera camera) {
            Lens lens = camera.lens();
            return camera.withView(point(camera.from()), point(camera.to()), camera.up())
                    .withLens(lens.withAperture(lens.aperture() * unit).withFocus(lens.focus() * unit));
        }

        SceneNode node(SceneNode node) {
            Placement p = node.placement();
            Placement placed = new Placement(point(p.position()), p.rotation(), p.scale().times(unit));
            return switch (node) {
                case Shape s -> s.withPlacement(placed);
                case NodeGroup g -> new NodeGroup(g.name(), placed, g.children());
            };
        }
    }

    private static Scene assemble(List<LightTemplate> seeds, List<SceneNode> nodes, PictureSettings picture, CoordinateFrame frame,
            List<Material> materials, World world, Camera camera) {
        Scene dark = new Scene(picture, frame.camera(camera), world, materials, nodes.stream().map(frame::node).toList(), List.of());
        List<Light> lights = new ArrayList<>();
        for (LightTemplate seed : seeds) {
            lights.add(seed.instantiate(dark, "l" + lights.size()));
        }
        return EdgeCaseScenes.dimmed(dark, LightRig.of(lights));
    }

    private static Arbitrary<CoordinateFrame> frames() {
        Arbitrary<Vec3> far = NumberArbitraries.vectors(-1, 1);
        return Arbitraries.frequencyOf(
                Tuple.of(10, Arbitraries.of(new CoordinateFrame(Vec3.ZERO, 1))),
                Tuple.of(1, far.map(o -> new CoordinateFrame(o.times(1e4), 1))),
                Tuple.of(1, far.map(o -> new CoordinateFrame(o.times(1e9), 1))),
                Tuple.of(1, far.map(o -> new CoordinateFrame(o, 1e-2))),
                Tuple.of(1, far.map(o -> new CoordinateFrame(o.times(1e6), 1e2))));
    }

    private static Arbitrary<Vec3> views() {
        return NumberArbitraries.vectors(NumberArbitraries.range(-3, 3), NumberArbitraries.range(0.5, 4), Arbitraries.of(7.0));
    }

    private static Arbitrary<LensShift> shifts() {
        Arbitrary<Double> shares = NumberArbitraries.range(-0.4, 0.4);
        return Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.of(LensShift.NONE)),
                Tuple.of(1, Combinators.combine(shares, shares).as(LensShift::new)));
    }

    private static Arbitrary<Camera> cameras() {
        return Combinators.combine(views(), shifts(), lenses())
                .as((from, shift, lens) -> new Camera(from, Vec3.ZERO, Vec3.Y, 40, shift, lens));
    }

    /** Returns lenses, most of them pinholes, some larger than the scene. */
    static Arbitrary<Lens> lenses() {
        Arbitrary<Double> apertures = Arbitraries.frequencyOf(Tuple.of(6, NumberArbitraries.range(0, 0.5)),
                Tuple.of(1, Arbitraries.of(1e-12, 10.0, 1e6)));
        Arbitrary<Double> distances = Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(0.0, 1e-9, 1e9)),
                Tuple.of(3, NumberArbitraries.range(0.1, 12)));
        Arbitrary<Lens> open = Combinators.combine(apertures, distances, Arbitraries.of(0, 3, 6, 16), NumberArbitraries.range(-180, 180))
                .as(Lens::new);
        return Arbitraries.frequencyOf(Tuple.of(2, Arbitraries.of(Lens.PINHOLE)), Tuple.of(1, open));
    }

    static Arbitrary<PictureSettings> pictures() {
        Arbitrary<Integer> side = Arbitraries.integers().between(8, 40).withoutEdgeCases();
        return Combinators.combine(side, side, depths(), samplings()).as(PictureSettings::new);
    }

    static Arbitrary<SamplingSettings> samplings() {
        Arbitrary<Integer> grids = Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.of(2, 3)), Tuple.of(1, Arbitraries.of(4, 5, 8)));
        return Arbitraries.frequencyOf(Tuple.of(6, Arbitraries.of(SamplingSettings.DEFAULT)),
                Tuple.of(3, grids.map(grid -> new SamplingSettings(AntialiasMode.EDGES, grid))),
                Tuple.of(1, grids.map(grid -> new SamplingSettings(AntialiasMode.EVERY, grid))));
    }

    static Arbitrary<Integer> depths() {
        return Arbitraries.frequencyOf(Tuple.of(2, Arbitraries.of(0, 1)), Tuple.of(5, Arbitraries.of(2, 3, 4)),
                Tuple.of(1, Arbitraries.integers().between(0, 10).withoutEdgeCases()));
    }

    static Arbitrary<World> worlds() {
        Arbitrary<World> plain =
                Combinators.combine(NumberArbitraries.rangeOrSpecial(0, 1, 0.0, 1.0, 1e6), NumberArbitraries.colors()).as(World::new);
        Arbitrary<World> clear = Arbitraries.frequencyOf(Tuple.of(8, plain),
                Tuple.of(1, Combinators.combine(plain, SkyArbitraries.skies(), domeRotations()).as(
                        (world, sky, turn) -> world.withSky(sky).withOwn(own -> own.withRotation(turn)))),
                Tuple.of(2, Combinators.combine(plain, environmentMaps(), domeRotations(),
                        NumberArbitraries.rangeOrSpecial(0, 2, 0.0, 1.0), Arbitraries.of(4, 5, 7), softnesses(), environmentGains()).as(
                                (world, sky, turn, intensity, lamps, softness, gain) -> world
                                        .withEnvironment(Optional.of(sky)).withOwn(own -> own.withRotation(turn).withIntensity(intensity)
                                                .withLightCount(lamps).withSoftness(softness).withGain(gain)))));
        Arbitrary<World> domed = Arbitraries.frequencyOf(Tuple.of(7, clear),
                Tuple.of(1, Combinators.combine(clear, DomeArbitraries.domes()).as(World::withNamed)));
        return Arbitraries.frequencyOf(Tuple.of(5, domed),
                Tuple.of(2, Combinators.combine(domed, FogArbitraries.fogs()).as(World::withFog)));
    }

    static Arbitrary<Double> environmentGains() {
        return Arbitraries.of(1.0, 1.0, 1.0, 0.0, 0.4, 3.0);
    }

    static Arbitrary<Double> softnesses() {
        return Arbitraries.of(0.0, 0.0, 0.0, 0.3, 1.0);
    }

    static Arbitrary<DomeRotation> domeRotations() {
        return Combinators.combine(rotations(), tilts(), tilts()).as(DomeRotation::of);
    }

    /** Returns rotations about a horizontal axis, half of them 0. */
    static Arbitrary<Double> tilts() {
        return Arbitraries.oneOf(Arbitraries.just(0.0), rotations());
    }

    static Arbitrary<Double> rotations() {
        return NumberArbitraries.rangeOrSpecial(-180, 180, 0.0, 90.0, 360.0);
    }

    /** Returns environment maps of few pixels, some of them black, and maps with suns. */
    static Arbitrary<Environment> environmentMaps() {
        return Arbitraries.frequencyOf(Tuple.of(3, smallMaps()), Tuple.of(1, mapsWithSuns()));
    }

    /** Returns maps with one to three pixels that are lights, in a sky that is not. */
    private static Arbitrary<Environment> mapsWithSuns() {
        return Combinators.combine(Arbitraries.integers().between(0, 24 * 12 - 1).list().ofMinSize(1).ofMaxSize(3),
                NumberArbitraries.range(0, 1), NumberArbitraries.range(100, 1e4)).as((suns, sky, sun) -> {
                    float[] rgb = new float[3 * 24 * 12];
                    for (int i = 0; i < rgb.length; i++) {
                        rgb[i] = (float) (double) sky * (1 + i % 7);
                    }
                    suns.forEach(i -> Arrays.fill(rgb, 3 * i, 3 * i + 3, (float) (double) sun));
                    return new Environment("suns.hdr", new EnvironmentMap(24, 12, rgb));
                });
    }

    private static Arbitrary<Environment> smallMaps() {
        return Combinators.combine(Arbitraries.integers().between(1, 6), Arbitraries.integers().between(1, 4))
                .as((w, h) -> new int[] {w, h})
                .flatMap(size -> NumberArbitraries.rangeOrSpecial(0, 2, 0.0, 50.0).array(Double[].class).ofSize(3 * size[0] * size[1])
                        .map(values -> {
                            float[] rgb = new float[values.length];
                            for (int i = 0; i < rgb.length; i++) {
                                rgb[i] = values[i].floatValue();
                            }
                            return new Environment("sample.hdr", new EnvironmentMap(size[0], size[1], rgb));
                        }));
    }
}
