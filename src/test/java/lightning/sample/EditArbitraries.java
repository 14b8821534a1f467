package lightning.sample;

import java.util.List;
import java.util.Optional;
import lightning.scene.LightAttribute;
import lightning.scene.World;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** Arbitrary edits of every kind that the dispatcher knows. */
public final class EditArbitraries {
    private EditArbitraries() {}

    /** One to twelve edits. */
    public static Arbitrary<List<Edit>> sequences() {
        return edits().list().ofMinSize(1).ofMaxSize(12);
    }

    /** One to twelve edits of how strongly lights shine and how they fade. */
    static Arbitrary<List<Edit>> sequencesOfScales() {
        Arbitrary<Edit> edits = Combinators.combine(lights(), scales()).as(Edit.OfLight::new);
        return edits.list().ofMinSize(1).ofMaxSize(12);
    }

    private static Arbitrary<LightChange> scales() {
        return Arbitraries.oneOf(List.of(
                LightArbitraries.colors().map(LightChange.Color::new),
                LightArbitraries.intensities().map(LightChange.Intensity::new),
                LightArbitraries.attenuations().map(LightChange.Fading::new),
                LightArbitraries.dropoffs().map(LightChange.Dropoff::new)));
    }

    static Arbitrary<Edit> edits() {
        return Arbitraries.frequencyOf(Tuple.of(9, single()),
                Tuple.of(1, single().list().ofMinSize(2).ofMaxSize(4).map(Edit.Together::new)));
    }

    private static Arbitrary<Edit> single() {
        return Arbitraries.frequencyOf(
                Tuple.of(24, ofLights()),
                Tuple.of(14, ofMaterials()),
                Tuple.of(8, ofTheList()),
                Tuple.of(5, ofBanks()),
                Tuple.of(6, ofTheWorld()),
                Tuple.of(4, Arbitraries.integers().between(1, 6).map(Edit.Undo::new)),
                Tuple.of(8, ofShapes()),
                Tuple.of(1, ofTheGeometry()));
    }

    private static Arbitrary<Edit> ofLights() {
        return Combinators.combine(lights(), changes()).as(Edit.OfLight::new);
    }

    private static Arbitrary<LightChange> changes() {
        return Arbitraries.oneOf(List.of(
                LightArbitraries.colors().map(LightChange.Color::new),
                LightArbitraries.intensities().map(LightChange.Intensity::new),
                LightArbitraries.attenuations().map(LightChange.Fading::new),
                LightArbitraries.angles().map(LightChange.Angle::new),
                LightArbitraries.angles().map(LightChange.Angle::new),
                LightArbitraries.dropoffs().map(LightChange.Dropoff::new),
                LightArbitraries.doors().map(d -> new LightChange.Anew<>(LightAttribute.DOORS, d)),
                LightArbitraries.gobos().map(g -> new LightChange.Anew<>(LightAttribute.GOBO, g)),
                LightArbitraries.profiles().map(p -> new LightChange.Anew<>(LightAttribute.PROFILE, p)),
                LightArbitraries.feathers().map(f -> new LightChange.Anew<>(LightAttribute.FEATHER, f)),
                LightArbitraries.links().map(l -> new LightChange.Anew<>(LightAttribute.ILLUMINATES, l)),
                LightArbitraries.links().map(l -> new LightChange.Anew<>(LightAttribute.ILLUMINATES, l)),
                LightArbitraries.links().map(l -> new LightChange.Anew<>(LightAttribute.SHADOWED_BY, l)),
                LightArbitraries.links().map(l -> new LightChange.Anew<>(LightAttribute.SHADOWED_BY, l)),
                LightArbitraries.types().map(LightChange.Type::new),
                LightArbitraries.areas().map(LightChange.Size::new),
                Arbitraries.of(new LightChange.SwitchOn()),
                Arbitraries.of(new LightChange.SwitchOn()),
                Arbitraries.of(new LightChange.SwitchSolo()),
                LightArbitraries.places().map(LightChange.Move::new),
                LightArbitraries.aims().map(LightChange.Turn::new),
                Arbitraries.of(0.5, 2.0, 1e3).map(LightChange.Lengthen::new),
                AttributeArbitraries.lightChanges()));
    }

