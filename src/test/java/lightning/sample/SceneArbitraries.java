package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.scene.Antialias;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Panorama;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Rig;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Sky;
import lightning.scene.World;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/**
 * Arbitrary scenes: up to ten nodes, up to six lights, small pictures of one to four tiles. All are
 * thought about the origin and seen from 7 units away; some are then enlarged, shrunk or moved far off
 * together with their camera.
 */
public final class SceneArbitraries {
    private SceneArbitraries() {}

    /** Any scene. */
    public static Arbitrary<Scene> scenes() {
        Arbitrary<List<Material>> materials = Combinators.combine(MaterialArbitraries.materials("m0"),
                MaterialArbitraries.materials("m1"), MaterialArbitraries.materials("m2")).as(List::of);
        // What comes first is made plain first when a case fails.
        Arbitrary<Scene> alone = Combinators.combine(LightArbitraries.lights().list().ofMinSize(0).ofMaxSize(6), NodeArbitraries.nodes(),
                pictures(), frames(), materials, worlds(), views()).as(SceneArbitraries::assemble);
        return Arbitraries.frequencyOf(Tuple.of(2, alone), Tuple.of(1, Combinators.combine(alone, LightArbitraries.banks("b0"),
                LightArbitraries.banks("b1"), Arbitraries.integers().between(1, 1 << 12)).as(SceneArbitraries::inBanks)));
    }

    /** @param members two bits for each light: its bank, or none */
    private static Scene inBanks(Scene scene, Bank one, Bank other, int members) {
        List<Bank> banks = List.of(one, other);
        List<Light> lights = new ArrayList<>();
        for (Light light : scene.lights()) {
            int bank = members >> 2 * lights.size() & 3;
            lights.add(bank < 2 ? light.withBank(banks.get(bank).name()) : light);
        }
        return CornerScenes.bright(scene, Rig.of(lights, banks));
    }

    /** The scene's size and where in the world it lies. */
    private record Frame(Vec3 origin, double unit) {
        Vec3 point(Vec3 p) {
            return origin.plus(p.times(unit));
        }

        Node node(Node node) {
            Placement p = node.placement();
            Placement placed = new Placement(point(p.at()), p.rotate(), p.scale().times(unit));
            return switch (node) {
                case Shape s -> s.withPlacement(placed);
                case Group g -> new Group(g.name(), placed, g.children());
            };
        }
    }

    private static Scene assemble(List<LightSeed> seeds, List<Node> nodes, Picture picture, Frame frame,
            List<Material> materials, World world, Vec3 from) {
        Camera camera = new Camera(frame.point(from), frame.point(Vec3.ZERO), Vec3.Y, 40);
        Scene dark = new Scene(picture, camera, world, materials, nodes.stream().map(frame::node).toList(), List.of());
        List<Light> lights = new ArrayList<>();
        for (LightSeed seed : seeds) {
            lights.add(seed.in(dark, "l" + lights.size()));
        }
        return CornerScenes.bright(dark, Rig.of(lights));
    }

    private static Arbitrary<Frame> frames() {
        Arbitrary<Vec3> far = Numbers.vectors(-1, 1);
        return Arbitraries.frequencyOf(
                Tuple.of(10, Arbitraries.of(new Frame(Vec3.ZERO, 1))),
                Tuple.of(1, far.map(o -> new Frame(o.times(1e4), 1))),
                Tuple.of(1, far.map(o -> new Frame(o.times(1e9), 1))),
                Tuple.of(1, far.map(o -> new Frame(o, 1e-2))),
                Tuple.of(1, far.map(o -> new Frame(o.times(1e6), 1e2))));
    }

    private static Arbitrary<Vec3> views() {
        return Numbers.vectors(Numbers.between(-3, 3), Numbers.between(0.5, 4), Arbitraries.of(7.0));
    }

    static Arbitrary<Picture> pictures() {
        Arbitrary<Integer> side = Arbitraries.integers().between(8, 40).withoutEdgeCases();
        return Combinators.combine(side, side, depths(), samplings()).as(Picture::new);
    }

    static Arbitrary<Sampling> samplings() {
        Arbitrary<Integer> grids = Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.of(2, 3)), Tuple.of(1, Arbitraries.of(4, 5, 8)));
        return Arbitraries.frequencyOf(Tuple.of(6, Arbitraries.of(Sampling.DEFAULT)),
                Tuple.of(3, grids.map(grid -> new Sampling(Antialias.EDGES, grid))),
                Tuple.of(1, grids.map(grid -> new Sampling(Antialias.EVERY, grid))));
    }

    static Arbitrary<Integer> depths() {
        return Arbitraries.frequencyOf(Tuple.of(2, Arbitraries.of(0, 1)), Tuple.of(5, Arbitraries.of(2, 3, 4)),
                Tuple.of(1, Arbitraries.integers().between(0, 10).withoutEdgeCases()));
    }

    static Arbitrary<World> worlds() {
        Arbitrary<World> plain = Combinators.combine(Numbers.betweenOr(0, 1, 0.0, 1.0, 1e6), Numbers.colors()).as(World::new);
        return Arbitraries.frequencyOf(Tuple.of(4, plain), Tuple.of(1, Combinators.combine(plain, skies(), rotations(),
                Numbers.betweenOr(0, 2, 0.0, 1.0), Arbitraries.of(4, 5, 7), softnesses()).as(
                        (world, sky, turn, intensity, lamps, softness) -> world
                                .withEnvironment(Optional.of(sky)).withRotation(turn).withIntensity(intensity).withLamps(lamps)
                                .withSoftness(softness))));
    }

    static Arbitrary<Double> softnesses() {
        return Arbitraries.of(0.0, 0.0, 0.0, 0.3, 1.0);
    }

    static Arbitrary<Double> rotations() {
        return Numbers.betweenOr(-180, 180, 0.0, 90.0, 360.0);
    }

    /** Skies of few pixels, black among them. */
    static Arbitrary<Panorama> skies() {
        return Combinators.combine(Arbitraries.integers().between(1, 6), Arbitraries.integers().between(1, 4))
                .as((w, h) -> new int[] {w, h})
                .flatMap(size -> Numbers.betweenOr(0, 2, 0.0, 50.0).array(Double[].class).ofSize(3 * size[0] * size[1]).map(values -> {
                    float[] rgb = new float[values.length];
                    for (int i = 0; i < rgb.length; i++) {
                        rgb[i] = values[i].floatValue();
                    }
                    return new Panorama("sample.hdr", new Sky(size[0], size[1], rgb));
                }));
    }
}
