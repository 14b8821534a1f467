package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.IndirectSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** Arbitrary scenes with indirect light, and edits of them. */
public final class IndirectArbitraries {
    private IndirectArbitraries() {}

    /** Returns settings that take little time in small pictures. */
    static Arbitrary<IndirectSettings> settings() {
        return Combinators.combine(Arbitraries.integers().between(1, 3), Arbitraries.frequencyOf(Tuple.of(5, Arbitraries.of(16)),
                Tuple.of(1, Arbitraries.of(64))), Arbitraries.of(2, 4, 5, 8, 16, 64), Arbitraries.of(true, false))
                .as(IndirectSettings::new);
    }

    /** Returns the scenes of {@link SceneArbitraries} with indirect light and at most four samples per pixel. */
    public static Arbitrary<Scene> scenes() {
        return Combinators.combine(settings(), SceneArbitraries.scenes()).as(IndirectArbitraries::withIndirect).map(TestBudget::limit);
    }

    /** Returns the scenes of {@link SceneArbitraries}, of which a small share has indirect light. */
    public static Arbitrary<Scene> mixedScenes() {
        return Arbitraries.frequencyOf(Tuple.of(11, SceneArbitraries.scenes()), Tuple.of(1, scenes()));
    }

    private static Scene withIndirect(IndirectSettings settings, Scene scene) {
        SamplingSettings sampling = scene.picture().sampling();
        return scene.withPicture(scene.picture().withIndirect(Optional.of(settings))
                .withSampling(
                        sampling.isSupersampled() ? new SamplingSettings(sampling.antialias(), Math.min(sampling.grid(), 2)) : sampling));
    }

    /** Returns the scenes of {@link IndirectScenes} with some random objects among theirs, so that most objects stay after an edit. */
    static Arbitrary<Scene> rooms() {
        return Combinators.combine(Arbitraries.of(List.copyOf(IndirectScenes.all().values())), NodeArbitraries.nodes(),
                MaterialArbitraries.materials("m0"), MaterialArbitraries.materials("m1"), MaterialArbitraries.materials("m2"))
                .as((room, added, m0, m1, m2) -> {
                    List<Material> materials = new ArrayList<>(List.of(m0, m1, m2));
                    materials.addAll(room.materials());
                    List<SceneNode> nodes = new ArrayList<>(room.nodes());
                    added.stream().limit(3).filter(node -> !room.isNameUsed(node.name())).forEach(nodes::add);
                    return TestBudget.limit(room.withMaterials(materials).withNodes(nodes));
                });
    }

    /** Returns these scenes in the light of an environment, half of them without indirect light. */
    static Arbitrary<Scene> roomsWithEnvironment() {
        return Combinators.combine(rooms(), SceneArbitraries.environmentMaps(), settings().optional(0.5),
                DomeArbitraries.domes().optional(0.4)).as(
                        (room, map, indirect, domes) -> room
                                .withWorld(room.world().withEnvironment(Optional.of(map)).withNamed(domes.orElse(List.of())))
                                .withPicture(room.picture().withIndirect(indirect)))
                .map(TestBudget::limit);
    }

    /** Returns sequences of one to eight edits, mostly of the environment. */
    static Arbitrary<List<Edit>> environmentEdits() {
        return Arbitraries.frequencyOf(Tuple.of(4, EditArbitraries.worldEdits()), Tuple.of(3, EditArbitraries.edits()),
                Tuple.of(1, EditArbitraries.objectEdits()), Tuple.of(1, settings().optional(0.5).map(Edit.SetIndirect::new))).list()
                .ofMinSize(1).ofMaxSize(8);
    }

    /** Returns sequences of one to eight edits of objects and their materials. */
    static Arbitrary<List<Edit>> objectEdits() {
        return EditArbitraries.objectEdits().list().ofMinSize(1).ofMaxSize(8);
    }

    /** Returns sequences of one to eight edits; some switch indirect light on or off, or change its settings. */
    static Arbitrary<List<Edit>> edits() {
        return Arbitraries.frequencyOf(Tuple.of(6, EditArbitraries.edits()),
                Tuple.of(1, settings().optional(0.7).map(Edit.SetIndirect::new))).list().ofMinSize(1).ofMaxSize(8);
    }
}