    private static Arbitrary<Edit> ofMaterials() {
        return Arbitraries.frequencyOf(
                Tuple.of(12, Combinators.combine(Arbitraries.integers().between(0, 3).withoutEdgeCases(), MaterialArbitraries.changes())
                        .as(Edit.OfMaterial::new)),
                Tuple.of(1, Arbitraries.of(new Edit.UnusedMaterial())),
                Tuple.of(1, MaterialArbitraries.changes().map(Edit.OwnDefault::new)));
    }

    private static Arbitrary<Edit> ofTheList() {
        return Arbitraries.oneOf(List.of(
                Combinators.combine(lights(), LightArbitraries.lights()).as(Edit.Add::new),
                Combinators.combine(lights(), lights()).as(Edit.Duplicate::new),
                lights().map(Edit.Delete::new),
                lights().map(Edit.Rename::new),
                Combinators.combine(lights(), lights()).as(Edit.SwapNames::new),
                Combinators.combine(lights(), lights()).as(Edit.Reorder::new)));
    }

    private static Arbitrary<Edit> ofBanks() {
        return Arbitraries.oneOf(List.of(
                Combinators.combine(lights(), Arbitraries.integers().between(0, 2)).as(Edit.Join::new),
                Combinators.combine(lights(), LightArbitraries.banks("fresh")).as(Edit.OfBank::new),
                Combinators.combine(lights(), LightArbitraries.banks("fresh")).as(Edit.OfBank::new),
                lights().map(Edit.DropBank::new),
                lights().map(Edit.RenameBank::new)));
    }

    private static Arbitrary<Edit> ofTheWorld() {
        return Arbitraries.oneOf(List.of(
                Numbers.betweenOr(0, 1, 0.0, 1e6).map(v -> new Edit.OfWorld<>(World.AMBIENCE, v)),
                Numbers.colors().map(v -> new Edit.OfWorld<>(World.BACKGROUND, v)),
                SceneArbitraries.skies().map(s -> new Edit.Surround(Optional.of(s))),
                Arbitraries.of(new Edit.Surround(Optional.empty())),
                SceneArbitraries.rotations().map(v -> new Edit.OfWorld<>(World.ROTATION, v)),
                SceneArbitraries.softnesses().map(v -> new Edit.OfWorld<>(World.SOFTNESS, v)),
                Numbers.betweenOr(0, 2, 0.0, 1.0).map(v -> new Edit.OfWorld<>(World.INTENSITY, v)),
                SceneArbitraries.depths().map(Edit.Depth::new),
                SceneArbitraries.depths().map(Edit.Depth::new)));
    }

    private static Arbitrary<Edit> ofTheGeometry() {
        return Arbitraries.oneOf(List.of(
                Combinators.combine(sides(), sides()).as(Edit.Size::new),
                SceneArbitraries.samplings().map(Edit.Sample::new),
                Numbers.between(-0.3, 0.3).map(Edit.Orbit::new),
                nodes().map(Edit.RemoveNode::new),
                Combinators.combine(nodes(), Arbitraries.of(NodeArbitraries.MATERIALS)).as(Edit.Assign::new)));
    }

    private static Arbitrary<Edit> ofShapes() {
        return Arbitraries.frequencyOf(
                Tuple.of(10, Combinators.combine(nodes(), NodeArbitraries.changes()).as(Edit.OfNode::new)),
                Tuple.of(1, nodes().map(Edit.RemoveNode::new)),
                Tuple.of(1, Combinators.combine(nodes(), nodes()).as(Edit.DuplicateNode::new)),
                Tuple.of(1, Combinators.combine(nodes(), nodes()).as(Edit.SwapNodes::new)),
                Tuple.of(2, Combinators.combine(nodes(), Arbitraries.of(true, false)).as(Edit.Wrap::new)));
    }

    private static Arbitrary<Integer> nodes() {
        return Arbitraries.integers().between(0, 12).withoutEdgeCases();
    }

    private static Arbitrary<Integer> sides() {
        return Arbitraries.integers().between(8, 40).withoutEdgeCases();
    }

    private static Arbitrary<Integer> lights() {
        return Arbitraries.integers().between(0, 6).withoutEdgeCases();
    }
}
